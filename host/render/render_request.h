/* SPDX-License-Identifier: MIT */
/**
 * @file render_request.h
 * The request to `tabor render`; render_options.h reads it.
 */
#ifndef TABOR_HOST_RENDER_REQUEST_H
#define TABOR_HOST_RENDER_REQUEST_H

#include "drums/shared_models.h"
#include "files/sound_files.h"
#include "kit/kit_sample_files.h"
#include "kit/kit_song.h"
#include "midi/midi_song_input.h"
#include "render/replay.h"
#include "render/sound_input.h"
#include "strokes/strokes.h"

#define MOST_CHANNELS 64

typedef struct RenderRequest {
  const char *preset;            /**< of the drum, or the kit's name */
  TaborDrumDef def;              /**< of a kit the first drum's */
  const TaborKitDef *kit;        /**< or NULL */
  TaborKitDef *own_kit;          /**< the same, to be freed; or NULL */
  TaborModel *const *kit_models; /**< of its drums, or NULL: they are built */
  uint32_t threads;              /**< to build and compute a kit on */
  KitMidi *kit_midi;             /**< that has read the song, or NULL */
  KitSong kit_song;
  TaborModelOptions model;
  SharedModels *shared;         /**< models of the batch, or NULL */
  Strokes strokes;              /**< strokes and all other events */
  MidiSong song;                /**< other actions of a MIDI file */
  bool replays;                 /**< plays a log instead of strokes and song */
  Replay replay;                /**< the log */
  SoundInput input;             /**< a loudspeaker */
  AudioFormat audio;            /**< format of each file */
  uint32_t channels;            /**< number of channels, over all files */
  uint32_t mics[MOST_CHANNELS]; /**< of each channel: a DrumPlayer's output, a drum's microphone */
  uint32_t frames;              /**< length, or 0: until the drum has died away */
  bool split;                   /**< one file per microphone, or drum of the kit */
  bool normalize;               /**< find the gain from the peak of the sound */
  double gain;                  /**< factor */
  double gain_db;               /**< the same [dB] */
  bool json, quiet, verbose;
  OutputFile outputs[SOUND_FILES_MOST]; /**< planned sound files */
  uint32_t output_count;
  char *names[SOUND_FILES_MOST]; /**< their names, if split */
  OutputFile trace;              /**< planned, if has_trace */
  bool has_trace;
} RenderRequest;

/** Initialises an empty request, which is safe to free with render_request_free(). */
void render_request_clear(RenderRequest *request);
void render_request_free(RenderRequest *request);
/** Makes it a request for a kit, which must outlive it. */
void render_request_set_kit(RenderRequest *request, const TaborKitDef *kit);
/** Frame of the last event or action. */
uint32_t render_request_last_frame(const RenderRequest *request);
/** Frame of the last event or action that is not a release. */
uint32_t render_request_last_stroke(const RenderRequest *request);

#endif
