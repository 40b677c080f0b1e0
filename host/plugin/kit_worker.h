/* SPDX-License-Identifier: MIT */
/**
 * @file kit_worker.h
 * Builds an instance's kits outside the audio thread and delivers them to it.
 *
 * The audio thread writes a request, a worker answers with a whole kit (builder.h).
 * The audio thread gives back a kit that it is done with by `retired`, which the worker empties.
 */
#ifndef TABOR_PLUGIN_KIT_WORKER_H
#define TABOR_PLUGIN_KIT_WORKER_H

#include "kit/kit_midi.h"
#include "kit/kit_threads.h"
#include "plugin/builder.h"
#include "plugin/kit_knobs.h"

/** A kit that plays, and the MIDI that plays it. */
typedef struct KitVoice {
  TaborKit *kit;
  KitMidi midi;
  uint32_t drum_count;
  bool follows;                        /**< goes on with the drums of the kit before it */
  double coupling, overheads;          /**< the kit's own [dB], beside which knobs stand */
  TaborModel *models[TABOR_KIT_DRUMS]; /**< from the cache */
} KitVoice;

typedef struct KitWorker {
  Builder builder;
  OwnKit *own;         /**< outlives the worker, as the next */
  KitThreads *threads; /**< that compute kits, or NULL */

  float wanted[KIT_KNOB_COUNT]; /**< the request */
  const KitVoice *playing;      /**< whose drums the kit is to go on with, or NULL */
  bool is_held;                 /**< its quality is below the knob's, since this is no export */
  KitVoice *answer;             /**< NULL: none could be built */
  bool failed;                  /**< none will be, from the same request */
  _Atomic(KitVoice *) retired;  /**< that the audio thread is done with */
} KitWorker;

/* SET-UP */

void kit_worker_begin(KitWorker *worker, double rate, OwnKit *own, KitThreads *threads,
                      BuilderSayFn *say, void *context);
/** Frees everything that was not taken. Call while no worker works. */
void kit_worker_end(KitWorker *worker);
void kit_voice_destroy(KitVoice *voice);

/* WORKERS: any thread, several at once */

/** Frees what was retired, and answers the request if there is one that nobody works on. */
void kit_worker_work(KitWorker *worker);

#endif
