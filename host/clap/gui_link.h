/* SPDX-License-Identifier: MIT */
/**
 * @file gui_link.h
 * What passes from the window of an instance to the host: the turns of controls. What passes
 * between the window and the audio thread, plugin/window_link.h and plugin/kit_window_link.h have.
 */
#ifndef TABOR_CLAP_GUI_LINK_H
#define TABOR_CLAP_GUI_LINK_H

#include <clap/clap.h>

#include "base/spsc_queue.h"

/** A turn of a control: begin, value or end, as CLAP's types of events have it. */
typedef struct GuiTurn {
  uint16_t type;
  clap_id id;
  double value;
} GuiTurn;

typedef struct GuiLink {
  struct Gui *gui; /**< main thread; NULL until a window is opened */
  SpscQueue
    turns; /**< to the host: by the audio thread, or by params.flush() while there is none */
} GuiLink;

/** Tells of a turn later; a full queue loses it. MAIN. */
void gui_link_turn(GuiLink *link, uint16_t type, clap_id id, double value);
/** MAIN. False if memory is short; gui_link_end() is due all the same. */
bool gui_link_begin(GuiLink *link);
void gui_link_end(GuiLink *link);

/** AUDIO or MAIN. Tells the host which controls the window has turned. */
void gui_link_report(GuiLink *link, const clap_output_events_t *events) REALTIME;

#endif
