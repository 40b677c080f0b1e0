/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_player.h
 * The audio thread of an instance: MIDI and knobs in, sound out.
 *
 * MIDI has the same meaning as in `tabor render --midi-file` (midi_to_events.h) and gives the same
 * sound to the bit, for every run length. Nothing here allocates, locks or makes a system call. The
 * number of frames and messages bounds the work.
 */
#ifndef TABOR_PLUGIN_PLAYER_H
#define TABOR_PLUGIN_PLAYER_H

#include "midi/midi_to_events.h"
#include "plugin/model_worker.h"
#include "plugin/plugin_buffers.h"
#include "sound/drum_player.h"
#include "sound/fader.h"
#include "strokes/humanize.h"

#define PLUGIN_MESSAGES 512 /**< most messages that wait; docs/plugins.md: what happens to more */

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

/** A message that waits for its frame. */
typedef struct PluginMessage {
  PlayerMessage message;
  bool is_midi; /**< or a knob's or another model's */
} PluginMessage;

typedef struct PluginPlayer {
  /* set up once */
  ModelWorker *worker;
  double rate;
  bool stereo;           /**< two outputs, mixed; or one per microphone */
  MidiBinding *bindings; /**< one per built-in preset */
  MidiMap map;
  KnobRange ranges[KNOB_COUNT];
  uint32_t ids[KNOB_KEYS]; /**< parameter of each live knob */
  uint32_t grip_id;

  DrumPlayer core; /**< with an output for each PluginMic */
  MidiToEvents midi;
  Humanizer humanizer;
  /**
   * The drum's gain beside the knob's: the pair's usual level in the stereo plugin, otherwise 1.
   * The drum plays at it before its sound is rounded to single precision, as `tabor render
   * --stereo` does; levels are relative to it.
   */
  double base_gain;
  Fader levels[KNOB_COUNT]; /**< where knob_is_level() */
  /** Of an effect: pressure at full scale [Pa] and part of the drum in the mix, as faders; the
   * newest block [Pa]. */
  Fader sound, mix;
  float pressure[DRUM_PLAYER_BLOCK];
  /** Frames until a level moves, after its microphone was switched on. */
  uint32_t waits[KNOB_COUNT];

  uint32_t quality; /**< of the knob; a TaborQuality */
  bool exports;     /**< the host renders, and waits for models */
  Request request;
  uint32_t asked, asked_restoration;       /**< of the newest request that was made */
  uint32_t answered, answered_restoration; /**< of the newest reply that was taken */
  int32_t chosen;         /**< program that messages are for; none after a turn of a knob */
  int32_t chosen_before;  /**< the same, before the current frame */
  float seen[KNOB_COUNT]; /**< values of the ports; NaN: not yet known */
  /** Where KNOB_DRUM stood when the drum was saved that is restored; NaN: unknown, or another drum
   * was chosen since. A host that puts the knob there, before the drum or after it, chooses no
   * drum. */
  float restored_drum;
  float given[KNOB_SEEN];    /**< values that the drum has instead of seen, or NaN */
  float offsets[KNOB_COUNT]; /**< by which the host modulates knobs */
  double built[KNOB_KEYS];   /**< values of the model; NaN: the drum has no such part */
  double built_grip;
  double strainer;       /**< of the drum's definition, before moves by MIDI */
  bool moved[KNOB_KEYS]; /**< the drum's live value differs from its model's */
  bool grip_moved;
  const TaborSwap *swap; /**< the newest, while it may have to be freed */

  PluginMessage messages[PLUGIN_MESSAGES]; /**< in the order in which they act */
  uint32_t count;
  uint32_t first_count; /**< number of those at their front that act before MIDI */
  TaborEvent struck;    /**< the newest stroke; type 0: none since it was asked for */
} PluginPlayer;

/* SET-UP */

/** Initialises @p player. False if memory is short. */
bool plugin_player_begin(PluginPlayer *player, ModelWorker *worker, double rate, bool stereo);
/** Frees everything, the drum too. */
void plugin_player_end(PluginPlayer *player);

/* AUDIO */

/** Takes the newest stroke since the last call. False: there was none. */
bool plugin_player_take_struck(PluginPlayer *player, TaborEvent *stroke) REALTIME;
/** Resets the player to its start, but keeps the values of the knobs. */
void plugin_player_rest(PluginPlayer *player) REALTIME;
/** Sets knob @p id to @p value, the value of its port. KNOB_DRUM comes first, since other knobs
 * turn its drum. */
void plugin_player_turn(PluginPlayer *player, KnobId id, float value) REALTIME;
/**
 * Says once that knob @p id stands at *asked, and that the drum has *given, since the head cannot
 * follow or MIDI has chosen another drum: there the shell moves the knob, if it can. False if there
 * is nothing to say.
 */
bool plugin_player_take_given(PluginPlayer *player, KnobId id, float *asked, float *given) REALTIME;
/**
 * Adds @p offset to what knob @p id does, without moving the knob. No effect on knobs that
 * knob_is_modulated() denies.
 */
void plugin_player_modulate(PluginPlayer *player, KnobId id, float offset) REALTIME;
/** Says whether the host exports: in real time no quality is above PLUGIN_LIVE_QUALITY. */
void plugin_player_export(PluginPlayer *player, bool exports) REALTIME;
/** Prepares for the messages of another frame. */
void plugin_player_begin_frame(PluginPlayer *player) REALTIME;
/** Takes a complete MIDI message for a frame that is @p ahead frames from now. */
void plugin_player_take(PluginPlayer *player, const MidiMessage *message, uint32_t ahead) REALTIME;
/** Strikes the drum now, beside what MIDI asks for: @p radius a part of the head's. */
void plugin_player_strike(PluginPlayer *player, double velocity, double radius,
                          double angle) REALTIME;
/** True if messages since plugin_player_begin_frame() choose another preset. */
bool plugin_player_has_choice(const PluginPlayer *player) REALTIME;
/** Requests that preset; call when all frames before have been played. */
void plugin_player_choose(PluginPlayer *player) REALTIME;
/** True if so many messages wait that the next frame's might find no room. */
bool plugin_player_is_full(const PluginPlayer *player) REALTIME;
/** Takes the reply of the model worker, if there is one. */
void plugin_player_receive(PluginPlayer *player) REALTIME;
/** Sends the model worker a request if one is needed and it is idle. True: a worker has to run now.
 */
bool plugin_player_ask(PluginPlayer *player) REALTIME;
/** True if there is a drum and it is the wanted one. */
bool plugin_player_is_ready(const PluginPlayer *player) REALTIME;
/** True if there is a drum, and it is the one that was restored last or has come after it. */
bool plugin_player_is_restored(const PluginPlayer *player) REALTIME;
/** True if drum and room have died away and no message waits. */
bool plugin_player_is_silent(const PluginPlayer *player) REALTIME;
/** True if the model worker has answered every request and has nothing else to do. */
bool plugin_player_is_settled(const PluginPlayer *player) REALTIME;
/** Plays up to @p most frames into @p outputs, starting at frame @p at. Returns the number of
 * frames. */
uint32_t plugin_player_play(PluginPlayer *player, const PluginBuffers *outputs, uint32_t at,
                            uint32_t most) REALTIME;

#endif
