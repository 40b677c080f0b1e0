/* SPDX-License-Identifier: MIT */
/**
 * @file kit_worker.h
 * Builds an instance's kits outside the audio thread and delivers them to it.
 *
 * The audio thread writes a request, a worker answers with a whole kit. `phase` says which of the two owns request and
 * answer, so neither waits for the other:
 *
 *     IDLE --audio--> ASKED --worker--> BUILDING --worker--> ANSWERED --audio--> IDLE
 *
 * The audio thread gives back a kit that it is done with by `retired`, which the worker empties. Models are shared with
 * other instances (model_cache.h), and their quality is lowered where building would take too long, as for a single drum
 * (model_worker.h).
 */
#ifndef TABOR_PLUGIN_KIT_WORKER_H
#define TABOR_PLUGIN_KIT_WORKER_H

#include <stdatomic.h>

#include "kit/kit_midi.h"
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

typedef enum KitPhase {
  KIT_PHASE_IDLE,
  KIT_PHASE_ASKED,
  KIT_PHASE_BUILDING,
  KIT_PHASE_ANSWERED
} KitPhase;

/** Writes an error line to the host's log. Any thread but the audio thread. */
typedef void KitWorkerSayFn(void *context, const char *line);

typedef struct KitWorker {
  double rate; /**< [Hz] */
  OwnKit *own; /**< outlives the worker */
  KitWorkerSayFn *say;
  void *context;

  atomic_uint phase;            /**< a KitPhase */
  atomic_bool is_cancelled;     /**< nothing is to be built */
  atomic_bool is_outdated;      /**< the audio thread wants another kit than the one being built */
  float wanted[KIT_KNOB_COUNT]; /**< the request */
  const KitVoice *playing;      /**< whose drums the kit is to go on with, or NULL */
  bool is_held;                 /**< its quality is below the knob's, since this is no export */
  bool has_said_held;
  KitVoice *answer;            /**< NULL: none could be built */
  bool failed;                 /**< none will be, from the same request */
  _Atomic(KitVoice *) retired; /**< that the audio thread is done with */
} KitWorker;

/* SET-UP */

void kit_worker_begin(KitWorker *worker, double rate, OwnKit *own, KitWorkerSayFn *say,
                      void *context);
/** Frees everything that was not taken. Call while no worker works. */
void kit_worker_end(KitWorker *worker);
void kit_voice_destroy(KitVoice *voice);

/* WORKERS: any thread, several at once */

/** Frees what was retired, and answers the request if there is one that nobody works on. */
void kit_worker_work(KitWorker *worker);
/** Ends what is being built within 0.1 s, and lets nothing be built until kit_worker_resume(). */
void kit_worker_cancel(KitWorker *worker);
void kit_worker_resume(KitWorker *worker);

#endif
