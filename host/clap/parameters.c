/* SPDX-License-Identifier: MIT */
#include "clap/parameters.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "clap/host_calls.h"
#include "plugin/choice_text.h"
#include "plugin/knob_text.h"

/* NULL if the instrument has no knob of that id. */
static const Knob *knob_of(const Instrument *instrument, clap_id param, uint32_t *id) REALTIME {
  *id = instrument_knob(instrument->kind, param);
  return *id < instrument->kind->knob_count ? &instrument->kind->knobs[*id] : NULL;
}

/* ---- scales --------------------------------------------------------------------------------- */

/* A parameter whose scale is bent has the range 0 to 1. CLAP knows no switch that enables, but one
 * that bypasses. */
static double to_parameter(const Instrument *instrument, uint32_t id, double value) {
  const KnobRange *const range = &instrument->ranges[id];
  if (instrument->kind->knobs[id].is_bypass) return 1 - value;
  return knob_is_bent(range) ? knob_position(range, value) : value;
}

static double to_knob(const Instrument *instrument, uint32_t id, double parameter) REALTIME {
  const KnobRange *const range = &instrument->ranges[id];
  if (instrument->kind->knobs[id].is_bypass) return parameter >= 0.5 ? 0 : 1;
  return knob_is_bent(range) ? knob_at_position(range, parameter) : parameter;
}

/* ---- events --------------------------------------------------------------------------------- */

static bool can_modulate(const Instrument *instrument, uint32_t id) REALTIME {
  const InstrumentCalls *const calls = instrument->kind->calls;
  return calls->is_modulated && calls->is_modulated(id);
}

static bool take_value(Instrument *instrument, const clap_event_param_value_t *set) REALTIME {
  uint32_t id;
  if (!knob_of(instrument, set->param_id, &id)) return false;
  instrument_set(instrument, id, to_knob(instrument, id, set->value));
  return true;
}

static bool take_modulation(Instrument *instrument, const clap_event_param_mod_t *moved) REALTIME {
  uint32_t id;
  if (!knob_of(instrument, moved->param_id, &id)) return false;
  if (!can_modulate(instrument, id) || !isfinite(moved->amount)) return false;
  atomic_store(&instrument->offsets[id], knob_single(moved->amount));
  return true;
}

bool parameters_take(Instance *instance, const clap_event_header_t *event) {
  if (event->space_id != CLAP_CORE_EVENT_SPACE_ID) return false;
  if (event->type == CLAP_EVENT_PARAM_VALUE)
    return take_value(instance->instrument, (const clap_event_param_value_t *)event);
  return event->type == CLAP_EVENT_PARAM_MOD &&
         take_modulation(instance->instrument, (const clap_event_param_mod_t *)event);
}

/* ---- texts ---------------------------------------------------------------------------------- */

static bool value_to_text(const clap_plugin_t *plugin, clap_id param, double value, char *text,
                          uint32_t size) {
  const Instrument *const instrument = instrument_of(plugin);
  uint32_t id;
  const Knob *const knob = knob_of(instrument, param, &id);
  if (!knob || size == 0) return false;
  const double plain = knob_decimal(knob_single(to_knob(instrument, id, value)));
  return knob_label(knob, &instrument->ranges[id], plain, text, size) > 0;
}

static bool text_to_value(const clap_plugin_t *plugin, clap_id param, const char *text,
                          double *value) {
  const Instrument *const instrument = instrument_of(plugin);
  uint32_t id;
  double plain;
  const Knob *const knob = knob_of(instrument, param, &id);
  if (!knob) return false;
  const bool is_read = knob->choices ? choice_find(knob->choices, text, &plain)
                                     : knob_text_read(knob, &instrument->ranges[id], text, &plain);
  if (!is_read) return false;
  *value = to_parameter(instrument, id, plain);
  return true;
}

/* ---- description ---------------------------------------------------------------------------- */

static uint32_t count(const clap_plugin_t *plugin) {
  return instrument_knob_count(instrument_of(plugin)->kind);
}

