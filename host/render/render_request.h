/* SPDX-License-Identifier: MIT */
/**
 * @file render_request.h
 * What `tabor render` is asked to do; render_options.h reads it.
 */
#ifndef TABOR_HOST_RENDER_REQUEST_H
#define TABOR_HOST_RENDER_REQUEST_H

#include "files/audio_file.h"
#include "midi/midi_song.h"
#include "strokes/strokes.h"

#define MOST_CHANNELS 64

typedef struct RenderRequest {
  const char *preset;
  TaborDrumDef def;
  TaborModelOptions model;
  Strokes strokes;              /**< and all other events */
  MidiSong song;                /**< what a MIDI file does beside them */
  AudioFormat audio;            /**< of each file */
  uint32_t channels;            /**< of the whole sound */
  uint32_t mics[MOST_CHANNELS]; /**< of each channel: index into the definition's microphones */
  uint32_t frames;              /**< how many, or 0: until the drum has died away */
  bool split;                   /**< a file for each channel */
  bool normalize;               /**< the gain is yet to be found */
  double gain;                  /**< factor */
  double gain_db;               /**< the same [dB] */
  bool json, quiet, verbose;
  OutputFile outputs[TABOR_MAX_MICS]; /**< planned sound files */
  uint32_t output_count;
  char *names[TABOR_MAX_MICS]; /**< of these, if split */
  OutputFile trace;            /**< planned, if has_trace */
  bool has_trace;
} RenderRequest;

/** What a request is before it is read: safe to free with render_request_free(). */
void render_request_clear(RenderRequest *request);
void render_request_free(RenderRequest *request);
/** Frame of the last thing that happens. */
uint32_t render_request_last_frame(const RenderRequest *request);
/** The same, but for releases. */
uint32_t render_request_last_stroke(const RenderRequest *request);

#endif
