/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_run.h
 * Plays a block of a plugin's host. The shell of a plugin format says what happens at which frame of the block, and
 * where the sound goes; the order in which things act is the same for all formats: at one frame first knobs, then
 * controllers and program changes, then notes.
 */
#ifndef TABOR_PLUGIN_RUN_H
#define TABOR_PLUGIN_RUN_H

#include "plugin/plugin_player.h"

/** A host's block, as the shell of a format reads it. All functions are called on the audio thread. */
typedef struct PluginEvents {
  /** Sets every knob to its newest value by plugin_player_turn(). */
  void (*turn)(void *shell) REALTIME;
  /** Finds the next event: *frame is at least what it was. False: there is none. */
  bool (*find)(void *shell, uint32_t frames, uint32_t *frame) REALTIME;
  /** Notes the values of the knobs that frame @p frame brings. False: it brings none. Same result if repeated. */
  bool (*note_knobs)(void *shell, uint32_t frame) REALTIME;
  /** Gives all messages of frame @p frame to plugin_player_take(), and passes on to the next one. */
  void (*take)(void *shell, uint32_t frame, uint32_t ahead) REALTIME;
} PluginEvents;

typedef struct PluginRun {
  PluginPlayer *player;
  const PluginOutputs *outputs;
  const PluginEvents *events;
  void *shell;
  uint32_t at, frames; /**< played so far, and all */
  bool waits;          /**< for every model: the host renders, and is in no hurry */
  bool
    has_turned; /**< the knobs of the next frame have been turned; its messages wait for a model */
} PluginRun;

/** AUDIO. Plays a block in real time. True if a worker has to run now. */
bool plugin_run_live(PluginRun *run) REALTIME;
/** Plays a block in which every change acts at its frame, however long its model takes. */
void plugin_run_waiting(PluginRun *run);
/** Waits until all models are there that knobs and messages have asked for. */
void plugin_run_wait(const PluginRun *run);

#endif
