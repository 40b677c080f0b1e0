/* SPDX-License-Identifier: MIT */
/**
 * @file model_worker.h
 * Where an instance's models are built, beside the audio thread, and how they get to it.
 *
 * The audio thread writes a request, a worker answers it with a reply: the drum, or a swap for it. One of the
 * two owns request and reply at a time, as `phase` says, so neither ever waits for the other:
 *
 *     IDLE --audio--> ASKED --worker--> BUILDING --worker--> ANSWERED --audio--> IDLE
 *
 * A preset, by MIDI or restored, is another drum, beside which the one before rings out. Knobs and quality leave
 * the drum the same: it is swapped, and a copy of it can go on meanwhile.
 *
 * What a drum is: a definition, that of DEFAULT_PRESET or the one that was restored last, or a built-in
 * preset that MIDI has chosen since; in it the values of the knobs that were turned since.
 */
#ifndef TABOR_LV2_MODEL_WORKER_H
#define TABOR_LV2_MODEL_WORKER_H

#include <pthread.h>
#include <stdatomic.h>

#include "base/realtime.h"
#include "lv2/knobs.h"
#include "midi/midi_to_events.h"
#include "sound/leaving.h"

#define MODEL_WORKER_NO_PROGRAM (-1)
#define MODEL_WORKER_NO_MIC LEAVING_NO_MIC
#define MODEL_WORKER_MICS 6 /**< that the plugins know: top, bottom, near, far, left, right */
#define MODEL_WORKER_TRASH (LEAVING_MOST + 4) /**< drums that one request can do away with */

/** What the drum is to be. NaN stands for: as it is in the definition. */
typedef struct Request {
  /** From 1; grows with every request for another model. One that was answered already only lets the worker
      clear up. */
  uint32_t number;
  uint32_t restoration; /**< number of the one that the rest is about */
  int32_t program;      /**< index of a built-in preset, or MODEL_WORKER_NO_PROGRAM */
  uint32_t choice; /**< number of the program, as MIDI has chosen it, even the same one again */
  double values[KNOB_KEYS]; /**< of knobs that were turned since */
  double strainer, grip;    /**< as MIDI has moved them since */
  float seen[KNOB_KEYS];    /**< what the ports say: a change of these is a turn of the knob */
  uint32_t quality;         /**< a TaborQuality */
  TaborDrum *trash[MODEL_WORKER_TRASH]; /**< drums to be destroyed, or NULL */
} Request;

/** What there is now. */
typedef struct Reply {
  uint32_t number, restoration; /**< of the request; the newest restoration takes its place */
  int32_t program;
  float seen[KNOB_KEYS]; /**< what the restored ports say; NaN: whatever they do */
  TaborDrum *drum;       /**< in place of the one that is there, if there is one; or NULL: */
  TaborSwap *swap;       /**< of the drum that is there; or NULL: nothing changes */
  TaborDrum *spare;      /**< with a swap: room for a copy of the drum as it was before; or NULL */
  void *state;           /**< with a spare: room for tabor_drum_state_save() */
  bool is_news;          /**< or the request had been answered before: then nothing else counts */
  bool failed;           /**< nothing was built: then only what stands above counts */
  bool begins_anew;      /**< another drum: what MIDI has moved is forgotten */
  TaborDrumDef def;      /**< of the model */
  double built[KNOB_KEYS]; /**< what it says of the knobs' keys; NaN: the drum has no such part */
  /** Its microphones with the names of the plugins', or MODEL_WORKER_NO_MIC. */
  uint32_t mics[MODEL_WORKER_MICS];
  MidiBinding binding; /**< what MIDI means on it; without what MIDI has moved */
} Reply;

typedef enum Phase { PHASE_IDLE, PHASE_ASKED, PHASE_BUILDING, PHASE_ANSWERED } Phase;

/** A line about what went wrong, for the host's log. Any thread but the audio thread. */
typedef void ModelWorkerSayFn(void *context, const char *line);

typedef struct ModelWorker {
  /* set up once */
  TaborModelOptions options;
  MidiMap map; /**< the usual one */
  ModelWorkerSayFn *say;
  void *context;

  atomic_uint phase;       /**< a Phase */
  atomic_uint restoration; /**< number of the newest */
  atomic_int program;      /**< that the audio thread asked for last, for model_worker_save() */
  Request request;
  Reply reply;

  /* under lock */
  pthread_mutex_t lock;
  TaborDrumDef base;          /**< restored */
  float base_seen[KNOB_KEYS]; /**< what the ports said then; NaN: unknown */
  TaborDrumDef composed;      /**< of the newest reply, without what MIDI has moved */
  float composed_seen[KNOB_KEYS];
  uint32_t composed_restoration;
  int32_t composed_program;

  /* the worker's */
  TaborModel *model;                        /**< of the newest reply, from the cache */
  uint32_t built_restoration, built_choice; /**< of that */
  TaborSwap **swaps;                        /**< that the drum may still need */
  uint32_t swap_count, swap_room;
} ModelWorker;

/** What an instance was left as. */
typedef struct SavedState {
  TaborDrumDef def;
  float seen[KNOB_KEYS]; /**< what its ports said; NaN: unknown */
} SavedState;

/* SET-UP */

/** False without memory. */
bool model_worker_begin(ModelWorker *worker, double rate);
/** After the drum was destroyed, while no worker works. */
void model_worker_end(ModelWorker *worker);
/** Any time, beside all others: the drum is to be this from now on. @p saved is valid. */
void model_worker_restore(ModelWorker *worker, const SavedState *saved);
/** Any time, beside all others. */
void model_worker_save(ModelWorker *worker, SavedState *saved);

/* WORKERS: any thread but the audio thread, several at once */

/** Answers the request if there is one that nobody works on. */
void model_worker_work(ModelWorker *worker);

/* AUDIO */

/** Hands @p request over; only if model_worker_is_idle(). */
void model_worker_ask(ModelWorker *worker, const Request *request) REALTIME;
/** True if a request may be made. */
bool model_worker_is_idle(const ModelWorker *worker) REALTIME;
/** The reply, until model_worker_accept(); NULL while there is none. */
const Reply *model_worker_reply(const ModelWorker *worker) REALTIME;
/** The reply has been taken. */
void model_worker_accept(ModelWorker *worker) REALTIME;

#endif
