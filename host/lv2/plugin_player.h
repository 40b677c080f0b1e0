/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_player.h
 * The audio thread of an instance: MIDI and knobs in, sound out.
 *
 * A run is played in pieces that begin where something happens, so that everything acts at its frame, whatever
 * the runs are. MIDI means what it means to `tabor render --midi-file` (midi_to_events.h), and sounds the same to
 * the bit. Nothing here allocates, locks or calls the system; the work is bounded by frames and messages.
 */
#ifndef TABOR_LV2_PLUGIN_PLAYER_H
#define TABOR_LV2_PLUGIN_PLAYER_H

#include "lv2/model_worker.h"
#include "midi/midi_to_events.h"
#include "sound/fader.h"
#include "sound/leaving.h"
#include "sound/silencer.h"
#include "strokes/humanize.h"

#define PLUGIN_PIECE 256 /**< frames computed at once at most */
#define PLUGIN_EVENTS                                                                              \
  256 /**< that may wait, or act at one frame; see docs/lv2.md for further ones */
#define PLUGIN_ACTIONS 64 /**< likewise beside them */

#define PLUGIN_WAIT 0.04 /**< [s] until what is under way to a microphone has arrived for sure */

/** The microphones that the plugins know, in the order of the outputs of the one that has all. */
typedef enum PluginMic {
  PLUGIN_TOP,
  PLUGIN_BOTTOM,
  PLUGIN_NEAR,
  PLUGIN_FAR,
  PLUGIN_LEFT,
  PLUGIN_RIGHT,
  PLUGIN_MICS = MODEL_WORKER_MICS
} PluginMic;

/** The drum as it was before a swap: it plays along until the new one's sound is everywhere, then they cross. */
typedef struct Crossing {
  TaborDrum *drum;     /**< or NULL */
  uint32_t hold, fade; /**< frames left of it */
} Crossing;

/** What MIDI wants beside strokes. */
typedef struct PluginAction {
  MidiAction action;
  uint32_t after; /**< of the events that wait, those of frames before: they act first */
} PluginAction;

typedef struct PluginPlayer {
  /* set up once */
  ModelWorker *worker;
  double rate;
  bool stereo;           /**< two outputs, mixed; or one per microphone */
  MidiBinding *bindings; /**< of the built-in presets */
  MidiMap map;
  uint32_t ids[KNOB_KEYS]; /**< of live knobs' parameters */
  uint32_t grip_id;

  TaborDrum *drum; /**< NULL until there is one */
  MidiToEvents midi;
  Humanizer humanizer;
  uint32_t striker_count;
  Crossing crossing;
  Leaving leaving;                      /**< of programs before */
  TaborDrum *trash[MODEL_WORKER_TRASH]; /**< that the worker is to destroy */
  uint32_t mics[PLUGIN_MICS];           /**< of the model of now, or MODEL_WORKER_NO_MIC */
  Silencer silencer;
  Fader gain, expression;
  Fader levels[KNOB_COUNT]; /**< from KNOB_LEVEL_PAIR to KNOB_LEVEL_FAR */
  uint32_t
    waits[KNOB_COUNT]; /**< frames until a level moves: the microphone has just been switched on */

  Request request;
  uint32_t asked, asked_restoration;       /**< of the newest request that was made */
  uint32_t answered, answered_restoration; /**< of the newest reply that was taken */
  int32_t chosen;          /**< program that messages are for; knobs turned since make it none */
  int32_t chosen_before;   /**< the same before the frame of now */
  float seen[KNOB_COUNT];  /**< of the ports; NaN: not yet */
  double built[KNOB_KEYS]; /**< of the model; NaN: the drum has no such part */
  double built_grip;
  double strainer;       /**< of the drum's definition, whatever MIDI has moved */
  bool moved[KNOB_KEYS]; /**< live values of the drum, from those of its model */
  bool grip_moved;
  const TaborSwap *swap; /**< the newest, while it may have to be cleared up */

  TaborEvent events[PLUGIN_EVENTS]; /**< for the drum, at the frame of now */
  uint32_t event_count;
  PluginAction actions[PLUGIN_ACTIONS]; /**< beside them */
  uint32_t action_count;
  uint32_t held_events,
    held_actions; /**< of these, those of frames before: they wait for the end of a silence */
  float planar[TABOR_MAX_MICS][PLUGIN_PIECE];          /**< of the drum */
  float crossing_planar[TABOR_MAX_MICS][PLUGIN_PIECE]; /**< of what it was before a swap */
  double sound[PLUGIN_MICS][PLUGIN_PIECE];             /**< of all drums */
} PluginPlayer;

/** Where a run's sound goes: of each output, or NULL. */
typedef struct PluginOutputs {
  float *channels[PLUGIN_MICS];
} PluginOutputs;

/* SET-UP */

/** False without memory. */
bool plugin_player_begin(PluginPlayer *player, ModelWorker *worker, double rate, bool stereo);
/** Frees the drum, too. */
void plugin_player_end(PluginPlayer *player);

/* AUDIO */

/** As if nothing had happened yet; what knobs have set stays. */
void plugin_player_rest(PluginPlayer *player) REALTIME;
/** Knob @p id's port says @p value. */
void plugin_player_turn(PluginPlayer *player, KnobId id, float value) REALTIME;
/** A whole MIDI message comes at the frame that is played next. */
void plugin_player_take(PluginPlayer *player, const MidiMessage *message) REALTIME;
/** Takes what the model worker has ready. */
void plugin_player_receive(PluginPlayer *player) REALTIME;
/** Asks the model worker for what is wanted, if it is free. True: now somebody has to work. */
bool plugin_player_ask(PluginPlayer *player) REALTIME;
/** True if there is a drum, and it is what it is to be. */
bool plugin_player_is_ready(const PluginPlayer *player) REALTIME;
/** True if nothing is asked for that the model worker has not answered, and it has nothing else to do. */
bool plugin_player_is_settled(const PluginPlayer *player) REALTIME;
/**
 * Plays up to @p most frames into @p outputs from frame @p at on; returns how many: up to where something
 * happens. With @p waits it plays none if the drum is to become another one before.
 */
uint32_t plugin_player_play(PluginPlayer *player, const PluginOutputs *outputs, uint32_t at,
                            uint32_t most, bool waits) REALTIME;

#endif
