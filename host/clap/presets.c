/* SPDX-License-Identifier: MIT */
#include "clap/presets.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/instance_drum.h"
#include "clap/parameters.h"

/* ---- loading -------------------------------------------------------------------------------- */

static const clap_host_preset_load_t *loader_of(const Instance *instance) {
  const clap_host_t *const host = instance->host;
  const clap_host_preset_load_t *const loader = host->get_extension(host, CLAP_EXT_PRESET_LOAD);
  return loader ? loader : host->get_extension(host, CLAP_EXT_PRESET_LOAD_COMPAT);
}

/* Knobs stand where the drum is; of parts that it lacks, where they stood. */
static void load_drum(Instance *instance, const TaborDrumDef *def) {
  SavedState saved = {.def = *def};
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    parameters_set(instance, (KnobId)i, knob_shown(def, (KnobId)i)); /* a NaN does nothing */
    saved.seen[i] = atomic_load(&instance->values[i]);
  }
  instance_restore(instance, &saved);
}

static bool from_location(const clap_plugin_t *plugin, uint32_t kind, const char *location,
                          const char *key) {
  Instance *const instance = instance_of(plugin);
  const clap_host_preset_load_t *const loader = loader_of(instance);
  TaborDrumDef def;
  TaborError error = {.message = "only the built-in drums are presets"};
  const bool is_ours = kind == CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN && key;
  if (!is_ours || tabor_drum_def_preset(&def, key, &error) != TABOR_OK) {
    if (loader) loader->on_error(instance->host, kind, location, key, 0, error.message);
    return false;
  }
  load_drum(instance, &def);
  if (instance->params) instance->params->rescan(instance->host, CLAP_PARAM_RESCAN_VALUES);
  if (loader) loader->loaded(instance->host, kind, location, key);
  return true;
}

const clap_plugin_preset_load_t instance_preset_load = {.from_location = from_location};

/* ---- discovery ------------------------------------------------------------------------------ */

static const clap_preset_discovery_provider_descriptor_t provider_descriptor = {
  .clap_version = CLAP_VERSION_INIT, .id = "tabor.presets", .name = "Tabor", .vendor = "Tabor"};

typedef struct Provider {
  clap_preset_discovery_provider_t provider;
  const clap_preset_discovery_indexer_t *indexer;
} Provider;

static bool declare(const clap_preset_discovery_provider_t *provider) {
  const Provider *const own = provider->provider_data;
  const clap_preset_discovery_location_t location = {.flags =
                                                       CLAP_PRESET_DISCOVERY_IS_FACTORY_CONTENT,
                                                     .name = "Drums",
                                                     .kind = CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN};
  return own->indexer->declare_location(own->indexer, &location);
}

/* "snare-14x5.5" as "Snare 14x5.5". */
static void readable(const char *name, char *text, size_t size) {
  (void)snprintf(text, size, "%s", name);
  text[0] = (char)toupper((unsigned char)text[0]);
  for (char *dash = text; (dash = strchr(dash, '-')) != NULL;) *dash = ' ';
}

static bool describe(const clap_preset_discovery_metadata_receiver_t *receiver,
                     const TaborPresetInfo *preset) {
  static const clap_universal_plugin_id_t plugins[] = {{"clap", ID_DRUM}, {"clap", ID_DRUM_MULTI}};
  char name[CLAP_NAME_SIZE];
  readable(preset->name, name, sizeof name);
  if (!receiver->begin_preset(receiver, name, preset->name)) return false;
  receiver->add_plugin_id(receiver, &plugins[0]);
  receiver->add_plugin_id(receiver, &plugins[1]);
  receiver->set_flags(receiver, CLAP_PRESET_DISCOVERY_IS_FACTORY_CONTENT);
  receiver->set_description(receiver, preset->comment);
  receiver->add_feature(receiver, CLAP_PLUGIN_FEATURE_DRUM);
  return true;
}

static bool get_metadata(const clap_preset_discovery_provider_t *provider, uint32_t kind,
                         const char *location,
                         const clap_preset_discovery_metadata_receiver_t *receiver) {
  (void)provider;
  (void)location;
  if (kind != CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN) return false;
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    if (!describe(receiver, tabor_preset(i))) break; /* the host has enough */
  }
  return true;
}

static const void *get_extension(const clap_preset_discovery_provider_t *provider, const char *id) {
  (void)provider;
  (void)id;
  return NULL;
}

static void destroy(const clap_preset_discovery_provider_t *provider) {
  free(provider->provider_data);
}

static uint32_t count(const clap_preset_discovery_factory_t *factory) {
  (void)factory;
  return 1;
}

static const clap_preset_discovery_provider_descriptor_t *
get_descriptor(const clap_preset_discovery_factory_t *factory, uint32_t index) {
  (void)factory;
  return index == 0 ? &provider_descriptor : NULL;
}

static const clap_preset_discovery_provider_t *
create(const clap_preset_discovery_factory_t *factory,
       const clap_preset_discovery_indexer_t *indexer, const char *id) {
  (void)factory;
  if (strcmp(id, provider_descriptor.id) != 0) return NULL;
  Provider *const own = calloc(1, sizeof *own);
  if (!own) return NULL;
  own->indexer = indexer;
  own->provider = (clap_preset_discovery_provider_t){.desc = &provider_descriptor,
                                                     .provider_data = own,
                                                     .init = declare,
                                                     .destroy = destroy,
                                                     .get_metadata = get_metadata,
                                                     .get_extension = get_extension};
  return &own->provider;
}

const clap_preset_discovery_factory_t presets_factory = {
  .count = count, .get_descriptor = get_descriptor, .create = create};
