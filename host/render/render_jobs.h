/* SPDX-License-Identifier: MIT */
/**
 * @file render_jobs.h
 * The sounds of a batch, rendered side by side: each has a thread of its own, a model and a drum, so
 * the number of threads changes no byte of any.
 */
#ifndef TABOR_HOST_RENDER_JOBS_H
#define TABOR_HOST_RENDER_JOBS_H

#include "render/render_batch.h"

/** Renders every job that is right, in a folder that is there. Returns the worst outcome. */
Outcome render_jobs_do(RenderBatch *batch);
/**
 * Creates the folder and renders every job that is right; those that fail do not stop the others.
 * With --json, prints {"renders": [...]} in the order of the command line. Returns the worst outcome.
 */
Outcome render_jobs_run(RenderBatch *batch);

#endif
