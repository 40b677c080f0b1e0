/* SPDX-License-Identifier: MIT */
/**
 * @file drum_history.h
 * Changes of a drum that can be undone and redone: whole definitions, so that whatever a change has
 * replaced comes back.
 */
#ifndef TABOR_HOST_DRUM_HISTORY_H
#define TABOR_HOST_DRUM_HISTORY_H

#include <stdbool.h>
#include <stdint.h>
#include <tabor/tabor.h>

#define DRUM_HISTORY 32u /**< changes that are kept */
#define DRUM_KEY_SIZE (2 * TABOR_NAME_SIZE)

/** A drum, and the quality at which it plays. */
typedef struct DrumState {
  TaborDrumDef def;
  uint32_t quality; /**< a TaborQuality */
} DrumState;

/** A change of one key. */
typedef struct DrumChange {
  char key[DRUM_KEY_SIZE];
  DrumState other; /**< before the change; of one that is undone, after it */
} DrumChange;

typedef struct DrumHistory {
  DrumChange changes[DRUM_HISTORY]; /**< the oldest first */
  uint32_t made, count;             /**< the first of them have been made, the others are undone */
} DrumHistory;

void drum_history_clear(DrumHistory *history);
/** Adds a change of @p key to @p before. Forgets those that are undone and, if there is no room,
 * the oldest. */
void drum_history_add(DrumHistory *history, const char *key, const DrumState *before);
/**
 * Undoes the newest change, or redoes the one that was undone last, on the drum *state: writes what
 * it is then to *state, and the change's key. False if there is none.
 */
bool drum_history_undo(DrumHistory *history, DrumState *state, char key[DRUM_KEY_SIZE]);
bool drum_history_redo(DrumHistory *history, DrumState *state, char key[DRUM_KEY_SIZE]);

#endif
