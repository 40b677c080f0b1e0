/* SPDX-License-Identifier: MIT */
/**
 * @file render_progress.h
 * How far a rendering is, on the terminal: seconds of one sound; of several, how many are done and
 * about how long the others will take.
 */
#ifndef TABOR_HOST_RENDER_PROGRESS_H
#define TABOR_HOST_RENDER_PROGRESS_H

#include "render_batch.h"

/** True if standard error is a terminal and -q was not given. */
bool render_progress_is_wanted(const Arguments *arguments);
/** Shows how much of a single sound has been played. */
void render_progress_show_frames(const RenderRequest *request, uint32_t frames);
/** Shows how far @p batch is, @p left of whose jobs are not finished, @p elapsed [s] after its start. */
void render_progress_show(const RenderBatch *batch, size_t left, double elapsed);

#endif
