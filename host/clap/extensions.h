/* SPDX-License-Identifier: MIT */
/**
 * @file extensions.h
 * What the extensions of all CLAP plugins have in common, those of one drum and those of a kit.
 */
#ifndef TABOR_CLAP_EXTENSIONS_H
#define TABOR_CLAP_EXTENSIONS_H

#include <clap/clap.h>

#include "base/realtime.h"

typedef struct Extension {
  const char *id;
  const void *extension;
} Extension;

/** The extension @p id among the @p count of @p all; NULL if it is none of them. */
const void *extension_find(const Extension *all, size_t count, const char *id);

/** One input of notes, no output. */
extern const clap_plugin_note_ports_t extension_note_input;

/** Whether the plugin must run in real time: never. */
bool extension_has_deadline(const clap_plugin_t *plugin);

/** AUDIO. Where a channel of an output of @p block goes; NULL if the host leaves it out. */
float *extension_channel(const clap_process_t *block, uint32_t port, uint32_t channel) REALTIME;

#endif
