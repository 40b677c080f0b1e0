/* SPDX-License-Identifier: MIT */
#include "play/drum_history.h"

#include <stdio.h>
#include <string.h>

void drum_history_clear(DrumHistory *history) { history->made = history->count = 0; }

void drum_history_add(DrumHistory *history, const char *key, const DrumState *before) {
  DrumChange *const changes = history->changes;
  if (history->made == DRUM_HISTORY) {
    history->made--;
    memmove(changes, changes + 1, history->made * sizeof *changes);
  }
  DrumChange *const change = &changes[history->made++];
  (void)snprintf(change->key, sizeof change->key, "%s", key);
  change->other = *before;
  history->count = history->made;
}

static void exchange(DrumChange *change, DrumState *state, char key[DRUM_KEY_SIZE]) {
  const DrumState now = *state;
  memcpy(key, change->key, DRUM_KEY_SIZE);
  *state = change->other;
  change->other = now;
}

bool drum_history_undo(DrumHistory *history, DrumState *state, char key[DRUM_KEY_SIZE]) {
  if (history->made == 0) return false;
  exchange(&history->changes[--history->made], state, key);
  return true;
}

bool drum_history_redo(DrumHistory *history, DrumState *state, char key[DRUM_KEY_SIZE]) {
  if (history->made == history->count) return false;
  exchange(&history->changes[history->made++], state, key);
  return true;
}
