/* SPDX-License-Identifier: MIT */
#include "clap/gui_kind.h"
#include "clap/kit_instance.h"
#include "window/kit_plugin_window.h"

/* ---- what the window asks of the instance ---------------------------------------------------- */

static float value(void *shell, KitKnobId id) {
  KitInstance *const instance = shell;
  return atomic_load(&instance->values[id]);
}

static void push_turn(KitInstance *instance, uint16_t type, KitKnobId id) {
  gui_link_turn(&instance->link, type, (clap_id)id, (double)atomic_load(&instance->values[id]));
  if (instance->params) instance->params->request_flush(instance->host);
  if (instance->is_open) instance->host->request_process(instance->host);
}

static void mark_changed(KitInstance *instance) {
  const clap_host_state_t *const state =
    instance->host->get_extension(instance->host, CLAP_EXT_STATE);
  if (state) state->mark_dirty(instance->host);
}

static void begin(void *shell, KitKnobId id) {
  push_turn(shell, CLAP_EVENT_PARAM_GESTURE_BEGIN, id);
}

static void turn(void *shell, KitKnobId id, double to) {
  KitInstance *const instance = shell;
  atomic_store(&instance->values[id], kit_knob_clamp(id, to));
  push_turn(instance, CLAP_EVENT_PARAM_VALUE, id);
}

static void end(void *shell, KitKnobId id) {
  push_turn(shell, CLAP_EVENT_PARAM_GESTURE_END, id);
  mark_changed(shell);
}

static void use(void *shell, const float values[KIT_KNOB_COUNT]) {
  KitInstance *const instance = shell;
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) atomic_store(&instance->values[i], values[i]);
  if (instance->params) instance->params->rescan(instance->host, CLAP_PARAM_RESCAN_VALUES);
  if (instance->is_open) instance->host->request_process(instance->host);
  mark_changed(instance);
}

static void play(void *shell) {
  const KitInstance *const instance = shell;
  instance->host->request_process(instance->host);
}

/* ---- the window ----------------------------------------------------------------------------- */

static void *create(void *shell) {
  KitInstance *const instance = shell;
  const KitPluginWindowShell calls = {.instance = instance,
                                      .link = &instance->window,
                                      .own = &instance->own,
                                      .value = value,
                                      .begin = begin,
                                      .turn = turn,
                                      .end = end,
                                      .use = use,
                                      .play = play};
  return kit_plugin_window_create(&calls);
}

const GuiKind gui_kit = {.window = &kit_plugin_window_kind, .create = create};
