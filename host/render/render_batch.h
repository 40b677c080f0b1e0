/* SPDX-License-Identifier: MIT */
/**
 * @file render_batch.h
 * Which sounds `tabor render` is asked for: one, in the file that -o names, or any number in a folder.
 *
 * Every PRESET is a sound, FOLDER/PRESET.wav; with --each, every PRESET with every --events file,
 * FOLDER/PRESET-EVENTS.wav. All that the command line says else goes for every one of them.
 */
#ifndef TABOR_HOST_RENDER_BATCH_H
#define TABOR_HOST_RENDER_BATCH_H

#include <jansson.h>
#include <stdatomic.h>

#include "base/interrupt.h"
#include "render/render_request.h"

#define MOST_JOBS INTERRUPT_MOST_THREADS

/** One sound of a batch. */
typedef struct RenderJob {
  char *name;            /**< "FOLDER/tom-12", or NULL where -o names the file */
  char *output;          /**< "FOLDER/tom-12.wav", or NULL */
  Arguments arguments;   /**< as if this sound alone were asked for */
  RenderRequest request; /**< these, read */
  Outcome outcome;       /**< of what has been done so far */
  json_t *report;        /**< facts, with --json, once it is rendered */
  double rate;           /**< frames a second, once it is read */
  double last_stroke;    /**< [s] */
  double length;         /**< [s], or 0: until the drum has died away */
  atomic_uint played;    /**< frames; any thread may look */
  atomic_bool finished;  /**< rendered or failed; likewise */
} RenderJob;

typedef struct RenderBatch {
  char *folder; /**< "FOLDER/", or NULL where -o names the file of the only sound */
  RenderJob *jobs;
  size_t count;
  uint32_t threads; /**< jobs to be done at once, at least 1 */
} RenderBatch;

/** Reads --jobs; as many as there are processors, unless told otherwise. */
Outcome render_threads_read(const Arguments *arguments, uint32_t *count);
/** Reads the request of a job that has its name and arguments. */
Outcome render_job_read(RenderJob *job);
/**
 * Reads and checks everything; touches nothing. A job that fails, as its preset file is missing, has
 * said so and is left out later; one that is wrong refuses the batch. Free with render_batch_free(),
 * whatever the outcome.
 */
Outcome render_batch_read(const Arguments *arguments, RenderBatch *batch);
void render_batch_free(RenderBatch *batch);

#endif
