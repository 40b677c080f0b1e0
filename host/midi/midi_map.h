/* SPDX-License-Identifier: MIT */
/**
 * @file midi_map.h
 * Which note is which stroke, and what each controller moves: a plain table, the same for a live
 * player, a MIDI file and a plugin.
 *
 * | note                    | stroke          |   | controller       | moves                          |
 * |-------------------------|-----------------|---|------------------|--------------------------------|
 * | 38, 41 43 45 47 48 50   | head            |   | 16               | radius of strokes on the head  |
 * | 36                      | head, at centre |   | 17               | their angle                    |
 * | 40                      | rimshot         |   | 1                | grip                           |
 * | 37                      | cross-stick     |   | 20               | strainer, 64 is the preset's   |
 * | 39                      | rim             |   | 7 and 11         | gain                           |
 * | others                  | none            |   | 120 and 123      | silence                        |
 */
#ifndef TABOR_HOST_MIDI_MAP_H
#define TABOR_HOST_MIDI_MAP_H

#include <tabor/tabor.h>

#include "midi/midi_speed.h"
#include "midi/midi_stream.h"

#define MIDI_OMNI (-1) /**< every channel */
/** Controller with the low bits of the next note's velocity (MIDI's CA-031), unless it is mapped. */
#define MIDI_HIGH_RESOLUTION_PREFIX 88

/**
 * Of messages at one frame, those that go with notes act last: notes, pressure, the prefix of a velocity,
 * whose order among each other is kept. Controllers and program changes act before.
 */
static inline bool midi_goes_with_notes(const MidiMessage *message) {
  const uint8_t kind = midi_kind(message);
  if (kind == MIDI_CONTROL) return message->data[0] == MIDI_HIGH_RESOLUTION_PREFIX;
  return kind != MIDI_PROGRAM;
}

/** What a note does. */
typedef enum MidiStroke {
  MIDI_STROKE_NONE,
  MIDI_STROKE_HEAD,
  MIDI_STROKE_RIMSHOT,
  MIDI_STROKE_CROSS_STICK,
  MIDI_STROKE_RIM,
  MIDI_STROKE_BUZZ, /**< pressed until the note ends; key pressure presses */
  MIDI_STROKE_SWEEP /**< of a brush, until the note ends; place and pressure move it */
} MidiStroke;

typedef struct MidiNote {
  MidiStroke stroke;
  double radius; /**< of the head's radius, 0 to 1; NaN: the controller's, else the preset's */
  double angle;  /**< [deg]; NaN: likewise */
  double speed;  /**< factor, 0.01 to 10 */
  char striker[TABOR_NAME_SIZE]; /**< its name; "", or none that the drum has: the preset's */
} MidiNote;

/** What a controller moves. */
typedef enum MidiTarget {
  MIDI_TARGET_NONE,
  MIDI_TARGET_RADIUS,   /**< 0 the centre, 127 just inside of the rim */
  MIDI_TARGET_ANGLE,    /**< 0 to 127: once around */
  MIDI_TARGET_GRIP,     /**< the hand's grip over its range, where the engine has one */
  MIDI_TARGET_STRAINER, /**< 0 off, 64 the preset's, 127 on */
  MIDI_TARGET_GAIN,     /**< (value/127)^2; several multiply */
  MIDI_TARGET_SILENCE,  /**< whatever the value */
  MIDI_TARGET_PARAMETER /**< a live parameter, from 0 to 127 over a range */
} MidiTarget;

typedef struct MidiControl {
  MidiTarget target;
  char key[TABOR_NAME_SIZE]; /**< of the live parameter, "wires.tension" */
  double from, to;           /**< its values for 0 and 127 */
} MidiControl;

/** All of it. Plain data. */
typedef struct MidiMap {
  MidiNote notes[MIDI_VALUES];
  MidiControl controls[MIDI_VALUES];
  MidiResponse response;
  int channel;   /**< 0 to 15, or MIDI_OMNI */
  bool pressure; /**< channel and key pressure damp */
  bool programs; /**< program changes choose presets */
} MidiMap;

/** The map above: linear curve, normal range, every channel, pressure and programs. */
void midi_map_default(MidiMap *map);

#endif
