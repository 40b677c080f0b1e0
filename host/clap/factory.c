/* SPDX-License-Identifier: MIT */
/* The entry point of tabor.clap: which plugins and presets it has. */
#include <string.h>

#include "clap/instance.h"
#include "clap/presets.h"

#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)
#define VERSION_TEXT                                                                               \
  TEXT(TABOR_VERSION_MAJOR)                                                                        \
  "." TEXT(TABOR_VERSION_MINOR) "." TEXT(TABOR_VERSION_PATCH) TABOR_VERSION_SUFFIX

static const char *const stereo_features[] = {
  CLAP_PLUGIN_FEATURE_INSTRUMENT, CLAP_PLUGIN_FEATURE_DRUM, CLAP_PLUGIN_FEATURE_SYNTHESIZER,
  CLAP_PLUGIN_FEATURE_STEREO, NULL};

static const char *const effect_features[] = {CLAP_PLUGIN_FEATURE_AUDIO_EFFECT,
                                              CLAP_PLUGIN_FEATURE_STEREO, NULL};

static const struct {
  const char *id;
  InstrumentKindId kind;
  const char *const *features;
} plugins[] = {{ID_DRUM, INSTRUMENT_STEREO, stereo_features},
               {ID_DRUM_MULTI, INSTRUMENT_MULTI, stereo_features},
               {ID_KIT, INSTRUMENT_KIT, stereo_features},
               {ID_EFFECT, INSTRUMENT_EFFECT, effect_features}};

#define PLUGINS (sizeof plugins / sizeof plugins[0])

static clap_plugin_descriptor_t descriptors[PLUGINS];

static uint32_t count(const clap_plugin_factory_t *factory) {
  (void)factory;
  return PLUGINS;
}

static const clap_plugin_descriptor_t *get_descriptor(const clap_plugin_factory_t *factory,
                                                      uint32_t index) {
  (void)factory;
  return index < PLUGINS ? &descriptors[index] : NULL;
}

static const clap_plugin_t *create(const clap_plugin_factory_t *factory, const clap_host_t *host,
                                   const char *id) {
  (void)factory;
  if (!clap_version_is_compatible(host->clap_version)) return NULL;
  for (size_t i = 0; i < PLUGINS; i++) {
    if (strcmp(id, plugins[i].id) == 0)
      return instance_create(&descriptors[i], host, &instrument_kinds[plugins[i].kind]);
  }
  return NULL;
}

static const clap_plugin_factory_t plugin_factory = {
  .get_plugin_count = count, .get_plugin_descriptor = get_descriptor, .create_plugin = create};

static void describe(size_t number) {
  const InstrumentKind *const kind = &instrument_kinds[plugins[number].kind];
  descriptors[number] = (clap_plugin_descriptor_t){.clap_version = CLAP_VERSION_INIT,
                                                   .id = plugins[number].id,
                                                   .name = kind->name,
                                                   .vendor = "Tabor",
                                                   .url = TABOR_REPOSITORY,
                                                   .manual_url = TABOR_REPOSITORY,
                                                   .support_url = TABOR_REPOSITORY,
                                                   .version = VERSION_TEXT,
                                                   .description = kind->brief,
                                                   .features = plugins[number].features};
}

/* CLAP calls it before all else, from one thread. */
static bool init(const char *path) {
  (void)path;
  for (size_t i = 0; i < PLUGINS; i++) describe(i);
  return true;
}

static void deinit(void) {}

static const void *get_factory(const char *id) {
  const bool is_presets = strcmp(id, CLAP_PRESET_DISCOVERY_FACTORY_ID) == 0 ||
                          strcmp(id, CLAP_PRESET_DISCOVERY_FACTORY_ID_COMPAT) == 0;
  if (is_presets) return &presets_factory;
  return strcmp(id, CLAP_PLUGIN_FACTORY_ID) == 0 ? &plugin_factory : NULL;
}

CLAP_EXPORT const clap_plugin_entry_t clap_entry = {
  .clap_version = CLAP_VERSION_INIT, .init = init, .deinit = deinit, .get_factory = get_factory};
