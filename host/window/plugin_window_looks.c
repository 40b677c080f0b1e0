/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <sched.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plugin/drum_instrument.h"
#include "plugin/key_name.h"
#include "plugin/key_text.h"
#include "plugin/key_way.h"
#include "plugin/kit_instrument.h"
#include "plugin/kit_knobs.h"
#include "plugin/knob_text.h"
#include "plugin/knobs.h"
#include "window/plugin_window_state.h"

static const double METER_FALL = 0.85; /* a frame */
static const double LOAD_FALL = 0.98;  /* likewise: some two seconds */
static const double BRIGHT = 5;        /* [m/s]: a stroke that lights a drum up */

static Instrument *instrument_of(const PluginWindow *window) { return window->shell.instrument; }

static float value_of(const PluginWindow *window, uint32_t id) {
  return window->shell.value(window->shell.shell, id);
}

/* ---- settings ------------------------------------------------------------------------------- */

static void note_setting(const PluginWindow *window, InstrumentSetting *setting) {
  instrument_note(instrument_of(window), setting);
  for (uint32_t i = 0; i < instrument_of(window)->kind->knob_count; i++)
    setting->values[i] = value_of(window, i);
}

void plugin_window_note(void *context, void *noted) {
  const PluginWindow *const window = context;
  WindowSetting *const setting = noted;
  note_setting(window, &setting->setting);
  if (window->scene.is_kit) setting->text = own_kit_text(kit_instrument_own(instrument_of(window)));
}

void plugin_window_use(void *context, const void *used) {
  PluginWindow *const window = context;
  const InstrumentCalls *const calls = instrument_of(window)->kind->calls;
  const WindowSetting *const setting = used;
  InstrumentSetting taken = setting->setting;
  char message[INSTRUMENT_MESSAGE];
  if (setting->text)
    (void)calls->read(instrument_of(window), setting->text, strlen(setting->text), &taken, message);
  window->shell.use(window->shell.shell, &taken);
  *window->turned = '\0';
  plugin_window_note_looks(window);
}

void plugin_window_forget(void *setting) { free(((WindowSetting *)setting)->text); }

void plugin_window_say(PluginWindow *window, bool is_alarm, const char *format, ...) {
  va_list values;
  va_start(values, format);
  (void)vsnprintf(window->scene.message, sizeof window->scene.message, format, values);
  va_end(values);
  window->scene.is_alarm = is_alarm;
}

/* ---- one drum ------------------------------------------------------------------------------- */

bool plugin_window_take_view(PluginWindow *window) {
  WindowLink *const link = &instrument_of(window)->window;
  if (!window->has_view || window->view) return true;
  window->view = atomic_exchange(&link->seen, NULL);
  if (!window->view) window->view = atomic_exchange(&link->asked, NULL);
  return window->view != NULL;
}

void plugin_window_drop_view(PluginWindow *window) {
  while (!plugin_window_take_view(window)) (void)sched_yield();
  tabor_view_destroy(window->view);
  window->scene.view = window->view = NULL;
  window->has_view = false;
}

/* Of the model that the worker has built last, which the drum soon plays on. */
static void make_view(PluginWindow *window) {
  TaborModel *const model = drum_instrument_model(instrument_of(window));
  if (!model) return;
  window->has_view = tabor_view_create(model, NULL, &window->view, NULL) == TABOR_OK;
  tabor_model_release(model);
}

void plugin_window_lend_view(PluginWindow *window) {
  WindowLink *const link = &instrument_of(window)->window;
  if (!window->has_view || !atomic_load(&link->is_shown)) return;
  window->scene.view = NULL;
  atomic_store(&link->asked, window->view);
  window->view = NULL;
}

static void note_drum(PluginWindow *window, const InstrumentSetting *setting) {
  const Instrument *const instrument = instrument_of(window);
  const TaborDrumDef *const def = &setting->def;
  WindowScene *const scene = &window->scene;
  memcpy(scene->title, def->name, sizeof scene->title);
  scene->radius = def->shell.radius;
  scene->depth = def->two_headed ? def->shell.depth : 0;
  scene->mic_count = def->mic_count;
  for (uint32_t i = 0; i < def->mic_count; i++) {
    const TaborMicDef *const mic = &def->mic[i];
    scene->mics[i] = (WindowMic){.radius = mic->radius, .angle = mic->angle, .height = mic->height};
    memcpy(scene->mics[i].name, mic->name, sizeof mic->name);
  }
  for (uint32_t i = 0; i < instrument->kind->knob_count; i++)
    window->is_idle[i] = !instrument->kind->calls->has_part(setting, i);
}

