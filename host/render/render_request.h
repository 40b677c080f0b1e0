/* SPDX-License-Identifier: MIT */
/**
 * @file render_request.h
 * What `tabor render` is asked to do, checked in full before anything is computed or touched.
 */
#ifndef TABOR_HOST_RENDER_REQUEST_H
#define TABOR_HOST_RENDER_REQUEST_H

#include "base/options.h"
#include "files/audio_file.h"
#include "midi/midi_song.h"
#include "strokes/strokes.h"

#define MOST_CHANNELS 64
#define DEFAULT_ENCODING "pcm24"

/** Rows of the option tables for what render_request_read() reads. */
#define OPTION_FORMAT                                                                              \
  { "format", 0, "FORMAT", "pcm16, pcm24 or float (default " DEFAULT_ENCODING ")" }
#define OPTION_DURATION                                                                            \
  { "duration", 0, "SECONDS", "length, 0.01 to 3600 (default: until the drum has died away)" }
#define OPTION_MIC                                                                                 \
  { "mic", 0, "NAME", "microphone, a channel each (repeatable; default: the preset's first)" }
#define OPTION_GAIN                                                                                \
  { "gain", 0, "DB", "amplification, -120 to 120 (default 0)" }
#define OPTION_JOBS                                                                                \
  { "jobs", 'j', "N", "sounds to render at once, 1 to 256 (default: the number of processors)" }

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

extern const Option render_options[];

/** What a request is before it is read: safe to free. */
void render_request_clear(RenderRequest *request);
/** Reads the command line. Free with render_request_free(), whatever the outcome. */
Outcome render_request_read(const Arguments *arguments, RenderRequest *request);
void render_request_free(RenderRequest *request);
/** Frame of the last thing that happens. */
uint32_t render_request_last_frame(const RenderRequest *request);

#endif
