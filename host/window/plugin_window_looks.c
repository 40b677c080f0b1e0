/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <string.h>

#include "plugin/drum_instrument.h"
#include "plugin/kit_instrument.h"
#include "plugin/kit_knobs.h"
#include "plugin/knob_text.h"
#include "window/plugin_window_state.h"

static const double METER_FALL = 0.85; /* a frame */
static const double BRIGHT = 5;        /* [m/s]: a stroke that lights a drum up */

static Instrument *instrument_of(const PluginWindow *window) { return window->shell.instrument; }

static float value_of(const PluginWindow *window, uint32_t id) {
  return window->shell.value(window->shell.shell, id);
}

/* ---- settings ------------------------------------------------------------------------------- */

void plugin_window_note(void *context, void *noted) {
  const PluginWindow *const window = context;
  InstrumentSetting *const setting = noted;
  instrument_note(instrument_of(window), setting);
  for (uint32_t i = 0; i < instrument_of(window)->kind->knob_count; i++)
    setting->values[i] = value_of(window, i);
}

void plugin_window_use(void *context, const void *setting) {
  PluginWindow *const window = context;
  window->shell.use(window->shell.shell, setting);
  plugin_window_note_looks(window);
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

static void note_drum(PluginWindow *window) {
  const Instrument *const instrument = instrument_of(window);
  WindowScene *const scene = &window->scene;
  InstrumentSetting setting;
  const TaborDrumDef *const def = &setting.def;
  instrument_note(instrument_of(window), &setting);
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
    window->is_idle[i] = !instrument->kind->calls->has_part(&setting, i);
}

/* A microphone that is held is where the mouse has it. */
static void look_at_drum(PluginWindow *window) {
  WindowScene *const scene = &window->scene;
  if (!window->has_view) make_view(window);
  scene->view = window->view;
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
                        .facing = drum->facing};
  memcpy(shown->name, drum->name, sizeof shown->name);
}

/* Where drums stand depends on the kit alone. */
static void note_kit(PluginWindow *window) {
  OwnKit *const own = kit_instrument_own(instrument_of(window));
  const float knob = value_of(window, KIT_KNOB_KIT);
  const unsigned version = own_kit_version(own);
  WindowScene *const scene = &window->scene;
  if (knob == window->shown && version == window->own_version) return;
  window->shown = knob;
  window->own_version = version;
  (void)kit_knob_kit(knob, own, window->kit, NULL); /* built-in ones are there */
  memcpy(scene->title, window->kit->name, sizeof scene->title);
  scene->drum_count = window->kit->drum_count;
  for (uint32_t i = 0; i < scene->drum_count; i++)
    note_kit_drum(&window->kit->drum[i], &scene->drums[i]);
  for (uint32_t i = 0; i < KIT_KNOB_DRUMS; i++)
    window->is_idle[KIT_KNOB_LEVEL + i] = window->is_idle[KIT_KNOB_TUNE + i] =
      i >= scene->drum_count;
}

static void look_at_kit(PluginWindow *window) {
  WindowLink *const link = &instrument_of(window)->window;
  note_kit(window);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    const double lit = fmin((double)atomic_exchange(&link->struck[i], 0) / BRIGHT, 1);
    window->scene.glow[i] = fmax(METER_FALL * window->scene.glow[i], lit);
  }
}

/* ---- controls ------------------------------------------------------------------------------- */

const KnobPage *plugin_window_page(const PluginWindow *window) {
  return instrument_page(instrument_of(window)->kind, window->page);
}

uint32_t plugin_window_knob(const PluginWindow *window, uint32_t control) {
  return instrument_knob_on_page(instrument_of(window)->kind, plugin_window_page(window), control);
}

/* A control of a kit's drum has the drum's name. */
static const char *name_of(const PluginWindow *window, uint32_t id) {
  const WindowScene *const scene = &window->scene;
  const uint32_t drum = (id - KIT_KNOB_LEVEL) % KIT_KNOB_DRUMS;
  const bool is_of_drum = scene->is_kit && id >= KIT_KNOB_LEVEL && drum < scene->drum_count;
  return is_of_drum ? scene->drums[drum].name : instrument_of(window)->kind->knobs[id].name;
}

static void show_control(const PluginWindow *window, uint32_t id, WindowControl *shown) {
  const Knob *const knob = &instrument_of(window)->kind->knobs[id];
  const KnobRange *const range = &instrument_of(window)->ranges[id];
  const double now = knob_decimal(value_of(window, id));
  *shown = (WindowControl){
    .knob = id, .position = knob_position(range, now), .is_idle = window->is_idle[id]};
  (void)snprintf(shown->name, WINDOW_TEXT, "%s", name_of(window, id));
  (void)knob_label(knob, range, now, shown->value, WINDOW_TEXT);
  if (shown->is_idle) (void)snprintf(shown->value, WINDOW_TEXT, "-");
}

/* ---- all ------------------------------------------------------------------------------------ */

void plugin_window_note_looks(PluginWindow *window) {
  if (window->scene.is_kit) {
    note_kit(window);
  } else {
    note_drum(window);
  }
}

void plugin_window_look(PluginWindow *window) {
  WindowScene *const scene = &window->scene;
  WindowLink *const link = &instrument_of(window)->window;
  uint32_t id;
  if (scene->is_kit) {
    look_at_kit(window);
  } else {
    look_at_drum(window);
  }
  scene->is_second = window->history.is_second;
  scene->can_undo = window->history.count > 0;
  (void)snprintf(scene->page, sizeof scene->page, "%s", plugin_window_page(window)->name);
  for (uint32_t side = 0; side < 2; side++) {
    const double peak = (double)atomic_exchange(&link->peaks[side], 0);
    scene->meters[side] = fmax(METER_FALL * scene->meters[side], peak);
  }
  scene->control_count = 0;
  for (uint32_t i = 0;
       (id = plugin_window_knob(window, i)) < instrument_of(window)->kind->knob_count; i++) {
    if (scene->is_kit && window->is_idle[id]) continue; /* of drums beyond the kit's */
    show_control(window, id, &scene->controls[scene->control_count++]);
  }
}
