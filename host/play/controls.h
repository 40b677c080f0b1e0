/* SPDX-License-Identifier: MIT */
/**
 * @file controls.h
 * What a player at the keyboard can do: strokes, settings, another drum, commands. Turns actions into messages for
 * the audio thread and changes of the drum; remembers what keys alone do not say, as the speed.
 *
 * All of it is for the user's thread.
 */
#ifndef TABOR_HOST_CONTROLS_H
#define TABOR_HOST_CONTROLS_H

#include "play/model_builder.h"
#include "strokes/humanize.h"
#include "ui/keymap.h"

#define CONTROLS_HANDS 3u /**< two that buzz in turn, and the one with the brush */
#define CONTROLS_TEXT_SIZE 512

typedef struct Controls {
  Player *player;
  ModelBuilder *builder;
  Humanizer humanizer;
  double rate;       /**< [Hz] */
  double speed;      /**< of strokes [m/s] */
  double gain_db;    /**< of the output [dB] */
  double strainer;   /**< to which the snares are switched on */
  double muffle;     /**< to which the muffle is switched on [N s/m] */
  double last_place; /**< of the last stroke, as a share of the head's radius */
  double last_speed; /**< [m/s] */
  unsigned hand;     /**< that makes the next buzz, 0 or 1 */
  double release_time
    [CONTROLS_HANDS]; /**< when each hand lifts its buzzing stick, and the last one the sweeping
                                            brush [s]; 0: it holds none */
  bool opens_command, shows_help,
    quits;                       /**< what the user wants next; the caller resets the first */
  char text[CONTROLS_TEXT_SIZE]; /**< what is to be said of the last action, "" for nothing */
  bool is_trouble;               /**< it went wrong */
} Controls;

/** Begins with the speed of the preset's own stroke and with a gain of @p gain_db. */
Controls controls_begin(Player *player, ModelBuilder *builder, double rate, double gain_db,
                        Humanizer humanizer);
/** Carries out what a key does, pressed at @p time [s of CLOCK_MONOTONIC]. */
void controls_act(Controls *controls, const Action *action, double time);
/** Lifts sticks that have buzzed and brushes that have swept long enough: there is no telling when a key is let go. To be called often. */
void controls_pass(Controls *controls, double time);
/** Carries out a command, as "set wires.tension 20", given at @p time. */
void controls_run(Controls *controls, const char *command, double time);
/**
 * Completes the word that ends at byte @p cursor of a command: the byte at which it starts, and what it should
 * be in @p word, of @p size bytes, as far as there is only one way to go on; false if there is none.
 */
bool controls_complete(const char *command, size_t cursor, size_t *start, char *word, size_t size);

#endif
