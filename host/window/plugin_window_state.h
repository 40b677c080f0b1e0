/* SPDX-License-Identifier: MIT */
/* The insides of a window. plugin_window.c opens and closes it; plugin_window_mouse.c and
 * plugin_window_keys.c act on what hands do, by plugin_window_controls.c, which turns controls, and
 * plugin_window_sounds.c, which chooses and saves sounds; plugin_window_looks.c fills its scene.
 * Calls go in this order. */
#ifndef TABOR_WINDOW_PLUGIN_WINDOW_STATE_H
#define TABOR_WINDOW_PLUGIN_WINDOW_STATE_H

#include "base/message.h"
#include "window/control_pages.h"
#include "window/favourites.h"
#include "window/history.h"
#include "window/mixer.h"
#include "window/native_window.h"
#include "window/plugin_window.h"
#include "window/preset_steps.h"
#include "window/window_scene.h"

/** What a window takes back: knobs, and the drum or the user's own kit. */
typedef struct WindowSetting {
  InstrumentSetting setting;
  char *text; /**< of the kit; NULL: it is built in, or this is a drum */
} WindowSetting;

/** Whose list is open. */
typedef enum WindowList { LIST_NONE, LIST_SOUNDS, LIST_PAGES, LIST_KEYS } WindowList;

/** What is typed. */
typedef enum WindowTyping { TYPING_NOTHING, TYPING_VALUE, TYPING_NAME, TYPING_FILE } WindowTyping;

struct PluginWindow {
  PluginWindowShell shell;
  uint32_t width, height;
  NativeWindow *outside; /* NULL while it is closed */
  bool is_updating;      /* a host's menu lets timers act while it is open */
  History history;       /* of WindowSetting */
  PresetSteps steps;
  ListView list; /* while scene.list leads to it */
  WindowList listed;
  Favourites favourites;
  ControlPages pages;
  Mixer mixer;
  WindowScene scene;
  bool is_idle[INSTRUMENT_KNOBS]; /* knobs of parts that the drum lacks */

  Definition *definition;          /* of what plays, with its knobs */
  float defined[INSTRUMENT_KNOBS]; /* where they stood with it */
  unsigned own_version;            /* of the user's own kit then */

  /* the look of one drum */
  TaborView *view; /* NULL while the audio thread may have it */
  bool has_view;   /* here or there */

  /* the mouse */
  bool is_dragging; /* the control `dragged` */
  WindowControl dragged;
  double grip_x, grip_position; /* where it was taken, and where it stood then */
  bool holds_mic, has_moved;    /* the microphone scene.mic, which is at `held` */
  WindowMic held;

  /* the keys */
  LineEditor editor;
  WindowTyping typing;
  bool is_offered;                   /* the first letter takes the place of what stands there */
  char overwritten[TABOR_NAME_SIZE]; /* a file of the user's that the next Enter replaces */
  char turned[DEFINITION_KEY];       /* what was turned last by steps, which undo takes as one */
};

/* ---- plugin_window_looks.c ---- */

/* Notes name, parts, places of the drum or kit. */
void plugin_window_note_looks(PluginWindow *window);
/* Fills the scene for another picture. */
void plugin_window_look(PluginWindow *window);
/* Takes the view back from the audio thread. False: it fills it at this moment. */
bool plugin_window_take_view(PluginWindow *window);
void plugin_window_drop_view(PluginWindow *window);
/* Lends it to the audio thread, once there is one. */
void plugin_window_lend_view(PluginWindow *window);
/* A HistoryNote, a HistoryUse and a HistoryDrop. */
void plugin_window_note(void *window, void *setting);
void plugin_window_use(void *window, const void *setting);
void plugin_window_forget(void *setting);
/* Says something in the line of messages; with `is_alarm`, what is wrong. */
PRINTF_AT(3, 4)
void plugin_window_say(PluginWindow *window, bool is_alarm, const char *format, ...);

/* ---- plugin_window_controls.c ---- */

/* By the mouse, at x in pixels. */
void plugin_window_take_control(PluginWindow *window, uint32_t control, double x,
                                NativeTouch touch);
void plugin_window_drag_control(PluginWindow *window, double x, NativeTouch touch);
void plugin_window_release_control(PluginWindow *window);
/* By steps. */
void plugin_window_turn_control(PluginWindow *window, uint32_t control, int steps, bool is_fine);
/* To its default. */
void plugin_window_reset_control(PluginWindow *window, uint32_t control);
/* Begins to type a value, and takes it. */
void plugin_window_type_control(PluginWindow *window, uint32_t control);
void plugin_window_take_typed(PluginWindow *window, uint32_t control, const char *text);
/* Mute or solo of a level, on or off. */
void plugin_window_switch(PluginWindow *window, uint32_t control, bool is_solo);
/* Puts a changed definition in the place of what plays, as a change called `name`. */
void plugin_window_redefine(PluginWindow *window, const char *name);

/* ---- plugin_window_sounds.c ---- */

/* Opens a list, or closes it if it is open. */
void plugin_window_list(PluginWindow *window, WindowList list);
/* An entry of the open list is chosen, or its star. */
void plugin_window_choose(PluginWindow *window, const ListLine *line);
void plugin_window_star(PluginWindow *window, const ListLine *line);
/* The sound after this one, or before it. */
void plugin_window_step(PluginWindow *window, int steps);
/* Asks for a name to save the sound by, and saves it. */
void plugin_window_ask_name(PluginWindow *window);
void plugin_window_save(PluginWindow *window, const char *name);
/* Asks for the path of a drum's or a kit's file, and takes it. */
void plugin_window_ask_file(PluginWindow *window);
void plugin_window_open_file(PluginWindow *window, const char *path);

/* ---- hands: a NativeHandler's calls ---- */

void plugin_window_press(void *window, double x, double y, NativeTouch touch);
void plugin_window_drag(void *window, double x, double y, NativeTouch touch);
void plugin_window_release(void *window);
void plugin_window_menu(void *window, double x, double y);
void plugin_window_hover(void *window, double x, double y);
void plugin_window_scroll(void *window, double x, double y, int steps, NativeTouch touch);
void plugin_window_key(void *window, Key key, bool has_shift);
/* Strokes at the scene's speed. */
void plugin_window_strike(PluginWindow *window, const WindowPlace *place);
void plugin_window_change_speed(PluginWindow *window, int steps);

#endif
