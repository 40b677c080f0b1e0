/* SPDX-License-Identifier: MIT */
/**
 * @file render_batch.h
 * The sounds that `tabor render` has to make: one, in the file that -o names, or any number in a
 * folder.
 *
 * Each PRESET gives a sound FOLDER/PRESET.wav; with --each, each pair of PRESET and --events file
 * gives FOLDER/PRESET-EVENTS.wav; with --vary, each gives as many as --count says,
 * FOLDER/PRESET-007.wav and so on. All other options apply to every sound.
 */
#ifndef TABOR_HOST_RENDER_BATCH_H
#define TABOR_HOST_RENDER_BATCH_H

#include <jansson.h>
#include <stdatomic.h>

#include "render/render_request.h"
#include "render/variations.h"

/** One sound of a batch. */
typedef struct RenderJob {
  char *name;            /**< "FOLDER/tom-12", or NULL if -o names the file */
  char *output;          /**< "FOLDER/tom-12.wav", or NULL */
  char *settings;        /**< texts that the arguments lead to, or NULL */
  Arguments arguments;   /**< as if only this sound were requested */
  RenderRequest request; /**< parsed from the arguments */
  Outcome outcome;       /**< of the steps so far */
  json_t *report;        /**< facts for --json, once rendered */
  double rate;           /**< sample rate [Hz], once the request is read */
  double last_stroke;    /**< [s] */
  double length;         /**< [s], or 0: until the drum has died away */
  const void *sound;     /**< for the batch's own render function */
  atomic_uint played;    /**< frames; any thread may read it */
  atomic_bool finished;  /**< rendered or failed; any thread may read it */
} RenderJob;

/** Renders a sound whose request is read into its output; other threads may render others.
 * render_job_played() hears how far it is. */
typedef Outcome RenderJobFn(void *context, RenderJob *job);
/** Called when a sound has been rendered, on its thread but never twice at once. */
typedef Outcome RenderedFn(void *context, const RenderJob *job);

typedef struct RenderBatch {
  char *folder; /**< "FOLDER/", or NULL if -o names the file of the only sound */
  RenderJob *jobs;
  size_t count;
  Variations variations;
  uint32_t threads;     /**< number of jobs to render at once, at least 1 */
  RenderJobFn *render;  /**< NULL: render_file() */
  RenderedFn *rendered; /**< or NULL */
  void *context;        /**< of both */
  double shown;         /**< part of the sound that was shown as played: it never shrinks */
} RenderBatch;

/** Reads the request of a job whose name and arguments are set. */
Outcome render_job_read(RenderJob *job);
/** A PlayedFn whose context is the job. */
void render_job_played(void *job, uint32_t frames);
/**
 * Reads and checks everything; changes no file. A job that fails, for example because its preset
 * file is missing, prints an error and is skipped later. An invalid job refuses the batch. Free
 * with render_batch_free(), whatever the outcome.
 */
Outcome render_batch_read(const Arguments *arguments, RenderBatch *batch);
void render_batch_free(RenderBatch *batch);

#endif
