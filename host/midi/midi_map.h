/* SPDX-License-Identifier: MIT */
/**
 * @file midi_map.h
 * Maps notes to strokes and controllers to parameters: a plain table, the same for live playing,
 * MIDI files and the plugins.
 *
 * | note                  | stroke          |   | controller  | moves                         |
 * |-----------------------|-----------------|---|-------------|-------------------------------|
 * | 38, 41 43 45 47 48 50 | head            |   | 16          | radius of strokes on the head |
 * | 36                    | head, at centre |   | 17          | their angle                   |
 * | 40                    | rimshot         |   | 1           | grip                          |
 * | 37                    | cross-stick     |   | 20          | strainer, 64 is the preset's  |
 * | 39                    | rim             |   | 4           | opening of a hi-hat           |
 * | 42, 44, 46            | closed, pedal, open: of a hi-hat | 7 and 11 | gain                |
 * | others                | none            |   | 120 and 123 | silence                       |
 */
#ifndef TABOR_HOST_MIDI_MAP_H
#define TABOR_HOST_MIDI_MAP_H

#include <tabor/tabor.h>

#include "midi/midi_speed.h"
#include "midi/midi_stream.h"

#define MIDI_OMNI (-1) /**< every channel */
/** Controller for the low bits of the next note's velocity (MIDI's CA-031), unless the map uses it.
 */
#define MIDI_HIGH_RESOLUTION_PREFIX 88

/**
 * True for notes, pressure and velocity prefixes. At one frame, these messages act last and keep
 * their order; controllers and program changes act first.
 */
static inline bool midi_goes_with_notes(const MidiMessage *message) {
  const uint8_t kind = midi_kind(message);
  if (kind == MIDI_CONTROL) return message->data[0] == MIDI_HIGH_RESOLUTION_PREFIX;
  return kind != MIDI_PROGRAM;
}

/** The stroke of a note. */
typedef enum MidiStroke {
  MIDI_STROKE_NONE,
  MIDI_STROKE_HEAD,
  MIDI_STROKE_RIMSHOT,
  MIDI_STROKE_CROSS_STICK,
  MIDI_STROKE_RIM,
  MIDI_STROKE_BUZZ,  /**< stick pressed until the note ends; key pressure sets the force */
  MIDI_STROKE_SWEEP, /**< brush sweep until the note ends; controllers and pressure move it */
  MIDI_STROKE_BELL,  /**< of a cymbal, as the next two: with the striker `bell` */
  MIDI_STROKE_BOW,   /**< with the striker `tip` */
  MIDI_STROKE_EDGE,  /**< with the striker `shoulder` */
  /** of a hi-hat, as the next two: the foot closes it, unless a controller moves the pedal */
  MIDI_STROKE_CLOSED,
  MIDI_STROKE_OPEN,  /**< the foot opens it, likewise */
  MIDI_STROKE_PEDAL, /**< the foot stamps */
  MIDI_STROKE_COUNT
} MidiStroke;

/** Names of the strokes in the order of MidiStroke, which is that of TaborKitStroke, then NULL. */
extern const char *const midi_stroke_names[];

typedef struct MidiNote {
  MidiStroke stroke;
  double radius; /**< fraction of the head's, 0 to 1; NaN: the controller's, else the preset's */
  double angle;  /**< [deg]; NaN: the controller's, else the preset's */
  double speed;  /**< factor, 0.01 to 10 */
  char striker[TABOR_NAME_SIZE]; /**< name; "" or unknown to the drum: the preset's */
} MidiNote;

/** The target of a controller. */
typedef enum MidiTarget {
  MIDI_TARGET_NONE,
  MIDI_TARGET_RADIUS,   /**< 0: centre, 127: just inside the rim */
  MIDI_TARGET_ANGLE,    /**< 0 to 127: one turn */
  MIDI_TARGET_GRIP,     /**< the hand's grip over its range, if the drum has one */
  MIDI_TARGET_STRAINER, /**< 0: off, 64: the preset's, 127: on */
  MIDI_TARGET_GAIN,     /**< (value/127)^2; several controllers multiply */
  MIDI_TARGET_SILENCE,  /**< at any value */
  MIDI_TARGET_OPENING,  /**< of a hi-hat: 0: open, 112: closed, 127: twice as tight */
  MIDI_TARGET_PARAMETER /**< a live parameter, from 0 to 127 over a range */
} MidiTarget;

typedef struct MidiControl {
  MidiTarget target;
  char key[TABOR_NAME_SIZE]; /**< key of the live parameter, "wires.tension" */
  double from, to;           /**< values of the parameter at 0 and 127 */
} MidiControl;

/** A complete map. Plain data. */
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
