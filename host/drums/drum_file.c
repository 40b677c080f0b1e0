/* SPDX-License-Identifier: MIT */
#include "drums/drum_file.h"

#include <stdlib.h>

PresetFileStatus drum_file_read(const char *path, TaborDrumDef *def, char *message, size_t size) {
  char *text;
  size_t length;
  TaborError error;
  PresetFileStatus status = preset_file_load(path, &text, &length, message, size);
  if (status == PRESET_FILE_OK && tabor_drum_def_read(def, text, length, &error) != TABOR_OK) {
    status = preset_file_refuse(path, &error, message, size);
  }
  free(text);
  return status;
}
