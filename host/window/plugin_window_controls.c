/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plugin/choice_text.h"
#include "plugin/key_text.h"
#include "plugin/key_way.h"
#include "plugin/knob_text.h"
#include "window/picture.h"
#include "window/plugin_window_state.h"

static const double FINE = 0.1; /* of a step */

static const WindowControl *control_at(const PluginWindow *window, uint32_t control) {
  const WindowScene *const scene = &window->scene;
  return control < scene->control_count && !scene->controls[control].is_idle
           ? &scene->controls[control]
           : NULL;
}

/* ---- knobs ---------------------------------------------------------------------------------- */

static void begin(PluginWindow *window, uint32_t knob) {
  window->shell.begin(window->shell.shell, knob);
}

static void end(const PluginWindow *window, uint32_t knob) {
  window->shell.end(window->shell.shell, knob);
}

static void turn_knob(PluginWindow *window, uint32_t knob, double value) {
  begin(window, knob);
  window->shell.turn(window->shell.shell, knob, value);
  end(window, knob);
}

static double knob_value_at(const PluginWindow *window, uint32_t id, double position) {
  const Instrument *const instrument = window->shell.instrument;
  const Knob *const knob = &instrument->kind->knobs[id];
  const double step = knob->choices ? 1 : knob->step;
  const double to = knob_at_position(&instrument->ranges[id], position);
  return step > 0 ? step * round(to / step) : to;
}

/* ---- parameters ----------------------------------------------------------------------------- */

void plugin_window_redefine(PluginWindow *window, const char *name) {
  Instrument *const instrument = window->shell.instrument;
  char message[INSTRUMENT_MESSAGE];
  WindowSetting *const changed = calloc(1, sizeof *changed);
  if (!changed) return;
  plugin_window_note(window, changed);
  history_keep(&window->history, name);
  if (instrument->kind->calls->redefine(instrument, window->definition, &changed->setting,
                                        message)) {
    window->shell.use(window->shell.shell, &changed->setting);
  } else {
    history_drop(&window->history);
    plugin_window_say(window, true, "%s", message);
  }
  plugin_window_forget(changed);
  free(changed);
  plugin_window_note_looks(window);
}

static void set_key(PluginWindow *window, const WindowControl *control, const char *value) {
  TaborError error;
  if (definition_set(window->definition, control->key, value, &error)) {
    plugin_window_redefine(window, control->name);
  } else {
    plugin_window_say(window, true, "%s", error.message);
  }
}

/* ---- steps ---------------------------------------------------------------------------------- */

/* One turn by steps, however many, is one change. */
static void keep_turn(PluginWindow *window, const WindowControl *control) {
  char turned[DEFINITION_KEY];
  (void)snprintf(turned, sizeof turned, "%s", control->name);
  if (strcmp(turned, window->turned) != 0) history_keep(&window->history, control->name);
  memcpy(window->turned, turned, sizeof turned);
}

static void turn_key(PluginWindow *window, const WindowControl *control, double way) {
  const TaborParameter *const parameter = control->parameter;
  char value[DEFINITION_VALUE];
  if (!parameter || control->position < 0) return;
  const double to = knob_stepped(control->position, way, key_choices(parameter));
  key_at_position(parameter, to, value, sizeof value);
  set_key(window, control, value);
}

void plugin_window_turn_control(PluginWindow *window, uint32_t number, int steps, bool is_fine) {
  const WindowControl *const control = control_at(window, number);
  const double way = steps * (is_fine ? FINE * KNOB_STEP : KNOB_STEP);
  if (!control || window->is_dragging) return;
  if (control->is_key) {
    turn_key(window, control, way);
    return;
  }
  const Knob *const knob = &window->shell.instrument->kind->knobs[control->knob];
  const uint32_t choices = knob->choices ? choice_count(knob->choices) : 0;
  keep_turn(window, control);
  turn_knob(window, control->knob,
            knob_value_at(window, control->knob, knob_stepped(control->position, way, choices)));
}

/* ---- the mouse ------------------------------------------------------------------------------ */

static void move_to(PluginWindow *window, double position) {
  WindowControl *const control = &window->dragged;
  control->position = fmin(fmax(position, 0), 1);
  if (!control->is_key) {
    window->shell.turn(window->shell.shell, control->knob,
                       knob_value_at(window, control->knob, control->position));
  } else if (control->parameter) {
    char value[DEFINITION_VALUE];
    key_at_position(control->parameter, control->position, value, sizeof value);
    (void)key_text(control->parameter, value, control->value, sizeof control->value);
  }
}

/* With Shift the control stays where it is, and follows slowly. */
void plugin_window_take_control(PluginWindow *window, uint32_t number, double x,
                                NativeTouch touch) {
  const WindowControl *const control = control_at(window, number);
  if (!control || control->position < 0) return;
  window->is_dragging = true;
  window->dragged = *control;
  window->grip_x = x;
  window->grip_position = control->position;
  *window->turned = '\0';
  if (!control->is_key) {
    history_keep(&window->history, control->name);
    begin(window, control->knob);
  }
  if (!touch.is_fine) plugin_window_drag_control(window, x, touch);
}

void plugin_window_drag_control(PluginWindow *window, double x, NativeTouch touch) {
  const double scale = painting_scale(window->width, window->height);
  const double at = picture_position(scale, x), from = picture_position(scale, window->grip_x);
  if (!window->is_dragging) return;
  if (touch.is_fine) {
    move_to(window, window->grip_position + FINE * (at - from));
  } else {
    move_to(window, at);
    window->grip_x = x;
    window->grip_position = window->dragged.position;
  }
}