/* A microphone that is held is where the mouse has it. */
static void look_at_drum(PluginWindow *window) {
  WindowScene *const scene = &window->scene;
  WindowLink *const link = &instrument_of(window)->window;
  if (!window->has_view) make_view(window);
  scene->view = window->view;
  const double speed = (double)atomic_exchange(&link->struck[0], 0);
  if (speed > 0) {
    scene->struck_speed = speed;
    scene->struck[0] = (double)atomic_load(&link->place[0]) / scene->radius;
    scene->struck[1] = (double)atomic_load(&link->place[1]);
    scene->glow[0] = 1;
  }
  if (window->holds_mic && scene->mic < scene->mic_count) scene->mics[scene->mic] = window->held;
  scene->glow[0] *= METER_FALL;
}

/* ---- a kit ---------------------------------------------------------------------------------- */

static void note_kit_drum(const TaborKitDrumDef *drum, WindowDrum *shown) {
  *shown = (WindowDrum){.x = drum->x,
                        .y = drum->y,
                        .height = drum->height,
                        .radius = drum->def.shell.radius,
                        .depth = drum->def.shell.depth,
                        .tilt = drum->tilt,
                        .facing = drum->facing,
                        .is_plate = drum->def.body.kind != TABOR_BODY_DRUM};
  memcpy(shown->name, drum->name, sizeof shown->name);
}

static void note_kit(PluginWindow *window) {
  const TaborKitDef *const kit = &window->definition->kit;
  WindowScene *const scene = &window->scene;
  memcpy(scene->title, kit->name, sizeof scene->title);
  scene->drum_count = kit->drum_count;
  for (uint32_t i = 0; i < scene->drum_count; i++) note_kit_drum(&kit->drum[i], &scene->drums[i]);
  for (uint32_t i = 0; i < KIT_KNOB_DRUMS; i++)
    window->is_idle[KIT_KNOB_LEVEL + i] = window->is_idle[KIT_KNOB_TUNE + i] =
      i >= scene->drum_count;
}

static void look_at_kit(PluginWindow *window) {
  WindowLink *const link = &instrument_of(window)->window;
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    const double speed = (double)atomic_exchange(&link->struck[i], 0);
    window->scene.glow[i] = fmax(METER_FALL * window->scene.glow[i], fmin(speed / BRIGHT, 1));
    if (speed <= 0) continue;
    window->scene.struck_speed = speed;
    window->scene.struck_drum = i;
  }
}

/* ---- controls ------------------------------------------------------------------------------- */

/* A control of a kit's drum has the drum's name. */
static const char *name_of(const PluginWindow *window, uint32_t id) {
  const WindowScene *const scene = &window->scene;
  const uint32_t drum = (id - KIT_KNOB_LEVEL) % KIT_KNOB_DRUMS;
  const bool is_of_drum = scene->is_kit && id >= KIT_KNOB_LEVEL && drum < scene->drum_count &&
                          id < KIT_KNOB_TUNE + KIT_KNOB_DRUMS;
  return is_of_drum ? scene->drums[drum].name : instrument_of(window)->kind->knobs[id].name;
}

static void show_knob(PluginWindow *window, uint32_t id, WindowControl *shown) {
  const InstrumentKind *const kind = instrument_of(window)->kind;
  const Knob *const knob = &kind->knobs[id];
  const KnobRange *const range = &instrument_of(window)->ranges[id];
  const float value = value_of(window, id);
  if (knob->is_level) mixer_note(&window->mixer, kind, id, value);
  const bool is_quiet = window->mixer.is_off[id];
  const double now = knob_decimal(is_quiet ? window->mixer.level[id] : value);
  *shown = (WindowControl){.knob = id,
                           .comment = knob->comment,
                           .position = knob_position(range, now),
                           .is_idle = window->is_idle[id],
                           .is_level = knob->is_level,
                           .is_quiet = is_quiet,
                           .is_mute = window->mixer.is_mute[id],
                           .is_solo = window->mixer.is_solo[id]};
  (void)snprintf(shown->name, WINDOW_TEXT, "%s", name_of(window, id));
  (void)knob_label(knob, range, now, shown->value, WINDOW_TEXT);
  if (shown->is_idle) (void)snprintf(shown->value, WINDOW_TEXT, "-");
}

