/* SPDX-License-Identifier: MIT */
/**
 * @file midi_to_events.h
 * Converts MIDI messages to actions of a drum: events for the engine, and gain, preset changes and
 * silence. A message is a bounded amount of work and gives at most MIDI_MOST_ACTIONS actions. There
 * are no side effects.
 *
 * Strokes take radius and angle from the controllers, or from the preset's [strike] until a
 * controller has moved. Pressure lays a hand on the head at half its radius, opposite to the
 * preset's stroke: from 0.06 N s/m for 1 to 6 N s/m for 127 in equal ratios. 6 N s/m mutes best; a
 * stronger hand would hold the head still under it and let the rest of the head ring. A cymbal it
 * grips at its edge, with up to 30 N s/m, as drummers choke one.
 *
 * Controller 121 undoes what MIDI's RP-015 names: expression (11) goes to 127, modulation (1) to 0,
 * if they have moved; hands that pressure has laid on the head are lifted, and a prefix is
 * forgotten. Volume (7) and the places of strokes (16, 17) and the strainer (20) stay.
 *
 * Notes for a closed and an open hi-hat move its pedal first, until a controller has moved it: then
 * the foot alone decides.
 *
 * A sweep note starts at the position of strokes and circles the centre. Its speed is proportional
 * to the velocity and equals the brush's sweep_speed at 64. Controllers of the position then move
 * the brush. Key pressure of the note, and channel pressure during the note, set the pressure of
 * the brush.
 */
#ifndef TABOR_HOST_MIDI_TO_EVENTS_H
#define TABOR_HOST_MIDI_TO_EVENTS_H

#include "base/realtime.h"
#include "midi/midi_map.h"

typedef enum MidiActionType {
  MIDI_ACTION_EVENT = 1, /**< for tabor_drum_process(); the caller sets its frame */
  MIDI_ACTION_GAIN,      /**< sets the output gain to value */
  MIDI_ACTION_PRESET,    /**< changes to the built-in preset number preset */
  MIDI_ACTION_SILENCE    /**< silences everything at once */
} MidiActionType;

typedef struct MidiAction {
  MidiActionType type;
  TaborEvent event;
  double value;    /**< gain, factor */
  uint32_t preset; /**< index for tabor_preset() */
} MidiAction;

/** A live parameter, as identified in events. */
typedef struct MidiParameter {
  bool there; /**< the drum has it */
  uint32_t id, index;
  double minimum, maximum;
  bool logarithmic;
} MidiParameter;

#define MIDI_NO_BRUSH UINT32_MAX
#define MIDI_MOST_ACTIONS 4 /**< of one message */

/** The map resolved for one drum. Plain data: copy it by assignment. */
typedef struct MidiBinding {
  double head_radius;   /**< [m] */
  double radius, angle; /**< of the preset's stroke [m], [deg] */
  uint32_t striker;     /**< index of its striker */
  /** Index of each note's striker; for a sweep on a drum without a brush, MIDI_NO_BRUSH. */
  uint32_t strikers[MIDI_VALUES];
  double sweep_speed[MIDI_VALUES]; /**< of each note that sweeps [m/s] */
  double strainer;                 /**< the preset's strainer */
  uint32_t presets;                /**< number of presets that programs may choose */
  MidiParameter grip, strainer_parameter, opening;
  double open, closed;                   /**< openings of a hi-hat [m] */
  bool plate;                            /**< hands grip its edge */
  MidiParameter parameters[MIDI_VALUES]; /**< targets of the controllers */
} MidiBinding;

/** Numbers of used and ignored notes. */
typedef struct MidiCounts {
  uint64_t strokes;
  uint64_t ignored_notes; /**< not in the map */
} MidiCounts;

typedef struct MidiToEvents {
  const MidiMap *map;
  MidiBinding binding;         /**< of the drum that plays; assign another when it changes */
  uint8_t values[MIDI_VALUES]; /**< last value of each controller */
  bool moved[MIDI_VALUES];     /**< controllers received so far */
  double radius, angle;        /**< set by controllers: fraction of the head's, [deg]; NaN before */
  uint8_t prefixes[MIDI_CHANNELS]; /**< low bits for the next note's velocity */
  bool hands[2];                   /**< a hand is on the head, by channel and by key pressure */
  bool held[MIDI_VALUES];          /**< notes that are buzzing or sweeping */
  bool pedalled;                   /**< a controller has moved the pedal of a hi-hat */
  int sweeping;                    /**< note of the latest sweep while it lasts, else -1 */
  uint32_t next_id;                /**< id of the next stroke */
  MidiCounts counts;
} MidiToEvents;

/** SET-UP. Resolves @p map for @p def. */
void midi_binding_make(const MidiMap *map, const TaborDrumDef *def, MidiBinding *binding);
/** AUDIO. Starts; @p map must outlive @p drum. */
void midi_to_events_begin(MidiToEvents *drum, const MidiMap *map,
                          const MidiBinding *binding) REALTIME;
/** AUDIO. Writes what @p message does to @p actions; returns how many actions. */
uint32_t midi_to_events_take(MidiToEvents *drum, const MidiMessage *message,
                             MidiAction actions[MIDI_MOST_ACTIONS]) REALTIME;

#endif
