/* SPDX-License-Identifier: MIT */
/**
 * @file presets.h
 * Presets of the CLAP plugins: the built-in drums and kits, whose keys are their names, and the
 * user's preset and kit files. presets_factory finds them; the plugins load them.
 */
#ifndef TABOR_CLAP_PRESETS_H
#define TABOR_CLAP_PRESETS_H

#include <clap/clap.h>

extern const clap_plugin_preset_load_t presets_load;
extern const clap_preset_discovery_factory_t presets_factory;

#endif
