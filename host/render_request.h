/* SPDX-License-Identifier: MIT */
/**
 * @file render_request.h
 * What `tabor render` is asked to do, checked in full before anything is computed or touched.
 */
#ifndef TABOR_HOST_RENDER_REQUEST_H
#define TABOR_HOST_RENDER_REQUEST_H

#include "audio_file.h"
#include "options.h"
#include "strokes.h"

#define MOST_CHANNELS 64

typedef struct RenderRequest {
  const char *preset;
  TaborDrumDef def;
  TaborModelOptions model;
  Strokes strokes;
  AudioFormat audio;
  uint32_t mics[MOST_CHANNELS]; /**< of each channel: index into the definition's microphones */
  uint32_t frames;              /**< how many, or 0: until the drum has died away */
  double gain;                  /**< factor */
  double gain_db;               /**< the same [dB] */
  bool json, quiet, verbose;
  OutputFile output; /**< planned */
  OutputFile trace;  /**< planned, if has_trace */
  bool has_trace;
} RenderRequest;

extern const Option render_options[];

/** Reads the command line. Free with render_request_free(), whatever the outcome. */
Outcome render_request_read(const Arguments *arguments, RenderRequest *request);
void render_request_free(RenderRequest *request);

#endif
