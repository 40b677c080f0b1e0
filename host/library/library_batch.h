/* SPDX-License-Identifier: MIT */
/**
 * @file library_batch.h
 * The sounds of a library that are still to be rendered: those whose files are missing, or have
 * other bytes than a former run wrote.
 */
#ifndef TABOR_HOST_LIBRARY_BATCH_H
#define TABOR_HOST_LIBRARY_BATCH_H

#include "library/library_sums.h"

/**
 * Makes the batch of missing sounds, which adds to @p sums what it renders. Free with
 * render_batch_free(), whatever the outcome.
 */
Outcome library_batch_make(const Arguments *arguments, LibrarySums *sums, RenderBatch *batch);

#endif
