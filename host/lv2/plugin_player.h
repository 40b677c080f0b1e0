/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_player.h
 * The audio thread of an instance: MIDI and knobs in, sound out.
 *
 * A run is played in pieces. Each piece starts where something happens, so everything acts at its frame for every
 * run length. MIDI has the same meaning as in `tabor render --midi-file` (midi_to_events.h) and gives the same
 * sound to the bit. Nothing here allocates, locks or makes a system call. The number of frames and messages
 * bounds the work.
 */
#ifndef TABOR_LV2_PLUGIN_PLAYER_H
#define TABOR_LV2_PLUGIN_PLAYER_H

#include "lv2/model_worker.h"
#include "midi/midi_to_events.h"
#include "sound/fader.h"
#include "sound/leaving.h"
#include "sound/silencer.h"
#include "strokes/humanize.h"

#define PLUGIN_PIECE 256 /**< most frames computed at once */
#define PLUGIN_EVENTS                                                                              \
  256 /**< most events that wait or act at one frame; docs/lv2.md: what happens to more */
#define PLUGIN_ACTIONS 64 /**< the same limit for actions */

#define PLUGIN_WAIT 0.04 /**< [s] longer than any delay of sound to a microphone */

/** Microphones of the plugins, in the order of the multi-output plugin's outputs. */
typedef enum PluginMic {
  PLUGIN_TOP,
  PLUGIN_BOTTOM,
  PLUGIN_NEAR,
  PLUGIN_FAR,
  PLUGIN_LEFT,
  PLUGIN_RIGHT,
  PLUGIN_INSIDE,
  PLUGIN_MICS = MODEL_WORKER_MICS
} PluginMic;

/** The drum before a swap. It plays on until the new sound has reached all microphones, then crossfades. */
typedef struct Crossing {
  TaborDrum *drum;     /**< or NULL */
  uint32_t hold, fade; /**< frames left of each stage */
} Crossing;

/** A MIDI action other than a stroke. */
typedef struct PluginAction {
  MidiAction action;
  uint32_t after; /**< number of waiting events that came before the action and act first */
} PluginAction;

typedef struct PluginPlayer {
  /* set up once */
  ModelWorker *worker;
  double rate;
  bool stereo;           /**< two outputs, mixed; or one per microphone */
  MidiBinding *bindings; /**< one per built-in preset */
  MidiMap map;
  uint32_t ids[KNOB_KEYS]; /**< parameter of each live knob */
  uint32_t grip_id;

  TaborDrum *drum; /**< NULL until there is one */
  MidiToEvents midi;
  Humanizer humanizer;
  uint32_t striker_count;
  Crossing crossing;
  Leaving leaving;                      /**< drums of earlier programs */
  TaborDrum *trash[MODEL_WORKER_TRASH]; /**< drums for the worker to destroy */
  uint32_t mics[PLUGIN_MICS];           /**< of the current model, or MODEL_WORKER_NO_MIC */
  Silencer silencer;
  Fader gain, expression;
  Fader levels[KNOB_COUNT]; /**< where knob_is_level() */
  /** Frames until a level moves, after its microphone was switched on. */
  uint32_t waits[KNOB_COUNT];

  Request request;
  uint32_t asked, asked_restoration;       /**< of the newest request that was made */
  uint32_t answered, answered_restoration; /**< of the newest reply that was taken */
  int32_t chosen;          /**< program that messages are for; none after a turn of a knob */
  int32_t chosen_before;   /**< the same, before the current frame */
  float seen[KNOB_COUNT];  /**< values of the ports; NaN: not yet known */
  double built[KNOB_KEYS]; /**< values of the model; NaN: the drum has no such part */
  double built_grip;
  double strainer;       /**< of the drum's definition, before moves by MIDI */
  bool moved[KNOB_KEYS]; /**< the drum's live value differs from its model's */
  bool grip_moved;
  const TaborSwap *swap; /**< the newest, while it may have to be freed */

  TaborEvent events[PLUGIN_EVENTS]; /**< for the drum, at the current frame */
  uint32_t event_count;
  PluginAction actions[PLUGIN_ACTIONS]; /**< at the current frame */
  uint32_t action_count;
  /** Numbers of events and actions from earlier frames that wait for the end of a silence. */
  uint32_t held_events, held_actions;
  float planar[TABOR_MAX_MICS][PLUGIN_PIECE];          /**< sound of the drum */
  float crossing_planar[TABOR_MAX_MICS][PLUGIN_PIECE]; /**< sound of the drum before a swap */
  double sound[PLUGIN_MICS][PLUGIN_PIECE];             /**< sum of all drums */
} PluginPlayer;

/** Buffer of each output, or NULL. */
typedef struct PluginOutputs {
  float *channels[PLUGIN_MICS];
} PluginOutputs;

/* SET-UP */

/** Initialises @p player. False if memory is short. */
bool plugin_player_begin(PluginPlayer *player, ModelWorker *worker, double rate, bool stereo);
/** Frees everything, the drum too. */
void plugin_player_end(PluginPlayer *player);

/* AUDIO */

/** Resets the player to its start, but keeps the values of the knobs. */
void plugin_player_rest(PluginPlayer *player) REALTIME;
/** Sets knob @p id to @p value, the value of its port. */
void plugin_player_turn(PluginPlayer *player, KnobId id, float value) REALTIME;
/** Takes a complete MIDI message for the frame that is played next. */
void plugin_player_take(PluginPlayer *player, const MidiMessage *message) REALTIME;
/** Takes the reply of the model worker, if there is one. */
void plugin_player_receive(PluginPlayer *player) REALTIME;
/** Sends the model worker a request if one is needed and it is idle. True: a worker has to run now. */
bool plugin_player_ask(PluginPlayer *player) REALTIME;
/** True if there is a drum and it is the wanted one. */
bool plugin_player_is_ready(const PluginPlayer *player) REALTIME;
/** True if the model worker has answered every request and has nothing else to do. */
bool plugin_player_is_settled(const PluginPlayer *player) REALTIME;
/**
 * Plays up to @p most frames into @p outputs, starting at frame @p at, but stops where something happens.
 * Returns the number of frames. With @p waits it plays none while a change of the drum is due first.
 */
uint32_t plugin_player_play(PluginPlayer *player, const PluginOutputs *outputs, uint32_t at,
                            uint32_t most, bool waits) REALTIME;

#endif
