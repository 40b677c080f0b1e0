/* SPDX-License-Identifier: MIT */
/* Kit files: refused with a reason of one line, or read into a definition that is checked; every
 * drum of a valid kit can be placed, and is valid there; its text comes back as the same kit. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/definition_text.h"
#include "fuzz.h"
#include "kit/kit_file.h"

static void place_all(const TaborKitDef *def) {
  for (uint32_t i = 0; i < def->drum_count; i++) {
    TaborDrumDef placed;
    TaborError error = {.status = TABOR_OK};
    if (tabor_kit_def_place(def, i, &placed, &error) == TABOR_OK) {
      fuzz_require(tabor_drum_def_validate(&placed, NULL) == TABOR_OK, "a placed drum is valid");
    } else {
      fuzz_require(error.message[0] != '\0', "a refusal has a reason");
    }
  }
}

static void write_and_read(const TaborKitDef *def, TaborTextForm form) {
  TaborError error;
  TaborKitDef *const read = malloc(sizeof *read);
  char *const text = definition_write_kit(def, form, NULL, &error);
  fuzz_require(read != NULL, "memory");
  if (text) {
    const TaborStatus status = tabor_kit_def_read(read, text, strlen(text), &error);
    fuzz_require(status == TABOR_OK, "what was written is read");
    fuzz_require(memcmp(read, def, sizeof *def) == 0, "it comes back as it was");
  } else {
    fuzz_require(error.status == TABOR_ERROR_VALUE, "what no text can hold is refused");
  }
  free(text);
  free(read);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  TaborKitDef *const def = malloc(sizeof *def);
  char message[512];
  fuzz_require(def != NULL, "memory");
  const PresetFileStatus status =
    kit_file_read(fuzz_file(data, size), def, message, sizeof message);
  if (status == PRESET_FILE_OK) {
    if (kit_file_check("kit", def, message, sizeof message)) place_all(def);
    write_and_read(def, TABOR_TEXT_EDIT);
    write_and_read(def, TABOR_TEXT_KEEP);
  } else {
    fuzz_require(message[0] != '\0' && !strpbrk(message, "\r\n"), "a reason is one line");
  }
  free(def);
  return 0;
}
