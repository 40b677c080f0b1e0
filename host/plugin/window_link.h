/* SPDX-License-Identifier: MIT */
/**
 * @file window_link.h
 * What passes between the window of an instance and its audio thread.
 *
 * Strokes go through a queue, and the look of the drum through one TaborView that both threads pass to and fro: the
 * window lays it into `asked`, the audio thread fills it after its block and lays it into `seen`. So the audio thread
 * neither waits nor allocates, and a window that is closed costs it some loads.
 */
#ifndef TABOR_PLUGIN_WINDOW_LINK_H
#define TABOR_PLUGIN_WINDOW_LINK_H

#include <stdatomic.h>

#include "base/spsc_queue.h"
#include "plugin/plugin_player.h"

/** A stroke of the window: speed [m/s], radius as a part of the head's, angle [deg]. */
typedef struct WindowStroke {
  double velocity, radius, angle;
} WindowStroke;

typedef struct WindowLink {
  SpscQueue strokes; /**< to the audio thread */
  _Atomic(TaborView *) asked, seen;
  atomic_bool is_shown;
  atomic_bool is_stale; /**< the view is of another model than the drum */
  _Atomic float peaks[2];
} WindowLink;

/** MAIN. False if memory is short; window_link_end() is due all the same. */
bool window_link_begin(WindowLink *link);
void window_link_end(WindowLink *link);

/** AUDIO. Lets the strokes of the window act now. */
void window_link_play(WindowLink *link, PluginPlayer *player) REALTIME;
/** AUDIO. Shows the window what was played: @p frames frames of @p outputs. */
void window_link_show(WindowLink *link, const PluginPlayer *player, const PluginOutputs *outputs,
                      uint32_t frames) REALTIME;

#endif
