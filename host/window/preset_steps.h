/* SPDX-License-Identifier: MIT */
/**
 * @file preset_steps.h
 * The order in which a window turns over drums or kits: the built-in ones, then the user's files in
 * their folder (drums/user_presets.h), by name; after the last the first.
 */
#ifndef TABOR_WINDOW_PRESET_STEPS_H
#define TABOR_WINDOW_PRESET_STEPS_H

#include "drums/user_presets.h"
#include "plugin/instrument.h"

typedef struct PresetPlace {
  bool is_file;
  uint32_t number;             /**< of a built-in one */
  char name[USER_PRESET_PATH]; /**< of it, or the path of a file */
} PresetPlace;

/** The file that was taken last, and what it calls itself: while that is shown, it is the one that
 * plays. Begins with zeros. */
typedef struct PresetSteps {
  char file[TABOR_NAME_SIZE]; /**< without extension */
  char title[TABOR_NAME_SIZE];
} PresetSteps;

/** MAIN. The one beside the one that calls itself @p title: after it with a positive @p steps, or
 * before it. Beside one that is neither built in nor of a file there, it is the first or the last
 * built-in one. */
PresetPlace preset_steps_take(PresetSteps *taken, const InstrumentKind *kind, const char *title,
                              int steps);
/** MAIN. A file of the folder was chosen, without extension; "": something else. */
void preset_steps_choose(PresetSteps *taken, const char *file);
/** MAIN. What was taken calls itself @p title. */
void preset_steps_note(PresetSteps *taken, const char *title);

#endif
