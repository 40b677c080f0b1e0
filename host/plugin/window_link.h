/* SPDX-License-Identifier: MIT */
/**
 * @file window_link.h
 * What passes between the window of an instrument and its audio thread.
 *
 * Strokes go through a queue, peaks and what was struck come back, and the look of a drum goes
 * through one TaborView that both threads pass to and fro: the window lays it into `asked`, the
 * audio thread fills it after its block and lays it into `seen`. So the audio thread neither waits
 * nor allocates, and a window that is closed costs it some loads.
 */
#ifndef TABOR_PLUGIN_WINDOW_LINK_H
#define TABOR_PLUGIN_WINDOW_LINK_H

#include <stdatomic.h>
#include <tabor/kit.h>

#include "base/spsc_queue.h"

/** A stroke of the window. */
typedef struct WindowStroke {
  uint32_t drum;        /**< of a kit */
  double velocity;      /**< [m/s] */
  double radius, angle; /**< a part of the head's, or negative: the drum's own place; [deg] */
} WindowStroke;

typedef struct WindowLink {
  SpscQueue strokes; /**< to the audio thread */
  _Atomic(TaborView *) asked, seen;
  atomic_bool is_shown;
  atomic_bool is_stale; /**< the view is of another model than the drum */
  _Atomic float peaks[2];
  _Atomic float
    load; /**< largest computing time of a block as a share of its length, likewise until
                         the window takes it */
  _Atomic float
    struck[TABOR_KIT_DRUMS]; /**< speed of the fastest stroke [m/s] until the window takes it */
  _Atomic float place[2];    /**< of the newest stroke of one drum: [m] from the centre, [deg] */
} WindowLink;

/** MAIN. False if memory is short; window_link_end() is due all the same. */
bool window_link_begin(WindowLink *link);
void window_link_end(WindowLink *link);

struct Instrument;

/** AUDIO. Lets the strokes of the window act now. */
void window_link_play(struct Instrument *instrument) REALTIME;
/** AUDIO. Shows the window what was played: a block of @p frames frames. */
void window_link_show(struct Instrument *instrument, uint32_t frames) REALTIME;

#endif
