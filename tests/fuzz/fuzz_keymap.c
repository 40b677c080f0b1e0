/* SPDX-License-Identifier: MIT */
/* Key files: refused with one line, or a keymap whose every key has an action. */
#include <string.h>

#include "fuzz.h"
#include "ui/keymap.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static Keymap keymap;
  char message[1000] = "", names[2000];
  keymap_default(&keymap);
  const MessageCapture before = message_capture(message, sizeof message);
  const Outcome outcome = keymap_read(fuzz_file(data, size), &keymap);
  message_release(before);
  fuzz_require(outcome == OUTCOME_OK || message[0] != '\0', "a refusal has a reason");
  if (outcome != OUTCOME_OK) return 0;
  for (size_t i = 0; i < keymap.count; i++) {
    const Action action = keymap_find(&keymap, keymap.bindings[i].key);
    fuzz_require(action.text != NULL && strlen(action.text) < ACTION_TEXT_SIZE, "texts fit");
  }
  for (ActionKind kind = ACTION_NONE; kind <= ACTION_QUIT; kind++) {
    (void)keymap_list(&keymap, kind, names, sizeof names);
  }
  return 0;
}
