/* SPDX-License-Identifier: MIT */
/* Knobs of Tabor Kit as CLAP's parameters: their ids are the knobs' numbers, their values the knobs' own. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/kit_instance.h"
#include "plugin/choice_text.h"

bool kit_parameters_take(KitInstance *instance, const clap_event_header_t *event) {
  if (event->space_id != CLAP_CORE_EVENT_SPACE_ID || event->type != CLAP_EVENT_PARAM_VALUE) {
    return false;
  }
  const clap_event_param_value_t *const set = (const clap_event_param_value_t *)event;
  if (set->param_id >= KIT_KNOB_COUNT || isnan(set->value)) return false;
  const KitKnobId id = (KitKnobId)set->param_id;
  atomic_store(&instance->values[id], kit_knob_clamp(id, set->value));
  return true;
}

void kit_parameters_turn(KitInstance *instance) {
  const float *const values = instance->player.values;
  const float kit = values[KIT_KNOB_KIT], notes = values[KIT_KNOB_NOTES];
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) {
    kit_plugin_player_turn(&instance->player, (KitKnobId)i, atomic_load(&instance->values[i]));
  }
  if (values[KIT_KNOB_KIT] != kit || values[KIT_KNOB_NOTES] != notes) {
    instance->host->request_callback(instance->host); /* notes have other names */
  }
}

void kit_parameters_tell(KitInstance *instance) {
  if (instance->params) instance->params->rescan(instance->host, CLAP_PARAM_RESCAN_VALUES);
  if (instance->note_names) instance->note_names->changed(instance->host);
  if (instance->is_open) instance->host->request_process(instance->host);
}

/* ---- texts ---------------------------------------------------------------------------------- */

static bool value_to_text(const clap_plugin_t *plugin, clap_id id, double value, char *text,
                          uint32_t size) {
  (void)plugin;
  if (id >= KIT_KNOB_COUNT || size == 0) return false;
  const KitKnobId knob = (KitKnobId)id;
  return kit_knob_text(knob, kit_knob_clamp(knob, value), text, size) > 0;
}

static bool text_to_value(const clap_plugin_t *plugin, clap_id id, const char *text,
                          double *value) {
  char *end = NULL;
  (void)plugin;
  if (id >= KIT_KNOB_COUNT) return false;
  const KitKnob *const knob = &kit_knobs[id];
  if (knob->choices) return choice_find(knob->choices, text, value);
  if (knob->off && strcmp(text, "Off") == 0) {
    *value = (double)knob->minimum;
    return true;
  }
  const double plain = strtod(text, &end);
  if (end == text || !isfinite(plain)) return false;
  *value = (double)kit_knob_clamp((KitKnobId)id, plain);
  return true;
}

/* ---- description ---------------------------------------------------------------------------- */

static uint32_t count(const clap_plugin_t *plugin) {
  (void)plugin;
  return KIT_KNOB_COUNT;
}

static bool get_info(const clap_plugin_t *plugin, uint32_t index, clap_param_info_t *info) {
  (void)plugin;
  if (index >= KIT_KNOB_COUNT) return false;
  const KitKnob *const knob = &kit_knobs[index];
  memset(info, 0, sizeof *info);
  info->id = index;
  info->flags = CLAP_PARAM_IS_AUTOMATABLE;
  if (knob->choices) info->flags |= CLAP_PARAM_IS_STEPPED | CLAP_PARAM_IS_ENUM;
  (void)snprintf(info->name, sizeof info->name, "%s", knob->name);
  (void)snprintf(info->module, sizeof info->module, "%s", knob->group);
  info->min_value = (double)knob->minimum;
  info->max_value = (double)knob->maximum;
  info->default_value = (double)knob->fallback;
  return true;
}

static bool get_value(const clap_plugin_t *plugin, clap_id id, double *value) {
  if (id >= KIT_KNOB_COUNT) return false;
  *value = (double)atomic_load(&kit_instance_of(plugin)->values[id]);
  return true;
}

/* The knobs turn in the next block, which the host might leave out for a plugin that sleeps. */
static void flush(const clap_plugin_t *plugin, const clap_input_events_t *in,
                  const clap_output_events_t *out) {
  KitInstance *const instance = kit_instance_of(plugin);
  bool any = false;
  gui_link_report(&instance->link, out);
  for (uint32_t i = 0; i < in->size(in); i++) {
    const clap_event_header_t *const event = in->get(in, i);
    if (event && kit_parameters_take(instance, event)) any = true;
  }
  if (any && instance->is_open) instance->host->request_process(instance->host);
}

const clap_plugin_params_t kit_params = {.count = count,
                                         .get_info = get_info,
                                         .get_value = get_value,
                                         .value_to_text = value_to_text,
                                         .text_to_value = text_to_value,
                                         .flush = flush};
