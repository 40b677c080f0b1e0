/* SPDX-License-Identifier: MIT */
/**
 * @file library_batch.h
 * What is left to render of a library: the sounds whose files are not there yet. A file has its name only
 * once it is complete, so one that is there is finished.
 */
#ifndef TABOR_HOST_LIBRARY_BATCH_H
#define TABOR_HOST_LIBRARY_BATCH_H

#include "library/library_request.h"
#include "render/render_batch.h"

/** Free with render_batch_free(), whatever the outcome. */
Outcome library_batch_make(const Arguments *arguments, const LibraryRequest *request,
                           RenderBatch *batch);

#endif
