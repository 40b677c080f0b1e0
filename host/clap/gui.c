/* SPDX-License-Identifier: MIT */
#include "clap/gui.h"

#include <stdlib.h>
#include <string.h>

#include "clap/host_calls.h"
#include "clap/parameters.h"
#include "clap/presets.h"
#include "window/plugin_window.h"

#ifdef _WIN32
#  define NATIVE_API CLAP_WINDOW_API_WIN32
static uintptr_t id_of(const clap_window_t *window) { return (uintptr_t)window->win32; }
#else
#  define NATIVE_API CLAP_WINDOW_API_X11
static uintptr_t id_of(const clap_window_t *window) { return window->x11; }
#endif

typedef struct Gui {
  PluginWindow *window;
  const clap_host_timer_support_t *timers; /* NULL: the window updates itself */
  clap_id timer;
} Gui;

static GuiLink *link_of(const clap_plugin_t *plugin) { return &instance_of(plugin)->link; }

static const clap_host_t *host_of(const clap_plugin_t *plugin) { return instance_of(plugin)->host; }

static Gui *gui_of(const clap_plugin_t *plugin) { return link_of(plugin)->gui; }

/* ---- what the window asks of the instance ---------------------------------------------------- */

static float value(void *shell, uint32_t id) {
  const Instance *const instance = shell;
  return atomic_load(&instance->instrument->values[id]);
}

static void push_turn(Instance *instance, uint16_t type, uint32_t id) {
  gui_link_turn(&instance->link, type, instrument_number(instance->instrument->kind, id),
                parameters_value(instance->instrument, id));
  if (instance->params) instance->params->request_flush(instance->host);
  host_wake(instance);
}

static void mark_changed(const Instance *instance) {
  const clap_host_state_t *const state =
    instance->host->get_extension(instance->host, CLAP_EXT_STATE);
  if (state) state->mark_dirty(instance->host);
}

static void begin(void *shell, uint32_t id) {
  push_turn(shell, CLAP_EVENT_PARAM_GESTURE_BEGIN, id);
}

static void turn(void *shell, uint32_t id, double to) {
  const Instance *const instance = shell;
  instrument_set(instance->instrument, id, to);
  push_turn(shell, CLAP_EVENT_PARAM_VALUE, id);
}

static void end(void *shell, uint32_t id) {
  push_turn(shell, CLAP_EVENT_PARAM_GESTURE_END, id);
  mark_changed(shell);
}

static void use(void *shell, const InstrumentSetting *setting) {
  host_use(shell, setting);
  mark_changed(shell);
}

static void choose(void *shell, const char *name, bool is_file) {
  const Instance *const instance = shell;
  if (is_file) {
    (void)presets_load.from_location(&instance->plugin, CLAP_PRESET_DISCOVERY_LOCATION_FILE, name,
                                     NULL);
  } else {
    (void)presets_load.from_location(&instance->plugin, CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN, NULL,
                                     name);
  }
  mark_changed(instance);
}

static void play(void *shell) {
  const Instance *const instance = shell;
  instance->host->request_process(instance->host);
}

static void menu(void *shell, uint32_t id, int x, int y) {
  const Instance *const instance = shell;
  const clap_host_t *const host = instance->host;
  const clap_host_context_menu_t *menus = host->get_extension(host, CLAP_EXT_CONTEXT_MENU);
  const clap_context_menu_target_t target = {.kind = CLAP_CONTEXT_MENU_TARGET_KIND_PARAM,
                                             .id =
                                               instrument_number(instance->instrument->kind, id)};
  if (!menus) menus = host->get_extension(host, CLAP_EXT_CONTEXT_MENU_COMPAT);
  if (menus && menus->can_popup(host)) (void)menus->popup(host, &target, 0, x, y);
}

static PluginWindow *make_window(Instance *instance) {
  const PluginWindowShell shell = {.shell = instance,
                                   .instrument = instance->instrument,
                                   .value = value,
                                   .begin = begin,
                                   .turn = turn,
                                   .end = end,
                                   .use = use,
                                   .choose = choose,
                                   .play = play,
                                   .menu = menu};
  return plugin_window_create(&shell);
}

/* ---- CLAP's extension ----------------------------------------------------------------------- */

static const clap_host_timer_support_t *timers_of(const clap_plugin_t *plugin) {
  const clap_host_t *const host = host_of(plugin);
  return host->get_extension(host, CLAP_EXT_TIMER_SUPPORT);
}

/* Hosts ask while they scan, too, when they have no timers yet: create() looks for those. */
static bool is_api_supported(const clap_plugin_t *plugin, const char *api, bool floating) {
  (void)plugin;
  return strcmp(api, NATIVE_API) == 0 && !floating;
}

static bool get_preferred_api(const clap_plugin_t *plugin, const char **api, bool *floating) {
  (void)plugin;
  *api = NATIVE_API;
  *floating = false;
  return true;
}

static Gui *make_gui(const clap_plugin_t *plugin) {
  Gui *const gui = calloc(1, sizeof *gui);
  if (!gui) return NULL;
  gui->window = make_window(instance_of(plugin));
  if (gui->window) return gui;
  free(gui);
  return NULL;
}

/* What was undone and compared stays from one window to the next. */
static bool create(const clap_plugin_t *plugin, const char *api, bool floating) {
  GuiLink *const link = link_of(plugin);
  const clap_host_timer_support_t *const timers = timers_of(plugin);
  if (!is_api_supported(plugin, api, floating)) return false;
  if (!timers && !plugin_window_has_timers()) return false;
  if (!link->gui) link->gui = make_gui(plugin);
  if (!link->gui) return false;
  link->gui->timers = timers;
  link->gui->timer = CLAP_INVALID_ID;
  plugin_window_scale(link->gui->window, 1);
  return true;
}

static void close_window(const clap_plugin_t *plugin) {
  Gui *const gui = gui_of(plugin);
  if (!gui || !plugin_window_is_open(gui->window)) return;
  if (gui->timer != CLAP_INVALID_ID) gui->timers->unregister_timer(host_of(plugin), gui->timer);
  gui->timer = CLAP_INVALID_ID;
  plugin_window_close(gui->window);
}

static void destroy(const clap_plugin_t *plugin) { close_window(plugin); }

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
  window_fit(&width, &height);
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
  window_fit(width, height);
  return true;
}

static bool set_size(const clap_plugin_t *plugin, uint32_t width, uint32_t height) {
  const Gui *const gui = gui_of(plugin);
  if (!gui || width == 0 || height == 0 || width > INT16_MAX || height > INT16_MAX) return false;
  plugin_window_resize(gui->window, width, height);
  return true;
}

static bool start_timer(const clap_plugin_t *plugin, Gui *gui) {
  if (!gui->timers) return plugin_window_update_itself(gui->window);
  return gui->timers->register_timer(host_of(plugin), WINDOW_PERIOD, &gui->timer);
}

static bool set_parent(const clap_plugin_t *plugin, const clap_window_t *parent) {
  Gui *const gui = gui_of(plugin);
  if (!gui || strcmp(parent->api, NATIVE_API) != 0) return false;
  if (!plugin_window_open(gui->window, id_of(parent))) return false;
  if (start_timer(plugin, gui)) return true;
  close_window(plugin);
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

void gui_end(const clap_plugin_t *plugin) {
  Gui *const gui = gui_of(plugin);
  close_window(plugin);
  if (gui) plugin_window_destroy(gui->window);
  free(gui);
  link_of(plugin)->gui = NULL;
}
