/* SPDX-License-Identifier: MIT */
/**
 * @file library_batch.h
 * The sounds of a library that are still to be rendered: those without a file. A file gets its name only once
 * it is complete, so an existing file is finished.
 */
#ifndef TABOR_HOST_LIBRARY_BATCH_H
#define TABOR_HOST_LIBRARY_BATCH_H

#include "library/library_request.h"
#include "render/render_batch.h"

/** Makes the batch of missing sounds. Free with render_batch_free(), whatever the outcome. */
Outcome library_batch_make(const Arguments *arguments, const LibraryRequest *request,
                           RenderBatch *batch);

#endif
