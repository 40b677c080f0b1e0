/* SPDX-License-Identifier: MIT */
#include "window/plugin_window.h"

#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plugin/drum_instrument.h"
#include "plugin/knob_text.h"
#include "window/drum_window.h"
#include "window/history.h"
#include "window/preset_steps.h"
#include "window/window_size.h"

struct PluginWindow {
  PluginWindowShell shell;
  uint32_t width, height;
  DrumWindow *drum; /* NULL while it is closed */
  TaborView *view;  /* NULL while the audio thread may have it */
  bool has_view;    /* here or there */
  char title[WINDOW_TEXT];
  double radius, depth; /* of the drum [m], and its microphones */
  uint32_t mic_count;
  DrumMic mics[TABOR_MAX_MICS];
  bool is_idle[INSTRUMENT_KNOBS]; /* knobs of parts that the drum lacks */
  uint32_t page;                  /* of controls */
  PresetSteps steps;
  History history; /* of InstrumentSetting */
};

/* ---- the view ------------------------------------------------------------------------------- */

/* False: the audio thread fills it at this moment. */
static bool take_view_back(PluginWindow *window) {
  WindowLink *const link = &window->shell.instrument->window;
  if (!window->has_view || window->view) return true;
  window->view = atomic_exchange(&link->seen, NULL);
  if (!window->view) window->view = atomic_exchange(&link->asked, NULL);
  return window->view != NULL;
}

static void drop_view(PluginWindow *window) {
  while (!take_view_back(window)) (void)sched_yield();
  tabor_view_destroy(window->view);
  window->view = NULL;
  window->has_view = false;
}

/* Of the model that the worker has built last, which the drum soon plays on. */
static void make_view(PluginWindow *window) {
  TaborModel *const model = drum_instrument_model(window->shell.instrument);
  if (!model) return;
  window->has_view = tabor_view_create(model, NULL, &window->view, NULL) == TABOR_OK;
  tabor_model_release(model);
}

/* ---- drums ---------------------------------------------------------------------------------- */

static void note_drum(void *context, void *noted) {
  const PluginWindow *const window = context;
  InstrumentSetting *const setting = noted;
  const PluginWindowShell *const shell = &window->shell;
  instrument_note(shell->instrument, setting);
  for (uint32_t i = 0; i < shell->instrument->kind->knob_count; i++)
    setting->values[i] = shell->value(shell->shell, i);
}

/* Name, microphones and parts of the drum. */
static void note_looks(PluginWindow *window) {
  Instrument *const instrument = window->shell.instrument;
  InstrumentSetting setting;
  const TaborDrumDef *const def = &setting.def;
  instrument_note(instrument, &setting);
  _Static_assert(sizeof window->title >= sizeof setting.def.name, "a name is a title");
  memcpy(window->title, def->name, sizeof def->name);
  window->radius = def->shell.radius;
  window->depth = def->two_headed ? def->shell.depth : 0;
  window->mic_count = def->mic_count;
  for (uint32_t i = 0; i < def->mic_count; i++) {
    const TaborMicDef *const mic = &def->mic[i];
    window->mics[i] = (DrumMic){.radius = mic->radius, .angle = mic->angle, .height = mic->height};
    memcpy(window->mics[i].name, mic->name, sizeof mic->name);
  }
  for (uint32_t i = 0; i < instrument->kind->knob_count; i++)
    window->is_idle[i] = !instrument->kind->calls->has_part(&setting, i);
}

static void use_drum(void *context, const void *drum) {
  PluginWindow *const window = context;
  window->shell.use(window->shell.shell, drum);
  note_looks(window);
}

/* ---- what the window shows and does --------------------------------------------------------- */

static const KnobPage *page_of(const PluginWindow *window) {
  return instrument_page(window->shell.instrument->kind, window->page);
}

static uint32_t knob_of(const PluginWindow *window, uint32_t number) {
  return instrument_knob_on_page(window->shell.instrument->kind, page_of(window), number);
}

static void turn_page(void *context) {
  PluginWindow *const window = context;
  window->page++;
  if (!page_of(window)) window->page = 0;
}

static void scene(void *context, DrumWindowScene *shown) {
  const PluginWindow *const window = context;
  memcpy(shown->title, window->title, sizeof shown->title);
  shown->is_second = window->history.is_second;
  shown->can_undo = window->history.count > 0;
  (void)snprintf(shown->page, sizeof shown->page, "%s", page_of(window)->name);
  for (uint32_t side = 0; side < 2; side++)
    shown->peaks[side] = atomic_exchange(&window->shell.instrument->window.peaks[side], 0);
  shown->view = window->view;
  shown->radius = window->radius;
  shown->depth = window->depth;
  shown->mic_count = window->mic_count;
  memcpy(shown->mics, window->mics, sizeof shown->mics);
}

static bool control(void *context, uint32_t number, DrumControl *shown) {
  const PluginWindow *const window = context;
  const Instrument *const instrument = window->shell.instrument;
  const uint32_t id = knob_of(window, number);
  if (id == instrument->kind->knob_count) return false;
  const Knob *const knob = &instrument->kind->knobs[id];
  const KnobRange *const range = &instrument->ranges[id];
  const double now = knob_decimal(window->shell.value(window->shell.shell, id));
  (void)snprintf(shown->name, WINDOW_TEXT, "%s", knob->name);
  (void)knob_label(knob, range, now, shown->value, WINDOW_TEXT);
  shown->position = knob_position(range, now);
  shown->is_idle = window->is_idle[id];
  if (shown->is_idle) (void)snprintf(shown->value, WINDOW_TEXT, "-");
  return true;
}

