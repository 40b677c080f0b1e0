/* SPDX-License-Identifier: MIT */
/**
 * @file builder.h
 * Builds an instrument's models outside the audio thread: what the workers of one drum
 * (model_worker.h) and of a kit (kit_worker.h) have in common.
 *
 * The audio thread writes a request, a worker answers. `phase` says which of the two owns both, so
 * neither waits for the other:
 *
 *     IDLE --audio--> ASKED --worker--> BUILDING --worker--> ANSWERED --audio--> IDLE
 *
 * In real time no quality is above PLUGIN_LIVE_QUALITY: what the knob asks for beyond is for
 * export, and the log says so. A host that renders offline waits for models. So none is built that
 * takes more than BUILDER_MOST_SECONDS or BUILDER_MOST_BYTES: the quality is lowered until it does,
 * and the log says so.
 */
#ifndef TABOR_PLUGIN_BUILDER_H
#define TABOR_PLUGIN_BUILDER_H

#include <stdatomic.h>
#include <tabor/tabor.h>

#include "base/realtime.h"

#define BUILDER_MOST_SECONDS 15.0      /**< that building a model may take, by its estimate */
#define BUILDER_MOST_BYTES 1000000000u /**< that it may take meanwhile */

/** The highest quality in real time. A snare drum at studio takes several times as long as it
 * sounds. */
#define PLUGIN_LIVE_QUALITY TABOR_QUALITY_LIVE

/** Writes an error line to the host's log. Any thread but the audio thread. */
typedef void BuilderSayFn(void *context, const char *line);

typedef enum BuilderPhase {
  BUILDER_IDLE,
  BUILDER_ASKED,
  BUILDER_BUILDING,
  BUILDER_ANSWERED
} BuilderPhase;

typedef struct Builder {
  TaborModelOptions options;
  BuilderSayFn *say; /**< or NULL */
  void *context;
  atomic_uint phase;        /**< a BuilderPhase */
  atomic_bool is_outdated;  /**< the audio thread has another wish than what is being built */
  atomic_bool is_cancelled; /**< nothing is to be built */
  double seconds;           /**< that the model takes which is being built */
  bool has_said_held;       /**< that the quality of an export is another one */
} Builder;

/** SET-UP. Initialises *builder for a rate [Hz]. */
void builder_begin(Builder *builder, double rate, BuilderSayFn *say, void *context);
/** ANY. Ends what is being built, within 0.1 s, and lets nothing be built until builder_resume().
 */
void builder_cancel(Builder *builder);
void builder_resume(Builder *builder);

/* WORKERS: any thread but the audio thread, several at once */

/** True if there is a request, which is then this worker's, to be answered. */
bool builder_take(Builder *builder);
void builder_answer(Builder *builder);
/** Takes a model from the cache (model_cache.h), at the quality that was asked for, or the highest
 * one below it that the limits allow. */
TaborStatus builder_model(Builder *builder, const TaborDrumDef *def, uint32_t quality,
                          TaborModel **model, TaborError *error);
/** Says what has become of it, and why. */
void builder_say(const Builder *builder, const char *what, const TaborError *error);
void builder_say_line(const Builder *builder, const char *line);
/** Says once that the quality is below the knob's, since this is no export. */
void builder_say_held(Builder *builder);
/** Fills *error; returns its status. */
TaborStatus builder_out_of_memory(TaborError *error);

/* AUDIO */

static inline bool builder_is(const Builder *builder, BuilderPhase phase) REALTIME {
  return atomic_load(&builder->phase) == phase;
}
/** Hands the request to the workers; only if it is idle. */
static inline void builder_ask(Builder *builder) REALTIME {
  atomic_store(&builder->is_outdated, false);
  atomic_store(&builder->phase, BUILDER_ASKED);
}
/** Says that another request will follow what is being built: a build that would go on for long
 * ends. */
static inline void builder_outdate(Builder *builder) REALTIME {
  atomic_store(&builder->is_outdated, true);
}
/** Releases the answer. */
static inline void builder_accept(Builder *builder) REALTIME {
  atomic_store(&builder->phase, BUILDER_IDLE);
}

#endif
