/* SPDX-License-Identifier: MIT */
#include "clap/gui.h"

#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/instance_drum.h"
#include "clap/parameters.h"
#include "clap/presets.h"
#include "window/drum_window.h"

enum { UNDOS = 16, PERIOD = 33 }; /* PERIOD [ms] */
static const double LEAST_SCALE = 0.5, MOST_SCALE = 4;

/** Drum and controls. */
typedef struct Snapshot {
  SavedState saved;
  float values[KNOB_COUNT];
} Snapshot;

typedef struct Gui {
  const clap_host_timer_support_t *timers;
  clap_id timer;
  uint32_t width, height;
  DrumWindow *window; /* NULL until there is a parent */
  TaborView *view;    /* NULL while the audio thread may have it */
  bool has_view;      /* here or there */
  char title[DRUM_WINDOW_TEXT];
  Snapshot undos[UNDOS]; /* the newest last */
  uint32_t undo_count;
  Snapshot other; /* of two drums to compare, the one that does not play */
  bool has_other, is_second;
} Gui;

static Gui *gui_of(const clap_plugin_t *plugin) { return instance_of(plugin)->link.gui; }

/* ---- the view ------------------------------------------------------------------------------- */

/* False: the audio thread fills it at this moment. */
static bool take_view_back(GuiLink *link, Gui *gui) {
  if (!gui->has_view || gui->view) return true;
  gui->view = atomic_exchange(&link->seen, NULL);
  if (!gui->view) gui->view = atomic_exchange(&link->asked, NULL);
  return gui->view != NULL;
}

static void drop_view(GuiLink *link, Gui *gui) {
  while (!take_view_back(link, gui)) (void)sched_yield();
  tabor_view_destroy(gui->view);
  gui->view = NULL;
  gui->has_view = false;
}

/* Of the model that the worker has built last, which the drum soon plays on. */
static void make_view(Instance *instance, Gui *gui) {
  TaborModel *const model = instance->is_open ? model_worker_model(&instance->worker) : NULL;
  if (!model) return;
  gui->has_view = tabor_view_create(model, NULL, &gui->view, NULL) == TABOR_OK;
  tabor_model_release(model);
}

/* ---- drums ---------------------------------------------------------------------------------- */

static void note_drum(Instance *instance, Snapshot *snapshot) {
  instance_save(instance, &snapshot->saved);
  for (uint32_t i = 0; i < KNOB_COUNT; i++) snapshot->values[i] = atomic_load(&instance->values[i]);
}

static void tell_title(Instance *instance, Gui *gui) {
  SavedState saved;
  instance_save(instance, &saved);
  _Static_assert(sizeof gui->title >= sizeof saved.def.name, "a name is a title");
  memcpy(gui->title, saved.def.name, sizeof saved.def.name);
}

static void mark_changed(Instance *instance) {
  const clap_host_state_t *const state =
    instance->host->get_extension(instance->host, CLAP_EXT_STATE);
  if (state) state->mark_dirty(instance->host);
}

static void use_drum(Instance *instance, Gui *gui, const Snapshot *snapshot) {
  for (uint32_t i = 0; i < KNOB_COUNT; i++)
    parameters_set(instance, (KnobId)i, (double)snapshot->values[i]);
  instance_restore(instance, &snapshot->saved);
  if (instance->params) instance->params->rescan(instance->host, CLAP_PARAM_RESCAN_VALUES);
  tell_title(instance, gui);
  mark_changed(instance);
}

/* The oldest is forgotten. */
static void note_undo(Instance *instance, Gui *gui) {
  if (gui->undo_count == UNDOS) {
    gui->undo_count--;
    memmove(gui->undos, gui->undos + 1, gui->undo_count * sizeof *gui->undos);
  }
  note_drum(instance, &gui->undos[gui->undo_count++]);
}

/* ---- what the window shows and does --------------------------------------------------------- */

static void scene(void *context, DrumWindowScene *shown) {
  Instance *const instance = context;
  GuiLink *const link = &instance->link;
  const Gui *const gui = link->gui;
  memcpy(shown->title, gui->title, sizeof shown->title);
  shown->is_second = gui->is_second;
  shown->can_undo = gui->undo_count > 0;
  for (uint32_t side = 0; side < 2; side++)
    shown->peaks[side] = atomic_exchange(&link->peaks[side], 0);
  shown->view = gui->view;
}

static bool control(void *context, uint32_t number, char *name, char *value, double *position) {
  const Instance *const instance = context;
  const KnobId id = parameters_first_page(instance, number);
  if (id == KNOB_COUNT) return false;
  (void)snprintf(name, DRUM_WINDOW_TEXT, "%s", knobs[id].name);
  parameters_text(instance, id, value, DRUM_WINDOW_TEXT);
  *position = parameters_position(instance, id);
  return true;
}

static void push_turn(Instance *instance, uint16_t type, KnobId id) {
  const GuiTurn turn = {
    .type = type, .id = parameters_id(id), .value = parameters_value(instance, id)};
  (void)spsc_queue_push(&instance->link.turns, &turn);
  if (instance->params) instance->params->request_flush(instance->host);
  if (instance->is_open) instance->host->request_process(instance->host);
}

