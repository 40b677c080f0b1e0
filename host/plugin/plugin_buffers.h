/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_buffers.h
 * The sound of a host's block: a buffer for each channel that a plugin has, in the order of its
 * instrument.
 */
#ifndef TABOR_PLUGIN_PLUGIN_BUFFERS_H
#define TABOR_PLUGIN_PLUGIN_BUFFERS_H

#define PLUGIN_CHANNELS 18 /**< most channels of an instrument: a mix and eight drums in stereo */

/** What is NULL goes nowhere. */
typedef struct PluginBuffers {
  float *channels[PLUGIN_CHANNELS];
  const float *input[2]; /**< of an effect, both or none */
} PluginBuffers;

#endif
