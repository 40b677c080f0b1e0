/* SPDX-License-Identifier: MIT */
/**
 * @file render_progress.h
 * Shows the progress of a rendering on the terminal. Several sounds: "3 of 14 done, 21 %, about
 * 0:12 left". A single sound: "2 s, 21 %, about 0:12 left", or "2 s" if its length is not known in
 * advance.
 */
#ifndef TABOR_HOST_RENDER_PROGRESS_H
#define TABOR_HOST_RENDER_PROGRESS_H

#include "render/render_batch.h"

#define RENDER_PROGRESS_SIZE 128 /**< largest size of a text [bytes] */

/** True if standard error is a terminal and -q was not given. */
bool render_progress_is_wanted(const Arguments *arguments);
/** Writes the progress of @p batch, which has @p left unfinished jobs, @p elapsed [s] after its
 * start. */
void render_progress_text(RenderBatch *batch, size_t left, double elapsed, char *text, size_t size);
/** Shows the same text on the terminal. */
void render_progress_show(RenderBatch *batch, size_t left, double elapsed);

#endif
