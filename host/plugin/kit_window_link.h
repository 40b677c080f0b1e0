/* SPDX-License-Identifier: MIT */
/**
 * @file kit_window_link.h
 * What passes between the window of a kit and its audio thread: strokes there, peaks and what was struck back. The audio
 * thread neither waits nor allocates, and a window that is closed costs it a load.
 */
#ifndef TABOR_PLUGIN_KIT_WINDOW_LINK_H
#define TABOR_PLUGIN_KIT_WINDOW_LINK_H

#include <stdatomic.h>

#include "base/spsc_queue.h"
#include "plugin/kit_plugin_player.h"

typedef struct KitWindowLink {
  SpscQueue strokes; /**< of KitPluginStroke, to the audio thread */
  atomic_bool is_shown;
  _Atomic float peaks[2];
  _Atomic float
    struck[TABOR_KIT_DRUMS]; /**< speed of the fastest stroke [m/s] until the window takes it */
} KitWindowLink;

/** MAIN. False if memory is short; kit_window_link_end() is due all the same. */
bool kit_window_link_begin(KitWindowLink *link);
void kit_window_link_end(KitWindowLink *link);

/** AUDIO. Lets the strokes of the window act at the beginning of the block. */
void kit_window_link_play(KitWindowLink *link, KitPluginPlayer *player) REALTIME;
/** AUDIO. Shows the window what was played: @p frames frames of @p outputs. */
void kit_window_link_show(KitWindowLink *link, KitPluginPlayer *player,
                          const KitPluginOutputs *outputs, uint32_t frames) REALTIME;

#endif
