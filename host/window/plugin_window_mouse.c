/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "plugin/kit_knobs.h"
#include "window/drum_picture.h"
#include "window/picture.h"
#include "window/plugin_window_state.h"

static const double LEAST_SPEED = 0.5, MOST_SPEED = 12.0; /* [m/s] */
static const double SPEED_STEP = 1.1892;                  /* 1.5 dB a notch */
static const double WHEEL_STEP = 0.02;                    /* of a control's way */
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
static void strike(PluginWindow *window, const WindowPlace *place) {
  const PluginWindowShell *const shell = &window->shell;
  WindowScene *const scene = &window->scene;
  const WindowStroke stroke = {place->number, scene->speed, place->radius, place->angle};
  scene->struck[0] = place->radius;
  scene->struck[1] = place->angle;
  scene->glow[place->number] = 1;
  if (!shell->instrument->is_open) return;
  (void)spsc_queue_push(&shell->instrument->window.strokes, &stroke);
  shell->play(shell->shell);
}

static void change_speed(PluginWindow *window, int steps) {
  const double speed = window->scene.speed * (steps > 0 ? SPEED_STEP : 1 / SPEED_STEP);
  window->scene.speed = fmin(fmax(speed, LEAST_SPEED), MOST_SPEED);
}

/* ---- controls ------------------------------------------------------------------------------- */

static bool can_turn(const PluginWindow *window, uint32_t control) {
  const WindowScene *const scene = &window->scene;
  return control < scene->control_count && !scene->controls[control].is_idle;
}

static void begin(PluginWindow *window, uint32_t knob) {
  history_keep(&window->history);
  window->shell.begin(window->shell.shell, knob);
}

static void end(const PluginWindow *window, uint32_t knob) {
  window->shell.end(window->shell.shell, knob);
}

static void move(const PluginWindow *window, uint32_t id, double position) {
  const Instrument *const instrument = window->shell.instrument;
  const Knob *const knob = &instrument->kind->knobs[id];
  const double step = knob->choices ? 1 : knob->step;
  const double to = knob_at_position(&instrument->ranges[id], position);
  window->shell.turn(window->shell.shell, id, step > 0 ? step * round(to / step) : to);
}

static void turn(PluginWindow *window, uint32_t control, int steps) {
  if (!can_turn(window, control) || window->is_dragging) return;
  const WindowControl *const shown = &window->scene.controls[control];
  begin(window, shown->knob);
  move(window, shown->knob, fmin(fmax(shown->position + WHEEL_STEP * steps, 0), 1));
  end(window, shown->knob);
}

/* ---- microphones ---------------------------------------------------------------------------- */

