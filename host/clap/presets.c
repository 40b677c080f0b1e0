/* SPDX-License-Identifier: MIT */
/* How the plugins load presets. */
#include "clap/presets.h"

#include <stdio.h>

#include "clap/host_calls.h"

static bool read_preset(Instrument *instrument, uint32_t kind, const char *location,
                        const char *key, InstrumentSetting *setting, char *message) {
  const bool is_file = kind == CLAP_PRESET_DISCOVERY_LOCATION_FILE;
  const char *const name = is_file ? location : key;
  if (name && (is_file || kind == CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN))
    return instrument->kind->calls->load(instrument, name, is_file, setting, message);
  (void)snprintf(message, INSTRUMENT_MESSAGE, "presets are built-in drums or kits, or files");
  return false;
}

/* Tells the host whether it is loaded. */
static bool from_location(const clap_plugin_t *plugin, uint32_t kind, const char *location,
                          const char *key) {
  Instance *const instance = instance_of(plugin);
  const clap_host_t *const host = instance->host;
  const clap_host_preset_load_t *loader = host->get_extension(host, CLAP_EXT_PRESET_LOAD);
  char message[INSTRUMENT_MESSAGE];
  InstrumentSetting setting;
  if (!loader) loader = host->get_extension(host, CLAP_EXT_PRESET_LOAD_COMPAT);
  instrument_note(instance->instrument, &setting);
  const bool is_read = read_preset(instance->instrument, kind, location, key, &setting, message);
  if (is_read) host_use(instance, &setting);
  if (loader && is_read) loader->loaded(host, kind, location, key);
  if (loader && !is_read) loader->on_error(host, kind, location, key, 0, message);
  return is_read;
}

const clap_plugin_preset_load_t presets_load = {.from_location = from_location};
