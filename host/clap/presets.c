/* SPDX-License-Identifier: MIT */
/* How the plugins load presets. */
#include <stdio.h>
#include <string.h>

#include "clap/instance_drum.h"
#include "clap/kit_instance.h"
#include "clap/parameters.h"
#include "clap/presets.h"
#include "drums/drum_file.h"

#define MESSAGE (2 * TABOR_TEXT_SIZE)

/* Where a preset is, as the host says. */
typedef struct Place {
  uint32_t kind;
  const char *location, *key;
} Place;

static bool is_file(const Place *place) {
  return place->kind == CLAP_PRESET_DISCOVERY_LOCATION_FILE && place->location;
}

static bool is_built_in(const Place *place) {
  return place->kind == CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN && place->key;
}

/* Tells the host; returns whether it is loaded. */
static bool answer(const clap_host_t *host, const Place *place, bool is_loaded,
                   const char *message) {
  const clap_host_preset_load_t *loader = host->get_extension(host, CLAP_EXT_PRESET_LOAD);
  if (!loader) loader = host->get_extension(host, CLAP_EXT_PRESET_LOAD_COMPAT);
  if (loader && is_loaded) loader->loaded(host, place->kind, place->location, place->key);
  if (loader && !is_loaded)
    loader->on_error(host, place->kind, place->location, place->key, 0, message);
  return is_loaded;
}

/* ---- one drum ------------------------------------------------------------------------------- */

static bool read_built_in_drum(const char *name, TaborDrumDef *def, char *message) {
  TaborError error;
  if (tabor_drum_def_preset(def, name, &error) == TABOR_OK) return true;
  (void)snprintf(message, MESSAGE, "%s", error.message);
  return false;
}

static bool read_drum_file(const char *path, TaborDrumDef *def, char *message) {
  TaborError error;
  if (drum_file_read(path, def, message, MESSAGE) != PRESET_FILE_OK) return false;
  if (tabor_drum_def_validate(def, &error) == TABOR_OK) return true;
  (void)snprintf(message, MESSAGE, "%s: %s", path, error.message);
  return false;
}

static bool read_drum(const Place *place, TaborDrumDef *def, char *message) {
  if (is_built_in(place)) return read_built_in_drum(place->key, def, message);
  if (is_file(place)) return read_drum_file(place->location, def, message);
  (void)snprintf(message, MESSAGE, "presets are built-in drums or files");
  return false;
}

/* Knobs stand where the drum is; of parts that it lacks, where they stood. So does KNOB_DRUM with a drum of the user's. */
static void load_drum(Instance *instance, const TaborDrumDef *def) {
  SavedState saved = {.def = *def};
  for (uint32_t i = 0; i < KNOB_SEEN; i++) {
    parameters_set(instance, (KnobId)i, knob_shown(def, (KnobId)i)); /* a NaN does nothing */
    saved.seen[i] = atomic_load(&instance->values[i]);
  }
  instance_restore(instance, &saved);
  parameters_tell(instance);
}

static bool drum_from(const clap_plugin_t *plugin, uint32_t kind, const char *location,
                      const char *key) {
  Instance *const instance = instance_of(plugin);
  const Place place = {kind, location, key};
  char message[MESSAGE];
  TaborDrumDef def;
  const bool is_read = read_drum(&place, &def, message);
  if (is_read) load_drum(instance, &def);
  return answer(instance->host, &place, is_read, message);
}

const clap_plugin_preset_load_t instance_preset_load = {.from_location = drum_from};

/* ---- a kit ---------------------------------------------------------------------------------- */

/* The value of KIT_KNOB_KIT for a built-in kit. */
static bool find_kit(const char *name, float *value, char *message) {
  for (uint32_t i = 0; i < tabor_kit_count(); i++) {
    if (strcmp(tabor_kit(i)->name, name) != 0) continue;
    *value = (float)i;
    return true;
  }
  (void)snprintf(message, MESSAGE, "there is no kit '%.80s'", name);
  return false;
}

static bool read_kit(KitInstance *instance, const Place *place, float *value, char *message) {
  if (is_built_in(place)) return find_kit(place->key, value, message);
  *value = kit_knobs[KIT_KNOB_KIT].maximum;
  if (is_file(place)) return own_kit_load(&instance->own, place->location, message, MESSAGE);
  (void)snprintf(message, MESSAGE, "presets are built-in kits or files");
  return false;
}

static bool kit_from(const clap_plugin_t *plugin, uint32_t kind, const char *location,
                     const char *key) {
  KitInstance *const instance = kit_instance_of(plugin);
  const Place place = {kind, location, key};
  char message[MESSAGE];
  float value;
  const bool is_read = read_kit(instance, &place, &value, message);
  if (is_read) {
    atomic_store(&instance->values[KIT_KNOB_KIT], value);
    kit_parameters_tell(instance);
  }
  return answer(instance->host, &place, is_read, message);
}

const clap_plugin_preset_load_t kit_preset_load = {.from_location = kit_from};
