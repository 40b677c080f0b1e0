/* SPDX-License-Identifier: MIT */
/**
 * @file presets.h
 * The built-in drums as presets of the CLAP plugins: found by presets_factory, loaded by instance_preset_load. The key
 * of a preset is its name.
 */
#ifndef TABOR_CLAP_PRESETS_H
#define TABOR_CLAP_PRESETS_H

#include "clap/instance.h"

extern const clap_plugin_preset_load_t instance_preset_load;
extern const clap_preset_discovery_factory_t presets_factory;

#endif
