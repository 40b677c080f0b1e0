/* SPDX-License-Identifier: MIT */
/**
 * @file ports.h
 * Sound that goes in and comes out of the CLAP plugins of one drum. Their first output is the stereo pair; in the plugin
 * with an output per microphone those of the others follow. Latency, tail and render mode are here, too.
 */
#ifndef TABOR_CLAP_PORTS_H
#define TABOR_CLAP_PORTS_H

#include "clap/instance.h"

extern const clap_plugin_audio_ports_t instance_audio_ports;
extern const clap_plugin_latency_t instance_latency;
extern const clap_plugin_tail_t instance_tail;
extern const clap_plugin_render_t instance_render;

/** AUDIO. Finds where the channels of @p process go; one that the host leaves out is NULL. */
void ports_connect(const Instance *instance, const clap_process_t *process,
                   PluginOutputs *outputs) REALTIME;

#endif