static void begin(void *context, uint32_t number) {
  PluginWindow *const window = context;
  history_keep(&window->history);
  window->shell.begin(window->shell.shell, knob_of(window, number));
}

static void move(void *context, uint32_t number, double position) {
  PluginWindow *const window = context;
  const Instrument *const instrument = window->shell.instrument;
  const uint32_t id = knob_of(window, number);
  const double value = knob_at_position(&instrument->ranges[id], position);
  const bool is_choice = instrument->kind->knobs[id].choices != NULL;
  window->shell.turn(window->shell.shell, id, is_choice ? round(value) : value);
}

static void end(void *context, uint32_t number) {
  PluginWindow *const window = context;
  window->shell.end(window->shell.shell, knob_of(window, number));
}

static void strike(void *context, double velocity, double radius, double angle) {
  PluginWindow *const window = context;
  const WindowStroke stroke = {.velocity = velocity, .radius = radius, .angle = angle};
  if (!window->shell.instrument->is_open) return;
  (void)spsc_queue_push(&window->shell.instrument->window.strokes, &stroke);
  window->shell.play(window->shell.shell);
}

static void move_mic(void *context, uint32_t number, const DrumMic *to) {
  PluginWindow *const window = context;
  InstrumentSetting setting;
  if (number >= window->mic_count) return;
  history_keep(&window->history);
  note_drum(window, &setting);
  TaborMicDef *const mic = &setting.def.mic[number];
  mic->radius = to->radius;
  mic->angle = to->angle;
  mic->height = to->height;
  use_drum(window, &setting);
}

static void step_preset(void *context, int steps) {
  PluginWindow *const window = context;
  const PresetPlace place =
    preset_steps_take(&window->steps, window->shell.instrument->kind, window->title, steps);
  history_keep(&window->history);
  window->shell.choose(window->shell.shell, place.name, place.is_file);
  note_looks(window);
  preset_steps_note(&window->steps, window->title);
}

static void compare(void *context) { history_compare(&((PluginWindow *)context)->history); }

static void undo(void *context) { history_undo(&((PluginWindow *)context)->history); }

/* ---- sizes ---------------------------------------------------------------------------------- */

static void resize(void *opened, uint32_t width, uint32_t height) {
  PluginWindow *const window = opened;
  window->width = width;
  window->height = height;
  if (window->drum) drum_window_resize(window->drum, width, height);
}

static void size(const void *opened, uint32_t *width, uint32_t *height) {
  const PluginWindow *const window = opened;
  *width = window->width;
  *height = window->height;
}

/* ---- beginning and end ---------------------------------------------------------------------- */

PluginWindow *plugin_window_create(const PluginWindowShell *shell) {
  PluginWindow *const window = calloc(1, sizeof *window);
  if (!window) return NULL;
  window->shell = *shell;
  window->history = (History){
    .size = sizeof(InstrumentSetting), .context = window, .note = note_drum, .use = use_drum};
  if (!history_begin(&window->history)) {
    free(window);
    return NULL;
  }
  window_size(1, &window->width, &window->height);
  note_looks(window);
  return window;
}

static bool open(void *opened, unsigned long parent) {
  PluginWindow *const window = opened;
  const DrumWindowShell shell = {.context = window,
                                 .scene = scene,
                                 .control = control,
                                 .turn_page = turn_page,
                                 .begin = begin,
                                 .move = move,
                                 .end = end,
                                 .strike = strike,
                                 .move_mic = move_mic,
                                 .step_preset = step_preset,
                                 .compare = compare,
                                 .undo = undo};
  if (window->drum) return false;
  note_looks(window);
  window->drum = drum_window_create(parent, window->width, window->height, &shell);
  return window->drum != NULL;
}

static bool is_open(const void *window) { return ((const PluginWindow *)window)->drum != NULL; }

static void close(void *opened) {
  PluginWindow *const window = opened;
  if (!window->drum) return;
  atomic_store(&window->shell.instrument->window.is_shown, false);
  drop_view(window);
  drum_window_destroy(window->drum);
  window->drum = NULL;
}

static void destroy(void *created) {
  PluginWindow *const window = created;
  if (!window) return;
  close(window);
  history_end(&window->history);
  free(window);
}

static void show(void *opened, bool shown) {
  const PluginWindow *const window = opened;
  atomic_store(&window->shell.instrument->window.is_shown, shown);
  drum_window_show(window->drum, shown);
}

static unsigned long id(const void *window) {
  return drum_window_id(((const PluginWindow *)window)->drum);
}

/* The name of the drum changes with a program change, too, of which nobody tells. */
static void update(void *opened) {
  PluginWindow *const window = opened;
  WindowLink *const link = &window->shell.instrument->window;
  if (!window->drum || !take_view_back(window)) return;
  if (window->has_view && atomic_exchange(&link->is_stale, false)) {
    drop_view(window);
    note_looks(window);
  }
  if (!window->has_view) make_view(window);
  drum_window_update(window->drum);
  if (!window->has_view || !atomic_load(&link->is_shown)) return;
  atomic_store(&link->asked, window->view);
  window->view = NULL;
}

const WindowKind plugin_window_kind = {.destroy = destroy,
                                       .resize = resize,
                                       .size = size,
                                       .open = open,
                                       .is_open = is_open,
                                       .close = close,
                                       .id = id,
                                       .show = show,
                                       .update = update};
