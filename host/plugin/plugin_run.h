/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_run.h
 * Plays a block of a plugin's host. The shell of a plugin format says what happens at which frame
 * of the block; the order in which things act is the same for all formats: at one frame first
 * knobs, then silences, controllers and program changes, then notes.
 */
#ifndef TABOR_PLUGIN_PLUGIN_RUN_H
#define TABOR_PLUGIN_PLUGIN_RUN_H

#include "plugin/instrument.h"

/** A host's block, as the shell of a format reads it. All functions are called on the audio thread.
 */
typedef struct PluginEvents {
  /** Finds the next event: *frame is at least what it was. False: there is none. */
  bool (*find)(void *shell, uint32_t *frame) REALTIME;
  /** Notes the values of the knobs that frame @p frame brings. False: it brings none. Same result
   * if repeated. NULL: knobs change between blocks alone. */
  bool (*note_knobs)(void *shell, uint32_t frame) REALTIME;
  /** Gives all messages of frame @p frame to the instrument, and passes on to the next one. */
  void (*take)(void *shell, uint32_t frame) REALTIME;
} PluginEvents;

typedef struct PluginRun {
  Instrument *instrument;
  const PluginEvents *events;
  void *shell;
  uint32_t frames;
  bool waits; /**< for every model: the host renders, and is in no hurry */
  bool
    has_turned; /**< the knobs of the next frame have been turned; its messages wait for a model */
} PluginRun;

/** AUDIO. Plays a block in real time. True if a worker has to run now. */
bool plugin_run_live(PluginRun *run) REALTIME;
/** Plays a block in which every change acts at its frame, however long its model takes; `waits` is
 * to be set. */
void plugin_run_waiting(PluginRun *run);
/** MAIN. Builds, or waits for another thread that does, until all is there that knobs and sessions
 * have asked for, or the workers are cancelled. */
void plugin_run_prepare(Instrument *instrument);

#endif