static void move_mic(PluginWindow *window, uint32_t number, const WindowMic *to) {
  InstrumentSetting setting;
  if (number >= window->scene.mic_count) return;
  history_keep(&window->history);
  plugin_window_note(window, &setting);
  TaborMicDef *const mic = &setting.def.mic[number];
  mic->radius = to->radius;
  mic->angle = to->angle;
  mic->height = to->height;
  plugin_window_use(window, &setting);
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

/* ---- buttons -------------------------------------------------------------------------------- */

/* A built-in kit is a value of its knob, so that the host can record it. Levels and tunings stay
 * with the numbers of drums, as in the host's own list. */
static void choose(PluginWindow *window, const PresetPlace *place) {
  const PluginWindowShell *const shell = &window->shell;
  const uint32_t knob = shell->instrument->kind->main_knob;
  if (window->scene.is_kit && !place->is_file) {
    begin(window, knob);
    shell->turn(shell->shell, knob, (double)place->number);
    end(window, knob);
  } else {
    history_keep(&window->history);
    shell->choose(shell->shell, place->name, place->is_file);
  }
  plugin_window_note_looks(window);
  preset_steps_note(&window->steps, window->scene.title);
}

static void step_preset(PluginWindow *window, int steps) {
  plugin_window_note_looks(window);
  const PresetPlace place =
    preset_steps_take(&window->steps, window->shell.instrument->kind, window->scene.title, steps);
  choose(window, &place);
}

/* The list stays open, so that one sound after the other can be tried. */
static void choose_sound(PluginWindow *window, const SoundLine *sound) {
  const PresetPlace place = sound->place;
  preset_steps_choose(&window->steps, place.is_file ? sound->name : "");
  choose(window, &place);
}

static void open_or_close_sounds(PluginWindow *window) {
  WindowScene *const scene = &window->scene;
  if (!scene->sounds) {
    plugin_window_note_looks(window);
    sound_list_fill(&window->sounds, window->shell.instrument->kind, scene->title);
  }
  scene->sounds = scene->sounds ? NULL : &window->sounds;
}

/* Where the list of sounds is open, the page that it hides comes back first. */
static void turn_page(PluginWindow *window) {
  if (window->scene.sounds) {
    window->scene.sounds = NULL;
    return;
  }
  window->page++;
  if (!plugin_window_page(window)) window->page = 0;
}

static void push_button(PluginWindow *window, Button button) {
  switch (button) {
  case BUTTON_BEFORE: step_preset(window, -1); break;
  case BUTTON_NEXT: step_preset(window, 1); break;
  case BUTTON_COMPARE: history_compare(&window->history); break;
  case BUTTON_UNDO: history_undo(&window->history); break;
  case BUTTON_PAGE: turn_page(window); break;
  case BUTTON_SOUNDS: open_or_close_sounds(window); break;
  case BUTTON_COUNT: break;
  }
}

/* ---- the mouse ------------------------------------------------------------------------------ */

static void take_mic(PluginWindow *window, uint32_t number) {
  window->scene.mic = number;
  window->holds_mic = true;
  window->has_moved = false;
  window->held = window->scene.mics[number];
}

static void take_control(PluginWindow *window, uint32_t control, double x) {
  if (!can_turn(window, control)) return;
  window->is_dragging = true;
  window->dragged = window->scene.controls[control].knob;
  begin(window, window->dragged);
  move(window, window->dragged, picture_position(scale_of(window), x));
}

void plugin_window_press(void *context, double x, double y) {
  PluginWindow *const window = context;
  const WindowPlace place = place_at(window, x, y);
  if (place.part != WINDOW_MIC) window->scene.mic = WINDOW_NO_MIC;
  switch (place.part) {
  case WINDOW_DRUM: strike(window, &place); break;
  case WINDOW_MIC: take_mic(window, place.number); break;
  case WINDOW_BUTTON: push_button(window, place.button); break;
  case WINDOW_CONTROL: take_control(window, place.number, x); break;
  case WINDOW_SOUNDS:
    if (place.sound) choose_sound(window, place.sound);
    break;
  case WINDOW_NOTHING: break;
  }
}

void plugin_window_drag(void *context, double x, double y) {
  PluginWindow *const window = context;
  const double scale = scale_of(window);
  if (window->holds_mic) {
    drum_picture_move_mic(&window->scene, x / scale, y / scale, &window->held);
    window->has_moved = true;
  }
  if (window->is_dragging) move(window, window->dragged, picture_position(scale, x));
}

void plugin_window_release(void *context) {
  PluginWindow *const window = context;
  if (window->is_dragging) end(window, window->dragged);
  if (window->has_moved) move_mic(window, window->scene.mic, &window->held);
  window->is_dragging = window->holds_mic = window->has_moved = false;
}

/* Over a drum it changes how fast the next strokes are. */
void plugin_window_scroll(void *context, double x, double y, int steps) {
  PluginWindow *const window = context;
  const WindowPlace place = place_at(window, x, y);
  if (window->holds_mic) return;
  switch (place.part) {
  case WINDOW_DRUM: change_speed(window, steps); break;
  case WINDOW_MIC: raise_mic(window, place.number, steps); break;
  case WINDOW_CONTROL: turn(window, place.number, steps); break;
  case WINDOW_SOUNDS: sound_list_scroll(&window->sounds, steps); break;
  default: break;
  }
}
