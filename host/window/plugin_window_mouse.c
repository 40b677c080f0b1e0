/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "window/drum_picture.h"
#include "window/picture.h"
#include "window/plugin_window_state.h"

static const double LEAST_SPEED = 0.5, MOST_SPEED = 12.0; /* [m/s] */
static const double SPEED_STEP = 1.1892;                  /* 1.5 dB a notch */
static const double LEAST_WAY = 0.011,
                    MOST_WAY = 10;   /* of a microphone from the nearest head [m] */
static const double WAY_STEP = 0.06; /* of this way, a notch */

static double scale_of(const PluginWindow *window) {
  return painting_scale(window->width, window->height);
}

static WindowPlace place_at(const PluginWindow *window, double x, double y) {
  return picture_place(&window->scene, scale_of(window), x, y);
}

/* ---- strokes -------------------------------------------------------------------------------- */

/* A kit's drum lights up when the audio thread tells of the stroke. */
void plugin_window_strike(PluginWindow *window, const WindowPlace *place) {
  const PluginWindowShell *const shell = &window->shell;
  WindowScene *const scene = &window->scene;
  const WindowStroke stroke = {place->number, scene->speed, place->radius, place->angle};
  const TaborStrikeDef *const usual = &window->definition->drum.strike;
  const bool is_placed = place->radius >= 0 || scene->is_kit;
  scene->struck[0] = is_placed ? place->radius : usual->radius / scene->radius;
  scene->struck[1] = is_placed ? place->angle : usual->angle;
  scene->glow[place->number] = 1;
  if (!shell->instrument->is_open) return;
  (void)spsc_queue_push(&shell->instrument->window.strokes, &stroke);
  shell->play(shell->shell);
}

void plugin_window_change_speed(PluginWindow *window, int steps) {
  const double speed = window->scene.speed * (steps > 0 ? SPEED_STEP : 1 / SPEED_STEP);
  window->scene.speed = fmin(fmax(speed, LEAST_SPEED), MOST_SPEED);
}

/* ---- microphones ---------------------------------------------------------------------------- */

static void move_mic(PluginWindow *window, uint32_t number, const WindowMic *to) {
  TaborDrumDef *const drum = &window->definition->drum;
  if (number >= window->scene.mic_count) return;
  plugin_window_note_looks(window);
  TaborMicDef *const mic = &drum->mic[number];
  mic->radius = to->radius;
  mic->angle = to->angle;
  mic->height = to->height;
  plugin_window_redefine(window, "a microphone's place");
}

/* Between the ends of its part of space: above the drum, in it, or below it. */
static double raised(const WindowScene *scene, double height, int steps) {
  const double bottom = scene->depth > 0 ? -scene->depth : 0;
  const double away = fmin(fabs(height), fabs(height - bottom));
  const double to = height + steps * WAY_STEP * away;
  if (height > 0) return fmin(fmax(to, LEAST_WAY), MOST_WAY);
  if (height > bottom) return fmin(fmax(to, bottom + LEAST_WAY), -LEAST_WAY);
  return fmin(fmax(to, -MOST_WAY), bottom - LEAST_WAY);
}

static void raise_mic(PluginWindow *window, uint32_t number, int steps) {
  WindowScene *const scene = &window->scene;
  WindowMic to = scene->mics[number];
  to.height = raised(scene, to.height, steps);
  scene->mic = number;
  move_mic(window, number, &to);
}

/* ---- buttons and messages ------------------------------------------------------------------- */

static void push_button(PluginWindow *window, Button button) {
  switch (button) {
  case BUTTON_BEFORE: plugin_window_step(window, -1); break;
  case BUTTON_NEXT: plugin_window_step(window, 1); break;
  case BUTTON_COMPARE: history_compare(&window->history); break;
  case BUTTON_UNDO: history_undo(&window->history); break;
  case BUTTON_REDO: history_redo(&window->history); break;
  case BUTTON_PAGE: plugin_window_list(window, LIST_PAGES); break;
  case BUTTON_SOUNDS: plugin_window_list(window, LIST_SOUNDS); break;
  case BUTTON_COUNT: break;
  }
}

static void explain_change(PluginWindow *window, const char *verb, const char *name,
                           const char *keys) {
  if (name) plugin_window_say(window, false, "%s: %s (%s)", verb, name, keys);
}

static void explain_button(PluginWindow *window, Button button) {
  static const char *const texts[BUTTON_COUNT] = {
    [BUTTON_BEFORE] = "the sound before (,)",
    [BUTTON_NEXT] = "the next sound (.)",
    [BUTTON_COMPARE] = "the other of two settings, to compare (C)",
    [BUTTON_PAGE] = "pages of controls, and of all parameters (P)",
    [BUTTON_SOUNDS] = "all sounds (L); W saves this one under a name of your own"};
  if (button == BUTTON_UNDO) {
    explain_change(window, "take back", history_undo_name(&window->history), "Ctrl-Z");
  } else if (button == BUTTON_REDO) {
    explain_change(window, "make again", history_redo_name(&window->history), "Ctrl-Y");
  } else if (texts[button]) {
    plugin_window_say(window, false, "%s", texts[button]);
  }
}

