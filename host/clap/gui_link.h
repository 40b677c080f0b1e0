/* SPDX-License-Identifier: MIT */
/**
 * @file gui_link.h
 * What passes between the window of an instance and its audio thread.
 *
 * Strokes and turns of controls go through queues, and the look of the drum through one TaborView that both threads pass to
 * and fro: the window lays it into `asked`, the audio thread fills it after its block and lays it into `seen`. So the
 * audio thread neither waits nor allocates, and a window that is closed costs it some loads.
 */
#ifndef TABOR_CLAP_GUI_LINK_H
#define TABOR_CLAP_GUI_LINK_H

#include <clap/clap.h>
#include <stdatomic.h>

#include "base/spsc_queue.h"
#include "plugin/plugin_player.h"

/** A stroke of the window: radius as a part of the head's. */
typedef struct GuiStroke {
  double velocity, radius, angle;
} GuiStroke;

/** A turn of a control: begin, value or end, as CLAP's types of events have it. */
typedef struct GuiTurn {
  uint16_t type;
  clap_id id;
  double value;
} GuiTurn;

typedef struct GuiLink {
  struct Gui *gui;   /**< main thread; NULL until a window is opened */
  SpscQueue strokes; /**< to the audio thread */
  SpscQueue
    turns; /**< to the host: by the audio thread, or by params.flush() while there is none */
  _Atomic(TaborView *) asked, seen;
  atomic_bool is_shown;
  atomic_bool is_stale; /**< the view is of another model than the drum */
  _Atomic float peaks[2];
} GuiLink;

/** MAIN. False if memory is short; gui_link_end() is due all the same. */
bool gui_link_begin(GuiLink *link);
void gui_link_end(GuiLink *link);

/** AUDIO. Lets the strokes of the window act now. */
void gui_link_play(GuiLink *link, PluginPlayer *player) REALTIME;
/** AUDIO. Shows the window what was played: @p frames frames of @p outputs. */
void gui_link_show(GuiLink *link, const PluginPlayer *player, const PluginOutputs *outputs,
                   uint32_t frames) REALTIME;
/** AUDIO or MAIN. Tells the host which controls the window has turned. */
void gui_link_report(GuiLink *link, const clap_output_events_t *events) REALTIME;

#endif
