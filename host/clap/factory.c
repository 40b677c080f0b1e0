/* SPDX-License-Identifier: MIT */
/* The entry point of tabor.clap: which plugins and presets it has. */
#include <string.h>

#include "clap/instance.h"
#include "clap/kit_instance.h"
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

#define PLUGIN(its_id, its_name, its_features, its_description)                                    \
  {                                                                                                \
    .clap_version = CLAP_VERSION_INIT, .id = (its_id), .name = (its_name), .vendor = "Tabor",      \
    .url = "", .manual_url = "", .support_url = "", .version = VERSION_TEXT,                       \
    .description = (its_description), .features = (its_features)                                   \
  }

static const clap_plugin_descriptor_t plugins[] = {
  PLUGIN(ID_DRUM, "Tabor", stereo_features, "A snare drum computed from physics"),
  PLUGIN(ID_DRUM_MULTI, "Tabor Multi", stereo_features,
         "A snare drum computed from physics, an output per microphone"),
  PLUGIN(ID_KIT, "Tabor Kit", stereo_features,
         "A drum kit computed from physics, an output per drum"),
  PLUGIN(ID_EFFECT, "Tabor Rattle", effect_features,
         "A loudspeaker plays the sound to a snare drum, whose snares rattle"),
};

#define PLUGINS (sizeof plugins / sizeof plugins[0])

static uint32_t count(const clap_plugin_factory_t *factory) {
  (void)factory;
  return PLUGINS;
}

static const clap_plugin_descriptor_t *get_descriptor(const clap_plugin_factory_t *factory,
                                                      uint32_t index) {
  (void)factory;
  return index < PLUGINS ? &plugins[index] : NULL;
}

static const clap_plugin_t *create(const clap_plugin_factory_t *factory, const clap_host_t *host,
                                   const char *id) {
  (void)factory;
  if (!clap_version_is_compatible(host->clap_version)) return NULL;
  size_t i = 0;
  while (i < PLUGINS && strcmp(id, plugins[i].id) != 0) i++;
  if (i == PLUGINS) return NULL;
  if (strcmp(id, ID_KIT) == 0) return kit_instance_create(&plugins[i], host);
  if (strcmp(id, ID_EFFECT) == 0) return instance_create(&plugins[i], host, KNOBS_EFFECT);
  return instance_create(&plugins[i], host, strcmp(id, ID_DRUM) == 0 ? KNOBS_STEREO : KNOBS_MULTI);
}

static const clap_plugin_factory_t plugin_factory = {
  .get_plugin_count = count, .get_plugin_descriptor = get_descriptor, .create_plugin = create};

static bool init(const char *path) {
  (void)path;
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
