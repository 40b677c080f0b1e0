/* SPDX-License-Identifier: MIT */
/* Kit files: refused with a reason of one line, or read into a definition that is checked; every drum of a valid kit can be
 * placed, and is valid there. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  TaborKitDef *const def = malloc(sizeof *def);
  const KitFileReader reader = {.def = def};
  char message[512];
  fuzz_require(def != NULL, "memory");
  const PresetFileStatus status =
    kit_file_read(fuzz_file(data, size), &reader, message, sizeof message);
  if (status == PRESET_FILE_OK) {
    if (kit_file_check("kit", def, message, sizeof message)) place_all(def);
  } else {
    fuzz_require(message[0] != '\0' && !strpbrk(message, "\r\n"), "a reason is one line");
  }
  free(def);
  return 0;
}
