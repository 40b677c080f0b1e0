/* SPDX-License-Identifier: MIT */
/* Definitions as the plugins save them (drums/definition_text.h): refused with a reason, or valid,
 * and written as they were read. */
#include <stdlib.h>
#include <string.h>

#include "drums/definition_text.h"
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  TaborDrumDef def, again;
  TaborError error = {.status = TABOR_OK};
  if (!definition_read((const char *)data, size, &def, &error)) {
    fuzz_require(error.status != TABOR_OK && error.message[0] != '\0', "a refusal has a reason");
    fuzz_require(strpbrk(error.message, "\r\n") == NULL, "a reason is one line");
    return 0;
  }
  fuzz_require(tabor_drum_def_validate(&def, NULL) == TABOR_OK, "what was read is valid");
  char *const text = definition_write(&def, TABOR_TEXT_KEEP, NULL, NULL);
  fuzz_require(text != NULL, "memory");
  fuzz_require(definition_read(text, strlen(text), &again, &error), "what was written is read");
  char *const second = definition_write(&again, TABOR_TEXT_KEEP, NULL, NULL);
  fuzz_require(second != NULL && strcmp(text, second) == 0, "it comes back as it was");
  free(second);
  free(text);
  return 0;
}
