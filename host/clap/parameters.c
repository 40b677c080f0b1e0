/* SPDX-License-Identifier: MIT */
#include "clap/parameters.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plugin/choice_text.h"
#include "plugin/knob_text.h"

/* ---- ids ------------------------------------------------------------------------------------ */

static KnobId knob_of(const Instance *instance, clap_id id) REALTIME;
static KnobId knob_of(const Instance *instance, clap_id id) {
  if (id >= KNOB_COUNT) return KNOB_COUNT;
  return knob_is_in(instance->set, knob_ports[id]) ? knob_ports[id] : KNOB_COUNT;
}

clap_id parameters_id(KnobId knob) {
  clap_id id = 0;
  while (knob_ports[id] != knob) id++;
  return id;
}

/* ---- scales --------------------------------------------------------------------------------- */

/* A host may send any number, and what no float can hold must not be converted. */
static float single(double value) REALTIME;
static float single(double value) {
  return (float)fmin(fmax(value, -(double)FLT_MAX), (double)FLT_MAX);
}

/* A parameter whose scale is bent has the range 0 to 1. CLAP knows no switch that enables, but one that bypasses. */
static double to_parameter(const Instance *instance, KnobId id, double value) {
  const KnobRange *const range = &instance->ranges[id];
  if (id == KNOB_ENABLED) return 1 - value;
  return knob_is_bent(range) ? knob_position(range, value) : value;
}

static double to_knob(const Instance *instance, KnobId id, double parameter) REALTIME;
static double to_knob(const Instance *instance, KnobId id, double parameter) {
  const KnobRange *const range = &instance->ranges[id];
  if (id == KNOB_ENABLED) return parameter >= 0.5 ? 0 : 1;
  return knob_is_bent(range) ? knob_at_position(range, parameter) : parameter;
}

void parameters_set(Instance *instance, KnobId id, double value) {
  const KnobRange *const range = &instance->ranges[id];
  if (!isfinite(value)) return;
  if (knobs[id].choices) value = trunc(value);
  const float kept = single(knob_decimal(single(value)));
  atomic_store(&instance->values[id], fminf(fmaxf(kept, range->minimum), range->maximum));
}

/* ---- events --------------------------------------------------------------------------------- */

bool parameters_take(Instance *instance, const clap_event_header_t *event) {
  if (event->space_id != CLAP_CORE_EVENT_SPACE_ID) return false;
  if (event->type == CLAP_EVENT_PARAM_VALUE) {
    const clap_event_param_value_t *const set = (const clap_event_param_value_t *)event;
    const KnobId id = knob_of(instance, set->param_id);
    if (id == KNOB_COUNT) return false;
    parameters_set(instance, id, to_knob(instance, id, set->value));
    return true;
  }
  if (event->type == CLAP_EVENT_PARAM_MOD) {
    const clap_event_param_mod_t *const moved = (const clap_event_param_mod_t *)event;
    const KnobId id = knob_of(instance, moved->param_id);
    if (id == KNOB_COUNT || !knob_is_modulated(id) || !isfinite(moved->amount)) return false;
    atomic_store(&instance->modulations[id], single(moved->amount));
    return true;
  }
  return false;
}

/* How far the modulation is from the value, in the knob's own unit. */
static float offset_of(const Instance *instance, KnobId id, float value) REALTIME;
static float offset_of(const Instance *instance, KnobId id, float value) {
  const double amount = (double)atomic_load(&instance->modulations[id]);
  if (amount == 0) return 0;
  const double from = to_parameter(instance, id, (double)value);
  return single(to_knob(instance, id, from + amount) - (double)value);
}

/* CLAP declares this call thread-safe: hosts only note that they are to call back on their main thread. The compiler cannot
 * know that of a pointer. */
static void ask_for_main_thread(const clap_host_t *host) REALTIME;
static void ask_for_main_thread(const clap_host_t *host) {
  typedef void RequestFn(const clap_host_t *) REALTIME;
  RequestFn *const request = (RequestFn *)host->request_callback;
  request(host);
}

/* Where the head could not have the pitch that was asked for, or MIDI has chosen another drum, the knob goes where the drum
 * is. */
static void follow_drum(Instance *instance, KnobId id) REALTIME;
static void follow_drum(Instance *instance, KnobId id) {
  float asked, given;
  if (!plugin_player_take_given(&instance->player, id, &asked, &given)) return;
  if (!atomic_compare_exchange_strong(&instance->values[id], &asked, given)) return;
  atomic_store(&instance->has_moved, true);
  ask_for_main_thread(instance->host);
}

void parameters_turn(void *shell) {
  Instance *const instance = shell;
  KnobId id;
  follow_drum(instance, KNOB_DRUM);
  follow_drum(instance, KNOB_BATTER_PITCH);
  follow_drum(instance, KNOB_RESONANT_PITCH);
  plugin_player_turn(&instance->player, KNOB_DRUM, atomic_load(&instance->values[KNOB_DRUM]));
  for (uint32_t i = 0; (id = knob_at(instance->set, i)) < KNOB_COUNT; i++) {
    const float value = atomic_load(&instance->values[id]);
    plugin_player_turn(&instance->player, id, value);
    plugin_player_modulate(&instance->player, id, offset_of(instance, id, value));
  }
}

/* ---- texts ---------------------------------------------------------------------------------- */

