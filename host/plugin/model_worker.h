/* SPDX-License-Identifier: MIT */
/**
 * @file model_worker.h
 * Builds an instance's models outside the audio thread and delivers them to it.
 *
 * The audio thread writes a request; a worker answers with a reply: a drum, or a swap for the
 * current drum (builder.h).
 *
 * The first reply has the drum. Later, a preset that is chosen by MIDI or restored replaces the
 * drum, and a change of knobs or quality keeps it ringing on another model; both are swaps. The
 * room comes with the drum, and anew when something changes that it depends on: the knob, or the
 * drum's microphones, shell and air.
 *
 * The drum's definition is that of DEFAULT_PRESET, the one restored last, or a built-in preset that
 * MIDI has chosen since. Knobs turned since then override values in it.
 */
#ifndef TABOR_PLUGIN_MODEL_WORKER_H
#define TABOR_PLUGIN_MODEL_WORKER_H

#include <pthread.h>

#include "midi/midi_to_events.h"
#include "plugin/builder.h"
#include "plugin/knobs.h"
#include "sound/player_message.h"
#include "sound/room_mix.h"

#define MODEL_WORKER_NO_PROGRAM (-1)
#define MODEL_WORKER_MICS 7 /**< outputs of a drum: top, bottom, near, far, left, right, inside */

/** The wanted drum. What has not been turned is as in the definition. */
typedef struct Request {
  /** Starts at 1 and grows with every request for another model. If it was answered already,
      the worker only frees what is not needed any more. */
  uint32_t number;
  uint32_t restoration;      /**< number of the restoration that the other fields refer to */
  int32_t program;           /**< index of a built-in preset, or MODEL_WORKER_NO_PROGRAM */
  uint32_t choice;           /**< counts choices of a preset, repeated ones too */
  KnobTurn turns[KNOB_KEYS]; /**< of knobs, since then */
  KnobTurn strainer, grip;   /**< by MIDI, since then */
  float seen[KNOB_SEEN];     /**< values of the ports; a change is a turn of the knob */
  uint32_t quality;          /**< a TaborQuality */
  bool is_held;              /**< quality is below the knob's, since this is no export */
  uint32_t room;             /**< a TaborRoomKind; stereo plugin */
  bool keeps_room;           /**< the newest choice was MIDI's */
  uint32_t stick;            /**< a choice of stick_choice.h */
} Request;

/** The worker's answer. */
typedef struct Reply {
  uint32_t number, restoration; /**< of the request, or the newest restoration */
  int32_t program;
  float seen[KNOB_SEEN]; /**< restored values of the ports; NaN: any value */
  TaborDrum *drum;       /**< the drum, the first time; then NULL */
  TaborSwap *swap;       /**< for the drum; NULL without drum: no change */
  RoomMix *room;         /**< another room, NULL for the one before */
  bool is_news;          /**< false: the request was answered before; ignore the rest */
  bool cancelled;        /**< the build was ended; ignore the rest and ask again */
  bool failed;           /**< nothing was built; ignore the fields below */
  bool begins_anew;      /**< the swap replaces the drum */
  /** Of pitches that the head cannot have: the nearest that it can, a value of the port; otherwise
   * NaN. */
  float given[KNOB_KEYS];
  TaborDrumDef def;        /**< of the model */
  double built[KNOB_KEYS]; /**< values of the knobs' keys; NaN: the drum has no such part */
  MidiBinding binding;     /**< MIDI binding of the model, without values set by MIDI */
} Reply;

typedef struct WorkerRoom {
  RoomMix mix;
  TaborDrumDef def; /**< that it is of */
  struct WorkerRoom *next;
} WorkerRoom;

typedef struct ModelWorker {
  /* set up once */
  Builder builder;
  bool stereo;
  MidiMap map; /**< the default map */

  atomic_uint restoration; /**< number of the newest restoration */
  atomic_int program;      /**< last asked for by the audio thread, for model_worker_save() */
  Request request;
  Reply reply;

  /* under lock */
  pthread_mutex_t lock;
  TaborDrumDef base;          /**< definition restored last */
  float base_seen[KNOB_SEEN]; /**< values of the ports then; NaN: unknown */
  TaborDrumDef composed;      /**< of the newest reply, without values set by MIDI */
  float composed_seen[KNOB_SEEN];
  uint32_t composed_restoration;
  int32_t composed_program;

  /* worker thread */
  TaborModel *model; /**< of the newest reply, from the cache; changes under lock */
  uint32_t built_restoration, built_choice; /**< of that model */
  TaborSwap **swaps;                        /**< swaps that the drum may still need */
  uint32_t swap_count, swap_room;
  WorkerRoom *rooms; /**< those that a player may still need; the newest first */
} ModelWorker;

/** The saved state of an instance. */
typedef struct SavedState {
  TaborDrumDef def;
  float seen[KNOB_SEEN]; /**< values of its ports; NaN: unknown */
} SavedState;

/* SET-UP */

/** Initialises @p worker. False if memory is short. @p stereo: both sides of a drum without a
 * stereo pair are heard by its first microphone. */
bool model_worker_begin(ModelWorker *worker, double rate, bool stereo, BuilderSayFn *say,
                        void *context);
/** Frees everything. Call after the drum was destroyed and while no worker works. */
void model_worker_end(ModelWorker *worker);
/** Makes @p saved, which is valid, the wanted drum. Any time, in parallel with all other functions.
 */
void model_worker_restore(ModelWorker *worker, const SavedState *saved);
/** Saves the state. Any time, in parallel with all other functions. */
void model_worker_save(ModelWorker *worker, SavedState *saved);
/** The model that was built last, to be released by the caller; NULL if there is none. Any time, in
 * parallel with all other functions. */
TaborModel *model_worker_model(ModelWorker *worker);

/* WORKERS: any thread but the audio thread, several at once */

/** Answers the request if there is one and no other worker works on it. */
void model_worker_work(ModelWorker *worker);

/* AUDIO */

/** Hands @p request to the workers; call only if the builder is idle. */
void model_worker_ask(ModelWorker *worker, const Request *request) REALTIME;
/** Returns the reply, valid until builder_accept(); NULL while there is none. */
const Reply *model_worker_reply(const ModelWorker *worker) REALTIME;

#endif
