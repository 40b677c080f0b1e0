/* SPDX-License-Identifier: MIT */
/**
 * @file midi_to_events.h
 * MIDI messages into what a drum does: events for the engine, and the few things beside it. Data in,
 * data out; every message is a bounded amount of work and at most one action.
 *
 * Strokes take place and angle from the controllers once these have moved, from the preset's [strike]
 * before. Pressure lays a hand on the head at half its radius, opposite to the preset's stroke: from
 * 0.06 N s/m for 1 to 6 N s/m for 127 in equal ratios. That is the hand that mutes best; a stronger one holds
 * the head still where it lies, and lets it ring around.
 *
 * A note that sweeps begins where strokes fall, around the centre, as fast as its brush's sweep_speed at velocity 64 and
 * in proportion; controllers of place then move it. Its own key's pressure, and while it lasts the channel's,
 * is the brush's.
 */
#ifndef TABOR_HOST_MIDI_TO_EVENTS_H
#define TABOR_HOST_MIDI_TO_EVENTS_H

#include "base/realtime.h"
#include "midi/midi_map.h"

typedef enum MidiActionType {
  MIDI_ACTION_EVENT = 1, /**< for tabor_drum_process(); its frame is the caller's to set */
  MIDI_ACTION_GAIN,      /**< the output's gain from here on is value */
  MIDI_ACTION_PRESET,    /**< built-in preset number preset */
  MIDI_ACTION_SILENCE    /**< everything stops sounding at once */
} MidiActionType;

typedef struct MidiAction {
  MidiActionType type;
  TaborEvent event;
  double value;    /**< gain, factor */
  uint32_t preset; /**< index for tabor_preset() */
} MidiAction;

/** A live parameter as events name it. */
typedef struct MidiParameter {
  bool there; /**< the drum has it */
  uint32_t id, index;
  double minimum, maximum;
  bool logarithmic;
} MidiParameter;

#define MIDI_NO_BRUSH UINT32_MAX

/** What the map means on one drum. Plain data: copy it by assignment. */
typedef struct MidiBinding {
  double head_radius;   /**< [m] */
  double radius, angle; /**< of the preset's stroke [m], [deg] */
  uint32_t
    strikers[MIDI_VALUES]; /**< of each note: index; of a sweep MIDI_NO_BRUSH if there is none */
  double sweep_speed[MIDI_VALUES]; /**< of each note that sweeps [m/s] */
  double strainer;                 /**< the preset's */
  uint32_t presets;                /**< that programs may choose */
  MidiParameter grip, strainer_parameter;
  MidiParameter parameters[MIDI_VALUES]; /**< that controllers move */
} MidiBinding;

/** What came and was not used, and what was. */
typedef struct MidiCounts {
  uint64_t strokes;
  uint64_t ignored_notes; /**< not in the map */
} MidiCounts;

typedef struct MidiToEvents {
  const MidiMap *map;
  MidiBinding binding;             /**< of the drum that plays; assign another when it changes */
  uint8_t values[MIDI_VALUES];     /**< of controllers */
  bool moved[MIDI_VALUES];         /**< controllers that have come */
  double radius, angle;            /**< by controllers: of the head's radius, [deg]; NaN before */
  uint8_t prefixes[MIDI_CHANNELS]; /**< low bits for the next note's velocity */
  bool hands[2];                   /**< by channel and by key pressure: on the head */
  bool held[MIDI_VALUES];          /**< notes that buzz or sweep */
  int sweeping;                    /**< the last note that began to sweep, while it does; else -1 */
  uint32_t next_id;                /**< of a stroke */
  MidiCounts counts;
} MidiToEvents;

/** SET-UP. What @p map means on @p def. */
void midi_binding_make(const MidiMap *map, const TaborDrumDef *def, MidiBinding *binding);
/** AUDIO. Begins; @p map must outlive it. */
void midi_to_events_begin(MidiToEvents *drum, const MidiMap *map,
                          const MidiBinding *binding) REALTIME;
/** AUDIO. True if @p message does something: then *action says what. */
bool midi_to_events_take(MidiToEvents *drum, const MidiMessage *message,
                         MidiAction *action) REALTIME;

#endif
