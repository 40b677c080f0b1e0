/* SPDX-License-Identifier: MIT */
/**
 * @file sound_list.h
 * The list of sounds in a window: the built-in drums or kits by category, then the user's files,
 * each with what it models. It stands where the controls do.
 */
#ifndef TABOR_WINDOW_SOUND_LIST_H
#define TABOR_WINDOW_SOUND_LIST_H

#include <cairo.h>

#include "window/preset_steps.h"

#define SOUND_LIST_MOST 256 /**< lines; further files are not listed */

/** A line: a category, or a sound below it. */
typedef struct SoundLine {
  bool is_category;
  PresetPlace place;
  char name[TABOR_NAME_SIZE], text[TABOR_TEXT_SIZE];
} SoundLine;

typedef struct SoundList {
  uint32_t count, first; /**< of the lines that are seen, the first */
  SoundLine lines[SOUND_LIST_MOST];
} SoundList;

/** MAIN. Fills it with what there is at this moment, and shows the line of the sound @p title. */
void sound_list_fill(SoundList *list, const InstrumentKind *kind, const char *title);
/** By so many notches of the wheel, up with positive @p steps. */
void sound_list_scroll(SoundList *list, int steps);
/** The sound at a place at scale 1, or NULL. */
const SoundLine *sound_list_at(const SoundList *list, double x, double y);
/** True if the list stands at the place. */
bool sound_list_has(double x, double y);
/** Draws it; the sound @p title is marked. */
void sound_list_draw(const SoundList *list, cairo_t *cairo, const char *title);

#endif
