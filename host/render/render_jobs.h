/* SPDX-License-Identifier: MIT */
/**
 * @file render_jobs.h
 * Renders the sounds of a batch in parallel. Each sound has its own model and drum and runs on one
 * thread, so the number of threads does not change a byte of any sound.
 */
#ifndef TABOR_HOST_RENDER_JOBS_H
#define TABOR_HOST_RENDER_JOBS_H

#include "render/render_batch.h"

/** Renders every valid job into an existing folder. Returns the worst outcome. */
Outcome render_jobs_do(RenderBatch *batch);
/**
 * Creates the folder and renders every valid job; a job that fails does not stop the others.
 * With --json, prints {"renders": [...]} in the order of the command line. Returns the worst
 * outcome.
 */
Outcome render_jobs_run(RenderBatch *batch);

#endif
