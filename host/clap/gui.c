/* SPDX-License-Identifier: MIT */
#include "clap/gui.h"

#include <stdlib.h>
#include <string.h>

#include "clap/instance_drum.h"
#include "clap/parameters.h"
#include "clap/presets.h"
#include "window/plugin_window.h"

typedef struct Gui {
  const clap_host_timer_support_t *timers;
  clap_id timer;
  PluginWindow *window;
} Gui;

static Gui *gui_of(const clap_plugin_t *plugin) { return instance_of(plugin)->link.gui; }

/* ---- what the window asks of the instance ---------------------------------------------------- */

static ModelWorker *worker(void *shell) {
  Instance *const instance = shell;
  return instance->is_open ? &instance->worker : NULL;
}

static float value(void *shell, KnobId id) {
  Instance *const instance = shell;
  return atomic_load(&instance->values[id]);
}

static void push_turn(Instance *instance, uint16_t type, KnobId id) {
  const GuiTurn turn = {
    .type = type, .id = parameters_id(id), .value = parameters_value(instance, id)};
  (void)spsc_queue_push(&instance->link.turns, &turn);
  if (instance->params) instance->params->request_flush(instance->host);
  if (instance->is_open) instance->host->request_process(instance->host);
}

static void mark_changed(Instance *instance) {
  const clap_host_state_t *const state =
    instance->host->get_extension(instance->host, CLAP_EXT_STATE);
  if (state) state->mark_dirty(instance->host);
}

static void begin(void *shell, KnobId id) { push_turn(shell, CLAP_EVENT_PARAM_GESTURE_BEGIN, id); }

static void turn(void *shell, KnobId id, double to) {
  parameters_set(shell, id, to);
  push_turn(shell, CLAP_EVENT_PARAM_VALUE, id);
}

static void end(void *shell, KnobId id) {
  push_turn(shell, CLAP_EVENT_PARAM_GESTURE_END, id);
  mark_changed(shell);
}

static void save(void *shell, SavedState *saved) { instance_save(shell, saved); }

static void use(void *shell, const PluginDrum *drum) {
  Instance *const instance = shell;
  for (uint32_t i = 0; i < KNOB_COUNT; i++)
    parameters_set(instance, (KnobId)i, (double)drum->values[i]);
  instance_restore(instance, &drum->saved);
  if (instance->params) instance->params->rescan(instance->host, CLAP_PARAM_RESCAN_VALUES);
  mark_changed(instance);
}

static void choose(void *shell, const char *preset) {
  Instance *const instance = shell;
  (void)instance_preset_load.from_location(&instance->plugin, CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN,
                                           NULL, preset);
  mark_changed(instance);
}

static void play(void *shell) {
  const Instance *const instance = shell;
  instance->host->request_process(instance->host);
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

static Gui *make_gui(Instance *instance) {
  const PluginWindowShell shell = {.instance = instance,
                                   .link = &instance->link.window,
                                   .set = instance->set,
                                   .ranges = instance->ranges,
                                   .worker = worker,
                                   .value = value,
                                   .begin = begin,
                                   .turn = turn,
                                   .end = end,
                                   .save = save,
                                   .use = use,
                                   .choose = choose,
                                   .play = play};
  Gui *const gui = calloc(1, sizeof *gui);
  if (!gui) return NULL;
  gui->window = plugin_window_create(&shell);
  if (gui->window) return gui;
  free(gui);
  return NULL;
}

/* What was undone and compared stays from one window to the next. */
static bool create(const clap_plugin_t *plugin, const char *api, bool floating) {
  GuiLink *const link = &instance_of(plugin)->link;
  if (!is_api_supported(plugin, api, floating)) return false;
  if (!link->gui) link->gui = make_gui(instance_of(plugin));
  if (!link->gui) return false;
  link->gui->timers = timers_of(plugin);
  link->gui->timer = CLAP_INVALID_ID;
  plugin_window_scale(link->gui->window, 1);
  return true;
}

static void close_window(Instance *instance) {
  Gui *const gui = instance->link.gui;
  if (!gui || !plugin_window_is_open(gui->window)) return;
  if (gui->timer != CLAP_INVALID_ID) gui->timers->unregister_timer(instance->host, gui->timer);
  gui->timer = CLAP_INVALID_ID;
  plugin_window_close(gui->window);
}

static void destroy(const clap_plugin_t *plugin) { close_window(instance_of(plugin)); }

static bool set_scale(const clap_plugin_t *plugin, double scale) {
  const Gui *const gui = gui_of(plugin);
  if (!gui || !(scale > 0)) return false;
  plugin_window_scale(gui->window, scale);
  return true;
}

static bool get_size(const clap_plugin_t *plugin, uint32_t *width, uint32_t *height) {
  const Gui *const gui = gui_of(plugin);
  if (!gui) return false;
  plugin_window_size(gui->window, width, height);
  return true;
}

static bool can_resize(const clap_plugin_t *plugin) {
  (void)plugin;
  return true;
}

static bool get_resize_hints(const clap_plugin_t *plugin, clap_gui_resize_hints_t *hints) {
  uint32_t width = 1, height = 1;
  (void)plugin;
  plugin_window_fit(&width, &height);
  *hints = (clap_gui_resize_hints_t){.can_resize_horizontally = true,
                                     .can_resize_vertically = true,
                                     .preserve_aspect_ratio = true,
                                     .aspect_ratio_width = width,
                                     .aspect_ratio_height = height};
  return true;
}

/* The largest picture that fits. */
static bool adjust_size(const clap_plugin_t *plugin, uint32_t *width, uint32_t *height) {
  (void)plugin;
  plugin_window_fit(width, height);
  return true;
}

static bool set_size(const clap_plugin_t *plugin, uint32_t width, uint32_t height) {
  const Gui *const gui = gui_of(plugin);
  if (!gui || width == 0 || height == 0 || width > INT16_MAX || height > INT16_MAX) return false;
  plugin_window_resize(gui->window, width, height);
  return true;
}

static bool set_parent(const clap_plugin_t *plugin, const clap_window_t *parent) {
  Instance *const instance = instance_of(plugin);
  Gui *const gui = instance->link.gui;
  if (!gui || strcmp(parent->api, CLAP_WINDOW_API_X11) != 0) return false;
  if (!plugin_window_open(gui->window, parent->x11)) return false;
  if (gui->timers->register_timer(instance->host, PLUGIN_WINDOW_PERIOD, &gui->timer)) return true;
  close_window(instance);
  return false;
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
  const Gui *const gui = gui_of(plugin);
  if (!gui || !plugin_window_is_open(gui->window)) return false;
  plugin_window_show(gui->window, shown);
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

static void on_timer(const clap_plugin_t *plugin, clap_id timer) {
  const Gui *const gui = gui_of(plugin);
  if (gui && timer == gui->timer) plugin_window_update(gui->window);
}

static const clap_plugin_timer_support_t timer_functions = {.on_timer = on_timer};

const void *gui_extension(const char *id) {
  if (strcmp(id, CLAP_EXT_GUI) == 0) return &gui_functions;
  return strcmp(id, CLAP_EXT_TIMER_SUPPORT) == 0 ? &timer_functions : NULL;
}

void gui_end(Instance *instance) {
  Gui *const gui = instance->link.gui;
  close_window(instance);
  if (gui) plugin_window_destroy(gui->window);
  free(gui);
  instance->link.gui = NULL;
}