static void explain(PluginWindow *window, const WindowPlace *place) {
  const WindowScene *const scene = &window->scene;
  switch (place->part) {
  case WINDOW_BUTTON: explain_button(window, place->button); break;
  case WINDOW_CONTROL:
    if (scene->controls[place->number].comment)
      plugin_window_say(window, false, "%s", scene->controls[place->number].comment);
    break;
  case WINDOW_VALUE: plugin_window_say(window, false, "click to type a value"); break;
  case WINDOW_MUTE: plugin_window_say(window, false, "mute: not heard (M)"); break;
  case WINDOW_SOLO: plugin_window_say(window, false, "solo: heard alone (S)"); break;
  case WINDOW_LIST:
    if (place->line) plugin_window_say(window, false, "%s", place->line->text);
    break;
  default: break;
  }
}

/* ---- the mouse ------------------------------------------------------------------------------ */

static void take_mic(PluginWindow *window, uint32_t number) {
  window->scene.mic = number;
  window->holds_mic = true;
  window->has_moved = false;
  window->held = window->scene.mics[number];
}

static void take_line(PluginWindow *window, const WindowPlace *place) {
  if (!place->line) return;
  if (place->is_star) {
    plugin_window_star(window, place->line);
  } else {
    plugin_window_choose(window, place->line);
  }
}

static void take_control(PluginWindow *window, uint32_t control, double x, NativeTouch touch) {
  if (touch.is_again) {
    plugin_window_reset_control(window, control);
  } else {
    plugin_window_take_control(window, control, x, touch);
  }
}

/* What was being typed is given up. */
void plugin_window_press(void *context, double x, double y, NativeTouch touch) {
  PluginWindow *const window = context;
  const WindowPlace place = place_at(window, x, y);
  window->typing = TYPING_NOTHING;
  window->scene.focus = WINDOW_NO_CONTROL;
  plugin_window_say(window, false, "%s", "");
  if (place.part != WINDOW_MIC) window->scene.mic = WINDOW_NO_MIC;
  switch (place.part) {
  case WINDOW_DRUM: plugin_window_strike(window, &place); break;
  case WINDOW_MIC: take_mic(window, place.number); break;
  case WINDOW_BUTTON: push_button(window, place.button); break;
  case WINDOW_CONTROL: take_control(window, place.number, x, touch); break;
  case WINDOW_VALUE: plugin_window_type_control(window, place.number); break;
  case WINDOW_MUTE: plugin_window_switch(window, place.number, false); break;
  case WINDOW_SOLO: plugin_window_switch(window, place.number, true); break;
  case WINDOW_LIST: take_line(window, &place); break;
  case WINDOW_NOTHING: break;
  }
}

void plugin_window_drag(void *context, double x, double y, NativeTouch touch) {
  PluginWindow *const window = context;
  const double scale = scale_of(window);
  if (window->holds_mic) {
    drum_picture_move_mic(&window->scene, x / scale, y / scale, &window->held);
    window->has_moved = true;
  }
  plugin_window_drag_control(window, x, touch);
}

void plugin_window_release(void *context) {
  PluginWindow *const window = context;
  plugin_window_release_control(window);
  if (window->has_moved) move_mic(window, window->scene.mic, &window->held);
  window->holds_mic = window->has_moved = false;
}

/* The host's own menu of a control that it knows: automation, MIDI learn. */
void plugin_window_menu(void *context, double x, double y) {
  const PluginWindow *const window = context;
  const WindowPlace place = place_at(window, x, y);
  const bool is_control = place.part == WINDOW_CONTROL || place.part == WINDOW_VALUE;
  if (!is_control || !window->shell.menu) return;
  const WindowControl *const control = &window->scene.controls[place.number];
  if (!control->is_key && !control->is_idle)
    window->shell.menu(window->shell.shell, control->knob, (int)x, (int)y);
}

/* What is wrong stays to be read until something is done. */
void plugin_window_hover(void *context, double x, double y) {
  PluginWindow *const window = context;
  const WindowPlace place = place_at(window, x, y);
  if (window->typing != TYPING_NOTHING || window->scene.is_alarm) return;
  plugin_window_say(window, false, "%s", "");
  explain(window, &place);
}

/* Over a drum it changes how fast the next strokes are. */
void plugin_window_scroll(void *context, double x, double y, int steps, NativeTouch touch) {
  PluginWindow *const window = context;
  const WindowPlace place = place_at(window, x, y);
  if (window->holds_mic || window->typing != TYPING_NOTHING) return;
  switch (place.part) {
  case WINDOW_DRUM: plugin_window_change_speed(window, steps); break;
  case WINDOW_MIC: raise_mic(window, place.number, steps); break;
  case WINDOW_VALUE:
  case WINDOW_CONTROL:
    plugin_window_turn_control(window, place.number, steps, touch.is_fine);
    break;
  case WINDOW_LIST: list_view_scroll(&window->list, steps); break;
  case WINDOW_BUTTON:
    if (place.button == BUTTON_PAGE && !window->scene.list)
      control_pages_turn(&window->pages, -steps);
    break;
  default: break;
  }
}
