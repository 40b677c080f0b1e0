/* SPDX-License-Identifier: MIT */
/* Kit files: refused with a reason of one line, or read into a definition that is checked; every drum of a valid kit can be
 * placed, and is valid there. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/preset_file.h"
#include "fuzz.h"
#include "tabor/kit.h"

static bool set_pair(void *def, const char *section, const char *key, const char *value,
                     unsigned line, char *message, size_t size) {
  (void)line;
  char full[512];
  TaborError error = {.status = TABOR_OK};
  (void)snprintf(full, sizeof full, "%s.%s", section, key ? key : "");
  const TaborStatus status =
    key ? tabor_kit_def_set(def, full, value, &error) : tabor_kit_def_section(def, section, &error);
  if (status == TABOR_OK) return true;
  fuzz_require(error.message[0] != '\0' && !strpbrk(error.message, "\r\n"), "a reason is one line");
  (void)snprintf(message, size, "%s", error.message);
  return false;
}

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
  char message[512];
  fuzz_require(def != NULL, "memory");
  tabor_kit_def_default(def);
  if (preset_file_read(fuzz_file(data, size), set_pair, def, message, sizeof message) ==
        PRESET_FILE_OK &&
      tabor_kit_def_validate(def, NULL) == TABOR_OK) {
    place_all(def);
  }
  free(def);
  return 0;
}
