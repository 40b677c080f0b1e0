/* SPDX-License-Identifier: MIT */
/* Preset files: refused with one line, or a valid definition. */
#include <string.h>

#include "drums/drum_args.h"
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  TaborDrumDef def;
  char message[1000] = "";
  const MessageCapture before = message_capture(message, sizeof message);
  const Outcome outcome = drum_load_preset(fuzz_file(data, size), &def);
  message_release(before);
  if (outcome == OUTCOME_OK) {
    fuzz_require(tabor_drum_def_validate(&def, NULL) == TABOR_OK, "what was read is valid");
  } else {
    fuzz_require(message[0] != '\0', "a refusal has a reason");
  }
  return 0;
}
