/* SPDX-License-Identifier: MIT */
/**
 * @file controls.h
 * Controls at the computer keyboard: strokes, settings, change of drum, commands. Converts actions
 * to messages for the audio thread and to changes of the drum. Keeps the settings that keys do not
 * carry, such as the speed.
 *
 * All functions are for the user's thread.
 */
#ifndef TABOR_HOST_CONTROLS_H
#define TABOR_HOST_CONTROLS_H

#include "drums/user_presets.h"
#include "kit/kit_values.h"
#include "play/model_builder.h"
#include "play/play_midi.h"
#include "strokes/humanize.h"
#include "ui/keymap.h"

#define CONTROLS_HANDS 3u /**< two that alternate buzzes, and one with the brush */
#define CONTROLS_TEXT_SIZE 512

typedef struct Controls {
  Player *player;
  ModelBuilder *const *builders; /**< of the kit's drums, or of the drum */
  const TaborKitDef *kit;        /**< or NULL */
  double kit_values[KIT_VALUES]; /**< of the kit, by TaborKitParameter [dB] */
  uint32_t drum;                 /**< that the keys strike and change: of the kit, else 0 */
  PlayMidi *midi;                /**< live MIDI, or NULL */
  const char *midi_map;          /**< file of --midi-map, or NULL */
  Humanizer humanizer;
  double rate;       /**< [Hz] */
  double speed;      /**< speed of strokes [m/s] */
  double gain_db;    /**< output gain [dB] */
  double strainer;   /**< position when the snares are switched on */
  double muffle;     /**< damping when the muffle is switched on [N s/m] */
  double last_place; /**< radius of the last stroke, as a fraction of the head's */
  double last_speed; /**< of the last stroke [m/s] */
  unsigned hand;     /**< hand of the next buzz, 0 or 1 */
  /** Time at which each hand lifts its buzzing stick, the last hand its sweeping brush [s]; 0: none
   * held. */
  double release_time[CONTROLS_HANDS];
  char own[USER_PRESET_PATH]; /**< the file that was opened or saved last, which a save may replace;
                                 or "" */
  char learns[TABOR_NAME_SIZE]; /**< what the next controller will move, or "" */
  /** Requests of the user; the caller resets opens_command. */
  bool opens_command, shows_help, quits;
  char text[CONTROLS_TEXT_SIZE]; /**< message about the last action, or "" */
  bool is_trouble;               /**< the message reports a failure */
} Controls;

/** Starts with the speed of the preset's own stroke and a gain of @p gain_db; without MIDI. A kit
 * starts with the drum that plays the snare drum's note, or the first. */
Controls controls_begin(Player *player, ModelBuilder *const *builders, const TaborKitDef *kit,
                        double rate, double gain_db, Humanizer humanizer);
/** Tells that the drum or kit is the one called @p name. */
void controls_opened(Controls *controls, const char *name);
/** Executes the action of a key pressed at @p time [s of CLOCK_MONOTONIC]. */
void controls_act(Controls *controls, const Action *action, double time);
/** Ends the waiting for a controller that was to be learned: false if none was. */
bool controls_forget_learning(Controls *controls);
/** Lifts buzzing sticks and sweeping brushes after their time: a terminal reports no key releases.
 * Tells of a controller that was learned, and keeps it in the map's file: true if there is a new
 * text. Call often. */
bool controls_pass(Controls *controls, double time);
/** Executes a command, such as "set wires.tension 20", entered at @p time. */
void controls_run(Controls *controls, const char *command, double time);
/**
 * Completes the word that ends at byte @p cursor of a command, as far as the completion is unique.
 * Gives the byte where the word starts, and the completed word in @p word of @p size bytes. False
 * if there is none.
 */
bool controls_complete(const char *command, size_t cursor, size_t *start, char *word, size_t size);

#endif
