/* SPDX-License-Identifier: MIT */
/**
 * @file play_request.h
 * The request to `tabor play`, checked before anything is opened.
 */
#ifndef TABOR_HOST_PLAY_REQUEST_H
#define TABOR_HOST_PLAY_REQUEST_H

#include "base/options.h"
#include "kit/kit_midi.h"
#include "kit/kit_sample_files.h"
#include "midi/midi_song_input.h"
#include "play/backend.h"
#include "play/record_request.h"
#include "strokes/humanize.h"
#include "ui/keymap.h"

typedef struct PlayRequest {
  const Arguments *arguments;
  const char *preset; /**< of the drum, or the kit's name */
  TaborDrumDef def;   /**< of a kit the first drum's */
  TaborKitDef *kit;   /**< or NULL */
  KitMidiSetup kit_midi;
  TaborModelOptions model; /**< the rate is the device's */
  uint32_t channels;
  uint32_t mics[TABOR_MAX_MICS]; /**< of each channel: index among the definition's microphones; of
                                    a kit, 0 left, 1 right */
  double gain;                   /**< factor */
  Humanizer humanizer;
  MidiMap midi_map;
  double mask_time; /**< [s] */
  MidiSong song;    /**< from --midi-file */
  Keymap keymap;    /**< actions of the computer keyboard */
  double duration;  /**< [s], or 0: no limit */
  const Backend *backend;
  BackendRequest device;
  RecordRequest record; /**< its rate is the device's */
  bool logs;
  OutputFile log;   /**< planned, if logs */
  uint32_t threads; /**< that compute a kit */
  bool json, quiet, no_ui;
} PlayRequest;

extern const Option play_options[];

/** Reads the command line, which must outlive the request. Free with play_request_free(), whatever
 * the outcome. */
Outcome play_request_read(const Arguments *arguments, PlayRequest *request);
/** Initialises the MIDI of the kit. */
void play_request_kit_midi(const PlayRequest *request, KitMidi *midi);
void play_request_free(PlayRequest *request);

#endif
