/* SPDX-License-Identifier: MIT */
/**
 * @file sound_list.h
 * The list of sounds in a window: what saves and opens them, the favourites, the built-in drums or
 * kits by category, then the user's files, each with what it models.
 */
#ifndef TABOR_WINDOW_SOUND_LIST_H
#define TABOR_WINDOW_SOUND_LIST_H

#include "window/favourites.h"
#include "window/list_view.h"
#include "window/preset_steps.h"

/** Numbers of the two lines above all sounds. */
enum { SOUND_LIST_SAVE = 0x7fffffff, SOUND_LIST_OPEN = SOUND_LIST_SAVE - 1 };

/** MAIN. Fills it with what there is at this moment. */
void sound_list_fill(ListView *list, const InstrumentKind *kind, const Favourites *favourites);
/** MAIN. Where an entry leads to. False if the user has no folder any more. */
bool sound_list_place(const ListLine *line, PresetPlace *place);

#endif
