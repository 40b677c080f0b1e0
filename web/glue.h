/* SPDX-License-Identifier: MIT */
/**
 * @file glue.h
 * A drum in its room, or a kit, for JavaScript: what the page and the package for npm call of the
 * engine as WebAssembly (docs/web.md), by the same functions for both. A drum alone is number 0 of
 * its instrument.
 *
 * An instrument is first a definition, which instrument_create() takes from a preset or a built-in
 * kit and instrument_set() changes; instrument_build() then makes it sound. In the page a worker
 * does this, and copies its memory to an instance on the audio thread. So all that an instrument
 * consists of lies in memory, and addresses mean the same in both.
 *
 * | file | what it exports |
 * |---|---|
 * | instrument_glue.c | presets, and what an instrument is |
 * | definition_glue.c | numbers of a drum's definition |
 * | build_glue.c | models, beginning and end |
 * | play_glue.c | what happens to it, and its sound |
 * | picture_glue.c | pictures of a drum that sounds, and its modes |
 * | midi_glue.c | MIDI, live and from files |
 */
#ifndef TABOR_WEB_GLUE_H
#define TABOR_WEB_GLUE_H

#include "kit/kit_midi.h"
#include "kit/song_events.h"
#include "sound/ring_out.h"
#include "tabor/kit.h"

enum { BLOCK = 128, MOST_CHANNELS = DRUM_PLAYER_OUTPUTS };

/* Of a picture: two heads on 16 by 48 places, the heights of 40 wires and the forces on them, and
 * sticks. */
enum { PICTURES = 4, WIRE_POINTS = 17, PICTURE_STICKS = 4, STICK_VALUES = 4 };
enum {
  MOST_PLACES = 2 * 16 * 48,
  MOST_POINTS = 2 * TABOR_MAX_WIRES * WIRE_POINTS,
  MOST_VALUES = MOST_PLACES + MOST_POINTS + 1 + PICTURE_STICKS * STICK_VALUES
};

#define EXPORT(name) __attribute__((export_name(name)))
#define IMPORT(name) __attribute__((import_module("tabor"), import_name(name)))

/* Hears how far a model is, 0 to 1. False ends the build. */
IMPORT("progress") bool report_progress(double done);

/* What a MIDI message or an event of a file does, as numbers for JavaScript. */
typedef struct WebMidiAction {
  double kind;                     /* a WebMidiKind */
  double drum;                     /* of a kit */
  double value;                    /* speed of the stick [m/s]; position of the strainer */
  double radius, angle, technique; /* of a stroke [m], [deg] */
  double frame;                    /* of a file's event, from its beginning */
  double striker;                  /* of a stroke */
} WebMidiAction;

typedef enum WebMidiKind { WEB_MIDI_NOTHING, WEB_MIDI_STROKE, WEB_MIDI_STRAINER } WebMidiKind;

typedef struct WebInstrument {
  bool is_kit;
  TaborKitDef def; /* of a drum alone only def.drum[0].def */
  TaborError error;
  char text[2 * TABOR_TEXT_SIZE]; /* for JavaScript, until the next call */

  /* the channels: of a drum microphones, of a kit the mix and the parts of drums in it */
  uint32_t channels;              /* 0 before it is built, unless some are chosen */
  uint32_t chosen[MOST_CHANNELS]; /* microphone or drum of each channel */
  bool is_pair;                   /* no microphones are chosen: a drum is heard by left and right */
  bool is_room_chosen;            /* by instrument_set() */

  /* once it is built */
  TaborModel *models[TABOR_KIT_DRUMS];
  TaborView *views[TABOR_KIT_DRUMS];
  uint32_t building, modes; /* number of the drum that is being built; of modes */
  TaborKit *kit;            /* or */
  TaborDrum *drum;          /* in its */
  RoomMix room;
  double rate;       /* [Hz] */
  DrumPlayer player; /* the one of `tabor render`, too */
  RingOut ring_out;

  PlayerMessage *messages; /* of the next block, in order of their frames */
  uint32_t message_count, message_room, taken;
  PlayerMessage message; /* of a song, for JavaScript */
  float sound[MOST_CHANNELS][BLOCK];
  TaborLedger ledger;
  uint32_t filmed;                        /* number of the drum of the pictures */
  float pictures[PICTURES * MOST_VALUES]; /* of the last block, one after the other */

  KitMidi *kit_midi; /* of a kit, NULL before instrument_begin_midi() */
  MidiMap map;       /* of a drum alone */
  MidiToEvents midi;
  WebMidiAction midi_action;
} WebInstrument;

/* The definition of a drum: of one alone that is built, the model's. */
const TaborDrumDef *web_definition(const WebInstrument *web, uint32_t drum);
/* Index of the striker with which a drum is struck unless another one is named. */
uint32_t web_definition_own_striker(const TaborDrumDef *def);
/* The player's output of a channel. */
uint32_t web_output(const WebInstrument *web, uint32_t channel);
/* Adds a message to the next block, at a frame of it. False if there is no memory. */
bool web_add(WebInstrument *web, uint32_t frame, const PlayerMessage *message);
/* The same of an event. */
bool web_add_event(WebInstrument *web, uint32_t drum, const TaborEvent *event);
/* Room for messages before there are any, since memory of an audio thread does not grow. */
bool web_make_room(WebInstrument *web);
/* The drum that sounds; NULL if there is none. */
const TaborDrum *web_drum(const WebInstrument *web, uint32_t drum);
/* Takes a picture to `to`, if the view fits. */
void web_take_picture(WebInstrument *web, float *to);
/* Numbers of a picture of a drum. */
uint32_t web_picture_size(const WebInstrument *web, uint32_t drum);

#endif
