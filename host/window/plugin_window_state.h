/* SPDX-License-Identifier: MIT */
/* The insides of a window, for plugin_window.c, which opens and closes it, plugin_window_looks.c,
 * which fills its scene, and plugin_window_mouse.c, which acts on what the mouse does. Calls go
 * from the first to the others, and from the last to the second. */
#ifndef TABOR_WINDOW_PLUGIN_WINDOW_STATE_H
#define TABOR_WINDOW_PLUGIN_WINDOW_STATE_H

#include "window/history.h"
#include "window/plugin_window.h"
#include "window/preset_steps.h"
#include "window/window_scene.h"
#include "window/x11_window.h"

struct PluginWindow {
  PluginWindowShell shell;
  uint32_t width, height;
  X11Window *outside; /* NULL while it is closed */
  History history;    /* of InstrumentSetting */
  PresetSteps steps;
  SoundList sounds; /* while scene.sounds leads to it */
  uint32_t page;    /* of controls */
  WindowScene scene;
  bool is_idle[INSTRUMENT_KNOBS]; /* knobs of parts that the drum lacks */

  /* the look of one drum */
  TaborView *view; /* NULL while the audio thread may have it */
  bool has_view;   /* here or there */
  /* of a kit */
  TaborKitDef *kit;     /* that is shown; NULL until there is one */
  float shown;          /* value of its knob */
  unsigned own_version; /* of the user's own kit then */

  /* the mouse */
  bool is_dragging; /* the control `dragged` */
  uint32_t dragged;
  bool holds_mic, has_moved; /* the microphone scene.mic, which is at `held` */
  WindowMic held;
};

/* Notes name, parts, places of the drum or kit. */
void plugin_window_note_looks(PluginWindow *window);
/* Fills the scene for another picture. */
void plugin_window_look(PluginWindow *window);
/* Takes the view back from the audio thread. False: it fills it at this moment. */
bool plugin_window_take_view(PluginWindow *window);
void plugin_window_drop_view(PluginWindow *window);
/* Lends it to the audio thread, once there is one. */
void plugin_window_lend_view(PluginWindow *window);
/* The knob of a control of the page, knob_count if there is none. */
uint32_t plugin_window_knob(const PluginWindow *window, uint32_t control);
const KnobPage *plugin_window_page(const PluginWindow *window);
/* A HistoryNote and a HistoryUse. */
void plugin_window_note(void *window, void *setting);
void plugin_window_use(void *window, const void *setting);

/* What the mouse does: an X11Handler's calls. */
void plugin_window_press(void *window, double x, double y);
void plugin_window_drag(void *window, double x, double y);
void plugin_window_release(void *window);
void plugin_window_scroll(void *window, double x, double y, int steps);

#endif