static void begin(void *context, uint32_t number) {
  Instance *const instance = context;
  note_undo(instance, instance->link.gui);
  push_turn(instance, CLAP_EVENT_PARAM_GESTURE_BEGIN, parameters_first_page(instance, number));
}

static void move(void *context, uint32_t number, double position) {
  Instance *const instance = context;
  const KnobId id = parameters_first_page(instance, number);
  parameters_set_position(instance, id, position);
  push_turn(instance, CLAP_EVENT_PARAM_VALUE, id);
}

static void end(void *context, uint32_t number) {
  Instance *const instance = context;
  push_turn(instance, CLAP_EVENT_PARAM_GESTURE_END, parameters_first_page(instance, number));
  mark_changed(instance);
}

static void strike(void *context, double velocity, double radius, double angle) {
  Instance *const instance = context;
  const GuiStroke stroke = {velocity, radius, angle};
  if (!instance->is_open) return;
  (void)spsc_queue_push(&instance->link.strokes, &stroke);
  instance->host->request_process(instance->host);
}

/* From a drum that is no preset, the first or the last one. */
static void step_preset(void *context, int steps) {
  Instance *const instance = context;
  Gui *const gui = instance->link.gui;
  const uint32_t count = tabor_preset_count();
  uint32_t at = 0;
  while (at < count && strcmp(tabor_preset(at)->name, gui->title) != 0) at++;
  if (at == count) at = steps > 0 ? count - 1 : 0;
  const char *const name = tabor_preset((at + count + (uint32_t)steps) % count)->name;
  note_undo(instance, gui);
  (void)instance_preset_load.from_location(&instance->plugin, CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN,
                                           NULL, name);
  tell_title(instance, gui);
  mark_changed(instance);
}

/* At first both are the same. */
static void compare(void *context) {
  Instance *const instance = context;
  Gui *const gui = instance->link.gui;
  Snapshot now;
  note_drum(instance, &now);
  if (gui->has_other) use_drum(instance, gui, &gui->other);
  gui->other = now;
  gui->has_other = true;
  gui->is_second = !gui->is_second;
}

static void undo(void *context) {
  Instance *const instance = context;
  Gui *const gui = instance->link.gui;
  if (gui->undo_count > 0) use_drum(instance, gui, &gui->undos[--gui->undo_count]);
}

/* ---- CLAP's extension ----------------------------------------------------------------------- */

static const clap_host_timer_support_t *timers_of(const clap_plugin_t *plugin) {
  const clap_host_t *const host = instance_of(plugin)->host;
  return host->get_extension(host, CLAP_EXT_TIMER_SUPPORT);
}

static bool is_api_supported(const clap_plugin_t *plugin, const char *api, bool floating) {
  return strcmp(api, CLAP_WINDOW_API_X11) == 0 && !floating && timers_of(plugin);
}

static bool get_preferred_api(const clap_plugin_t *plugin, const char **api, bool *floating) {
  (void)plugin;
  *api = CLAP_WINDOW_API_X11;
  *floating = false;
  return true;
}

static void use_scale(double scale, uint32_t *width, uint32_t *height) {
  const double kept = fmin(fmax(scale, LEAST_SCALE), MOST_SCALE);
  *width = (uint32_t)lround(kept * DRUM_WINDOW_WIDTH);
  *height = (uint32_t)lround(kept * DRUM_WINDOW_HEIGHT);
}

/* What was undone and compared stays from one window to the next. */
static bool create(const clap_plugin_t *plugin, const char *api, bool floating) {
  Instance *const instance = instance_of(plugin);
  GuiLink *const link = &instance->link;
  if (!is_api_supported(plugin, api, floating)) return false;
  if (!link->gui) link->gui = calloc(1, sizeof *link->gui);
  if (!link->gui) return false;
  link->gui->timers = timers_of(plugin);
  link->gui->timer = CLAP_INVALID_ID;
  use_scale(1, &link->gui->width, &link->gui->height);
  tell_title(instance, link->gui);
  return true;
}

static void close_window(Instance *instance) {
  Gui *const gui = instance->link.gui;
  if (!gui || !gui->window) return;
  atomic_store(&instance->link.is_shown, false);
  if (gui->timer != CLAP_INVALID_ID) gui->timers->unregister_timer(instance->host, gui->timer);
  gui->timer = CLAP_INVALID_ID;
  drop_view(&instance->link, gui);
  drum_window_destroy(gui->window);
  gui->window = NULL;
}

static void destroy(const clap_plugin_t *plugin) { close_window(instance_of(plugin)); }

static bool set_scale(const clap_plugin_t *plugin, double scale) {
  Gui *const gui = gui_of(plugin);
  if (!gui || !(scale > 0)) return false;
  use_scale(scale, &gui->width, &gui->height);
  if (gui->window) drum_window_resize(gui->window, gui->width, gui->height);
  return true;
}

