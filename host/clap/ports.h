/* SPDX-License-Identifier: MIT */
/**
 * @file ports.h
 * What goes in and comes out of the CLAP plugins: notes, whose names follow what plays them, sound,
 * and how long it rings. The first output is in stereo. Latency and render mode are here, too.
 */
#ifndef TABOR_CLAP_PORTS_H
#define TABOR_CLAP_PORTS_H

#include "clap/instance.h"

extern const clap_plugin_audio_ports_t ports_audio;
extern const clap_plugin_note_ports_t ports_notes;
extern const clap_plugin_note_name_t ports_note_names;
extern const clap_plugin_latency_t ports_latency;
extern const clap_plugin_tail_t ports_tail;
extern const clap_plugin_render_t ports_render;

/** AUDIO. Finds where the channels of @p block go; one that the host leaves out is NULL. */
void ports_connect(Instrument *instrument, const clap_process_t *block) REALTIME;

#endif
