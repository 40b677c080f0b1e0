/* SPDX-License-Identifier: MIT */
#include "clap/gui_kind.h"
#include "clap/instance_drum.h"
#include "clap/parameters.h"
#include "clap/presets.h"
#include "window/plugin_window.h"

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
  gui_link_turn(&instance->link, type, parameters_id(id), parameters_value(instance, id));
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
  parameters_tell(instance);
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

/* ---- the window ----------------------------------------------------------------------------- */

static void *create(void *shell) {
  Instance *const instance = shell;
  const PluginWindowShell calls = {.instance = instance,
                                   .link = &instance->window,
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
  return plugin_window_create(&calls);
}

const GuiKind gui_drum = {.window = &plugin_window_kind, .create = create};