static void show_key(const PluginWindow *window, const char *key, WindowControl *shown) {
  char value[DEFINITION_VALUE] = "";
  (void)definition_get(window->definition, key, value);
  *shown = (WindowControl){.is_key = true, .parameter = key_parameter(key)};
  shown->comment = shown->parameter ? shown->parameter->text : NULL;
  shown->position = shown->parameter ? key_position(shown->parameter, value) : -1;
  (void)snprintf(shown->key, sizeof shown->key, "%s", key);
  (void)key_title(key, shown->name, WINDOW_TEXT);
  if (shown->parameter) {
    (void)key_text(shown->parameter, value, shown->value, WINDOW_TEXT);
  } else {
    (void)snprintf(shown->value, WINDOW_TEXT, "%.*s", WINDOW_TEXT - 1, value);
  }
}

static void show_controls(PluginWindow *window) {
  WindowScene *const scene = &window->scene;
  const InstrumentKind *const kind = instrument_of(window)->kind;
  const KnobPage *const page = control_pages_knobs(&window->pages);
  const char *key;
  uint32_t id;
  scene->control_count = 0;
  for (uint32_t i = 0; page && (id = instrument_knob_on_page(kind, page, i)) < kind->knob_count;
       i++) {
    if (scene->is_kit && window->is_idle[id]) continue; /* of drums beyond the kit's */
    show_knob(window, id, &scene->controls[scene->control_count++]);
  }
  for (uint32_t i = 0; (key = control_pages_key(&window->pages, i)); i++)
    show_key(window, key, &scene->controls[scene->control_count++]);
  for (uint32_t i = 0; window->is_dragging && window->dragged.is_key && i < scene->control_count;
       i++) {
    if (strcmp(scene->controls[i].key, window->dragged.key) == 0)
      scene->controls[i] = window->dragged;
  }
}

/* ---- all ------------------------------------------------------------------------------------ */

static unsigned own_version(const PluginWindow *window) {
  return window->scene.is_kit ? own_kit_version(kit_instrument_own(instrument_of(window))) : 0;
}

void plugin_window_note_looks(PluginWindow *window) {
  const Instrument *const instrument = instrument_of(window);
  InstrumentSetting setting;
  note_setting(window, &setting);
  memcpy(window->defined, setting.values, sizeof window->defined);
  window->own_version = own_version(window);
  (void)instrument->kind->calls->define(instrument_of(window), &setting, window->definition);
  (void)control_pages_fill(&window->pages, window->definition);
  if (window->scene.is_kit) {
    note_kit(window);
  } else {
    note_drum(window, &setting);
  }
}

/* A knob has moved, or another kit was loaded. */
static bool has_changed(const PluginWindow *window) {
  if (window->own_version != own_version(window)) return true;
  for (uint32_t i = 0; i < instrument_of(window)->kind->knob_count; i++)
    if (window->defined[i] != value_of(window, i)) return true;
  return false;
}

static void show_frame(PluginWindow *window) {
  WindowScene *const scene = &window->scene;
  WindowLink *const link = &instrument_of(window)->window;
  scene->is_second = window->history.is_second;
  scene->can_undo = history_undo_name(&window->history) != NULL;
  scene->can_redo = history_redo_name(&window->history) != NULL;
  scene->page = control_pages_name(&window->pages);
  scene->marked = window->listed == LIST_PAGES ? scene->page : scene->title;
  scene->typed = window->typing == TYPING_NOTHING ? NULL : &window->editor;
  for (uint32_t side = 0; side < 2; side++) {
    const double peak = (double)atomic_exchange(&link->peaks[side], 0);
    scene->meters[side] = fmax(METER_FALL * scene->meters[side], peak);
  }
  const uint32_t quality = scene->is_kit ? (uint32_t)KIT_KNOB_QUALITY : (uint32_t)KNOB_QUALITY;
  scene->is_draft = value_of(window, quality) == 0;
  scene->load = fmax(LOAD_FALL * scene->load, (double)atomic_exchange(&link->load, 0));
}

void plugin_window_look(PluginWindow *window) {
  if (has_changed(window)) plugin_window_note_looks(window);
  if (window->scene.is_kit) {
    look_at_kit(window);
  } else {
    look_at_drum(window);
  }
  show_frame(window);
  show_controls(window);
}