/* A parameter changes when the hand lets go, since each change builds another drum. */
void plugin_window_release_control(PluginWindow *window) {
  const WindowControl *const control = &window->dragged;
  char value[DEFINITION_VALUE];
  if (!window->is_dragging) return;
  window->is_dragging = false;
  if (!control->is_key) {
    end(window, control->knob);
  } else if (control->parameter) {
    key_at_position(control->parameter, control->position, value, sizeof value);
    set_key(window, control, value);
  }
}

/* ---- defaults and typed values -------------------------------------------------------------- */

/* That of the built-in drum or kit of its name, or the engine's. */
static bool find_default(const PluginWindow *window, const WindowControl *control,
                         char value[DEFINITION_VALUE]) {
  const TaborParameter *const parameter = control->parameter;
  Definition *const built_in = malloc(sizeof *built_in);
  bool is_found = built_in && definition_find_built_in(window->definition, built_in) &&
                  definition_get(built_in, control->key, value);
  free(built_in);
  if (is_found || !parameter || isnan(parameter->fallback)) return is_found;
  if (parameter->type == TABOR_TYPE_CHOICE) {
    (void)choice_text(parameter->choices, (int)parameter->fallback, value, DEFINITION_VALUE);
    return true;
  }
  return snprintf(value, DEFINITION_VALUE, "%.17g", parameter->fallback) > 0;
}

void plugin_window_reset_control(PluginWindow *window, uint32_t number) {
  const WindowControl *const control = control_at(window, number);
  char value[DEFINITION_VALUE];
  if (!control) return;
  *window->turned = '\0';
  if (!control->is_key) {
    history_keep(&window->history, control->name);
    turn_knob(window, control->knob,
              (double)window->shell.instrument->ranges[control->knob].fallback);
  } else if (find_default(window, control, value)) {
    set_key(window, control, value);
  } else {
    plugin_window_say(window, true, "%s: there is no default", control->name);
  }
}

void plugin_window_type_control(PluginWindow *window, uint32_t number) {
  const WindowControl *const control = control_at(window, number);
  if (!control) return;
  line_editor_begin(&window->editor);
  line_editor_replace(&window->editor, 0, control->value);
  window->typing = TYPING_VALUE;
  window->is_offered = true;
  window->scene.typed_at = window->scene.focus = number;
}

static bool read_knob(const Knob *knob, const KnobRange *range, const char *text, double *value) {
  if (!knob->choices) return knob_text_read(knob, range, text, value);
  return choice_find(knob->choices, text, value);
}

static void type_knob(PluginWindow *window, const WindowControl *control, const char *text) {
  const Knob *const knob = &window->shell.instrument->kind->knobs[control->knob];
  const KnobRange *const range = &window->shell.instrument->ranges[control->knob];
  char least[WINDOW_TEXT], most[WINDOW_TEXT];
  double value;
  if (read_knob(knob, range, text, &value)) {
    history_keep(&window->history, control->name);
    turn_knob(window, control->knob, value);
    return;
  }
  (void)knob_label(knob, range, knob_decimal(range->minimum), least, sizeof least);
  (void)knob_label(knob, range, knob_decimal(range->maximum), most, sizeof most);
  if (knob->choices) {
    plugin_window_say(window, true, "%s '%.40s': one of %s", control->name, text, knob->choices);
  } else {
    plugin_window_say(window, true, "%s '%.40s': %s to %s", control->name, text, least, most);
  }
}

static void type_key(PluginWindow *window, const WindowControl *control, const char *text) {
  const TaborParameter *const parameter = control->parameter;
  char now[DEFINITION_VALUE], value[DEFINITION_VALUE];
  if (!parameter) {
    set_key(window, control, text);
  } else if (definition_get(window->definition, control->key, now) &&
             key_text_read(parameter, now, text, value, sizeof value)) {
    set_key(window, control, value);
  } else {
    plugin_window_say(window, true, "%s '%.40s': its unit is %s", control->name, text,
                      *parameter->unit ? parameter->unit : "1");
  }
}

void plugin_window_take_typed(PluginWindow *window, uint32_t number, const char *text) {
  const WindowControl *const control = control_at(window, number);
  if (!control) return;
  *window->turned = '\0';
  if (control->is_key) {
    type_key(window, control, text);
  } else {
    type_knob(window, control, text);
  }
}

/* ---- mute and solo -------------------------------------------------------------------------- */

static void mix(PluginWindow *window) {
  const InstrumentKind *const kind = window->shell.instrument->kind;
  uint32_t id;
  for (uint32_t i = 0; (id = instrument_knob_at(kind, i)) < kind->knob_count; i++) {
    if (!kind->knobs[id].is_level) continue;
    const float value = window->shell.value(window->shell.shell, id);
    const float wanted = mixer_wanted(&window->mixer, kind, id, value);
    if (wanted != value) turn_knob(window, id, (double)wanted);
  }
}

void plugin_window_switch(PluginWindow *window, uint32_t number, bool is_solo) {
  const WindowControl *const control = control_at(window, number);
  if (!control || !control->is_level) return;
  bool *const state = is_solo ? window->mixer.is_solo : window->mixer.is_mute;
  state[control->knob] = !state[control->knob];
  mix(window);
}