static bool value_to_text(const clap_plugin_t *plugin, clap_id param, double value, char *text,
                          uint32_t size) {
  const Instance *const instance = instance_of(plugin);
  const KnobId id = knob_of(instance, param);
  if (id == KNOB_COUNT || size == 0) return false;
  const double plain = knob_decimal(single(to_knob(instance, id, value)));
  return knob_label(id, &instance->ranges[id], plain, text, size) > 0;
}

static bool text_to_value(const clap_plugin_t *plugin, clap_id param, const char *text,
                          double *value) {
  const Instance *const instance = instance_of(plugin);
  const KnobId id = knob_of(instance, param);
  double plain;
  if (id == KNOB_COUNT) return false;
  const bool is_read = knobs[id].choices ? choice_find(knobs[id].choices, text, &plain)
                                         : knob_text_read(id, &instance->ranges[id], text, &plain);
  if (!is_read) return false;
  *value = to_parameter(instance, id, plain);
  return true;
}

/* ---- description ---------------------------------------------------------------------------- */

static uint32_t count(const clap_plugin_t *plugin) { return knob_number(instance_of(plugin)->set); }

static const char *module_of(const Knob *knob) {
  for (uint32_t i = 0; i < KNOB_GROUPS; i++) {
    if (strcmp(knob->group, knob_groups[i].symbol) == 0) return knob_groups[i].name;
  }
  return "";
}

static double of_range(const Instance *instance, KnobId id, float value) {
  return to_parameter(instance, id, knob_decimal(value));
}

static bool get_info(const clap_plugin_t *plugin, uint32_t index, clap_param_info_t *info) {
  const Instance *const instance = instance_of(plugin);
  const KnobId id = knob_at(instance->set, index);
  if (id == KNOB_COUNT) return false;
  const KnobRange *const range = &instance->ranges[id];
  memset(info, 0, sizeof *info);
  info->id = parameters_id(id);
  info->flags = CLAP_PARAM_IS_AUTOMATABLE;
  if (knobs[id].choices) info->flags |= CLAP_PARAM_IS_STEPPED | CLAP_PARAM_IS_ENUM;
  if (knob_is_modulated(id)) info->flags |= CLAP_PARAM_IS_MODULATABLE;
  if (id == KNOB_ENABLED) info->flags |= CLAP_PARAM_IS_BYPASS;
  (void)snprintf(info->name, sizeof info->name, "%s",
                 id == KNOB_ENABLED ? "Bypass" : knobs[id].name);
  (void)snprintf(info->module, sizeof info->module, "%s", module_of(&knobs[id]));
  const double ends[] = {of_range(instance, id, range->minimum),
                         of_range(instance, id, range->maximum)};
  info->min_value = fmin(ends[0], ends[1]);
  info->max_value = fmax(ends[0], ends[1]);
  info->default_value = of_range(instance, id, range->fallback);
  return true;
}

void parameters_tell(Instance *instance) {
  if (instance->params) instance->params->rescan(instance->host, CLAP_PARAM_RESCAN_VALUES);
}

double parameters_value(const Instance *instance, KnobId id) {
  return of_range(instance, id, atomic_load(&instance->values[id]));
}

static bool get_value(const clap_plugin_t *plugin, clap_id param, double *value) {
  const Instance *const instance = instance_of(plugin);
  const KnobId id = knob_of(instance, param);
  if (id == KNOB_COUNT) return false;
  *value = parameters_value(instance, id);
  return true;
}

/* The knobs turn in the next block, which the host might leave out for a plugin that sleeps. */
static void flush(const clap_plugin_t *plugin, const clap_input_events_t *in,
                  const clap_output_events_t *out) {
  Instance *const instance = instance_of(plugin);
  bool any = false;
  gui_link_report(&instance->link, out);
  for (uint32_t i = 0; i < in->size(in); i++) {
    const clap_event_header_t *const event = in->get(in, i);
    if (event && parameters_take(instance, event)) any = true;
  }
  if (any && instance->is_open) instance->host->request_process(instance->host);
}

const clap_plugin_params_t instance_params = {.count = count,
                                              .get_info = get_info,
                                              .get_value = get_value,
                                              .value_to_text = value_to_text,
                                              .text_to_value = text_to_value,
                                              .flush = flush};

/* ---- pages of remote controls --------------------------------------------------------------- */

static uint32_t page_count(const clap_plugin_t *plugin) {
  uint32_t count = 0;
  while (knob_page(instance_of(plugin)->set, count)) count++;
  return count;
}

static bool get_page(const clap_plugin_t *plugin, uint32_t index,
                     clap_remote_controls_page_t *page) {
  const KnobSet set = instance_of(plugin)->set;
  const KnobPage *const shown = knob_page(set, index);
  if (!shown) return false;
  memset(page, 0, sizeof *page);
  page->page_id = shown->id;
  (void)snprintf(page->section_name, sizeof page->section_name, "%s", shown->section);
  (void)snprintf(page->page_name, sizeof page->page_name, "%s", shown->name);
  _Static_assert((int)KNOB_PAGE == (int)CLAP_REMOTE_CONTROLS_COUNT,
                 "a page has the room of a host's");
  for (uint32_t i = 0; i < KNOB_PAGE; i++) {
    const bool is_there = i < shown->count && knob_is_in(set, shown->knobs[i]);
    page->param_ids[i] = is_there ? parameters_id(shown->knobs[i]) : CLAP_INVALID_ID;
  }
  return true;
}

const clap_plugin_remote_controls_t instance_remote_controls = {.count = page_count,
                                                                .get = get_page};