static double of_range(const Instrument *instrument, uint32_t id, float value) {
  return to_parameter(instrument, id, knob_decimal(value));
}

static uint32_t flags_of(const Instrument *instrument, uint32_t id) {
  const Knob *const knob = &instrument->kind->knobs[id];
  uint32_t flags = CLAP_PARAM_IS_AUTOMATABLE;
  if (knob->choices) flags |= CLAP_PARAM_IS_STEPPED | CLAP_PARAM_IS_ENUM;
  if (can_modulate(instrument, id)) flags |= CLAP_PARAM_IS_MODULATABLE;
  return knob->is_bypass ? flags | CLAP_PARAM_IS_BYPASS : flags;
}

static bool get_info(const clap_plugin_t *plugin, uint32_t index, clap_param_info_t *info) {
  const Instrument *const instrument = instrument_of(plugin);
  const uint32_t id = instrument_knob_at(instrument->kind, index);
  if (id == instrument->kind->knob_count) return false;
  const KnobRange *const range = &instrument->ranges[id];
  const Knob *const knob = &instrument->kind->knobs[id];
  const double ends[] = {of_range(instrument, id, range->minimum),
                         of_range(instrument, id, range->maximum)};
  memset(info, 0, sizeof *info);
  info->id = instrument_number(instrument->kind, id);
  info->flags = flags_of(instrument, id);
  (void)snprintf(info->name, sizeof info->name, "%s", knob->is_bypass ? "Bypass" : knob->name);
  (void)snprintf(info->module, sizeof info->module, "%s",
                 instrument_group_name(instrument->kind, id));
  info->min_value = fmin(ends[0], ends[1]);
  info->max_value = fmax(ends[0], ends[1]);
  info->default_value = of_range(instrument, id, range->fallback);
  return true;
}

double parameters_value(const Instrument *instrument, uint32_t id) {
  return of_range(instrument, id, atomic_load(&instrument->values[id]));
}

static bool get_value(const clap_plugin_t *plugin, clap_id param, double *value) {
  const Instrument *const instrument = instrument_of(plugin);
  uint32_t id;
  if (!knob_of(instrument, param, &id)) return false;
  *value = parameters_value(instrument, id);
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
  if (any) host_wake(instance);
}

const clap_plugin_params_t parameters_extension = {.count = count,
                                                   .get_info = get_info,
                                                   .get_value = get_value,
                                                   .value_to_text = value_to_text,
                                                   .text_to_value = text_to_value,
                                                   .flush = flush};

/* ---- pages of remote controls --------------------------------------------------------------- */

static uint32_t page_count(const clap_plugin_t *plugin) {
  uint32_t count = 0;
  while (instrument_page(instrument_of(plugin)->kind, count)) count++;
  return count;
}

static bool get_page(const clap_plugin_t *plugin, uint32_t index,
                     clap_remote_controls_page_t *page) {
  const InstrumentKind *const kind = instrument_of(plugin)->kind;
  const KnobPage *const shown = instrument_page(kind, index);
  if (!shown) return false;
  memset(page, 0, sizeof *page);
  page->page_id = shown->id;
  (void)snprintf(page->section_name, sizeof page->section_name, "%s", shown->section);
  (void)snprintf(page->page_name, sizeof page->page_name, "%s", shown->name);
  _Static_assert((int)KNOB_PAGE == (int)CLAP_REMOTE_CONTROLS_COUNT,
                 "a page has the room of a host's");
  for (uint32_t i = 0; i < KNOB_PAGE; i++) {
    const bool is_there = i < shown->count && kind->calls->has_knob(kind, shown->knobs[i]);
    page->param_ids[i] = is_there ? instrument_number(kind, shown->knobs[i]) : CLAP_INVALID_ID;
  }
  return true;
}

const clap_plugin_remote_controls_t parameters_remote_controls = {.count = page_count,
                                                                  .get = get_page};