static bool get_size(const clap_plugin_t *plugin, uint32_t *width, uint32_t *height) {
  const Gui *const gui = gui_of(plugin);
  if (!gui) return false;
  *width = gui->width;
  *height = gui->height;
  return true;
}

static bool can_resize(const clap_plugin_t *plugin) {
  (void)plugin;
  return true;
}

static bool get_resize_hints(const clap_plugin_t *plugin, clap_gui_resize_hints_t *hints) {
  (void)plugin;
  *hints = (clap_gui_resize_hints_t){.can_resize_horizontally = true,
                                     .can_resize_vertically = true,
                                     .preserve_aspect_ratio = true,
                                     .aspect_ratio_width = DRUM_WINDOW_WIDTH,
                                     .aspect_ratio_height = DRUM_WINDOW_HEIGHT};
  return true;
}

/* The largest picture that fits. */
static bool adjust_size(const clap_plugin_t *plugin, uint32_t *width, uint32_t *height) {
  (void)plugin;
  const double scale =
    fmin((double)*width / DRUM_WINDOW_WIDTH, (double)*height / DRUM_WINDOW_HEIGHT);
  use_scale(scale, width, height);
  return true;
}

static bool set_size(const clap_plugin_t *plugin, uint32_t width, uint32_t height) {
  Gui *const gui = gui_of(plugin);
  if (!gui || width == 0 || height == 0 || width > INT16_MAX || height > INT16_MAX) return false;
  gui->width = width;
  gui->height = height;
  if (gui->window) drum_window_resize(gui->window, width, height);
  return true;
}

static bool set_parent(const clap_plugin_t *plugin, const clap_window_t *parent) {
  Instance *const instance = instance_of(plugin);
  Gui *const gui = instance->link.gui;
  const DrumWindowShell shell = {.context = instance,
                                 .scene = scene,
                                 .control = control,
                                 .begin = begin,
                                 .move = move,
                                 .end = end,
                                 .strike = strike,
                                 .step_preset = step_preset,
                                 .compare = compare,
                                 .undo = undo};
  if (!gui || gui->window || strcmp(parent->api, CLAP_WINDOW_API_X11) != 0) return false;
  gui->window = drum_window_create(parent->x11, gui->width, gui->height, &shell);
  if (!gui->window) return false;
  if (!gui->timers->register_timer(instance->host, PERIOD, &gui->timer)) {
    close_window(instance);
    return false;
  }
  return true;
}

static bool set_transient(const clap_plugin_t *plugin, const clap_window_t *parent) {
  (void)plugin;
  (void)parent;
  return false;
}

static void suggest_title(const clap_plugin_t *plugin, const char *title) {
  (void)plugin;
  (void)title;
}

static bool show_or_hide(const clap_plugin_t *plugin, bool shown) {
  Gui *const gui = gui_of(plugin);
  if (!gui || !gui->window) return false;
  atomic_store(&instance_of(plugin)->link.is_shown, shown);
  drum_window_show(gui->window, shown);
  return true;
}

static bool show(const clap_plugin_t *plugin) { return show_or_hide(plugin, true); }
static bool hide(const clap_plugin_t *plugin) { return show_or_hide(plugin, false); }

static const clap_plugin_gui_t gui_functions = {.is_api_supported = is_api_supported,
                                                .get_preferred_api = get_preferred_api,
                                                .create = create,
                                                .destroy = destroy,
                                                .set_scale = set_scale,
                                                .get_size = get_size,
                                                .can_resize = can_resize,
                                                .get_resize_hints = get_resize_hints,
                                                .adjust_size = adjust_size,
                                                .set_size = set_size,
                                                .set_parent = set_parent,
                                                .set_transient = set_transient,
                                                .suggest_title = suggest_title,
                                                .show = show,
                                                .hide = hide};

/* The name of the drum changes with a program change, too, of which nobody tells. */
static void on_timer(const clap_plugin_t *plugin, clap_id timer) {
  Instance *const instance = instance_of(plugin);
  GuiLink *const link = &instance->link;
  Gui *const gui = link->gui;
  if (!gui || !gui->window || timer != gui->timer || !take_view_back(link, gui)) return;
  if (gui->has_view && atomic_exchange(&link->is_stale, false)) {
    drop_view(link, gui);
    tell_title(instance, gui);
  }
  if (!gui->has_view) make_view(instance, gui);
  drum_window_update(gui->window);
  if (!gui->has_view || !atomic_load(&link->is_shown)) return;
  atomic_store(&link->asked, gui->view);
  gui->view = NULL;
}

static const clap_plugin_timer_support_t timer_functions = {.on_timer = on_timer};

const void *gui_extension(const char *id) {
  if (strcmp(id, CLAP_EXT_GUI) == 0) return &gui_functions;
  return strcmp(id, CLAP_EXT_TIMER_SUPPORT) == 0 ? &timer_functions : NULL;
}

void gui_end(Instance *instance) {
  close_window(instance);
  free(instance->link.gui);
  instance->link.gui = NULL;
}
