/* SPDX-License-Identifier: MIT */
/**
 * @file render_progress.h
 * How far a rendering is, on the terminal. Several sounds: "3 of 14 done, 21 %, about 0:12 left". A single
 * sound: "2 s, 21 %, about 0:12 left", or "2 s" where nobody knows when its drum will have died away.
 */
#ifndef TABOR_HOST_RENDER_PROGRESS_H
#define TABOR_HOST_RENDER_PROGRESS_H

#include "render/render_batch.h"

#define RENDER_PROGRESS_SIZE 128 /**< bytes that any text fits in */

/** True if standard error is a terminal and -q was not given. */
bool render_progress_is_wanted(const Arguments *arguments);
/** Writes how far @p batch is, @p left of whose jobs are not finished, @p elapsed [s] after its start. */
void render_progress_text(const RenderBatch *batch, size_t left, double elapsed, char *text,
                          size_t size);
/** Shows that. */
void render_progress_show(const RenderBatch *batch, size_t left, double elapsed);

#endif
