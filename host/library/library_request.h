/* SPDX-License-Identifier: MIT */
/**
 * @file library_request.h
 * What `tabor library` is asked to do, checked in full before anything is computed or touched.
 */
#ifndef TABOR_HOST_LIBRARY_REQUEST_H
#define TABOR_HOST_LIBRARY_REQUEST_H

#include "library/library_plan.h"
#include "render/render_request.h"

typedef struct LibraryRequest {
  const char *preset;
  char *stem;       /**< what its files' names begin with */
  char *folder;     /**< "FOLDER/" */
  char *instrument; /**< "FOLDER/PRESET.sfz" */
  LibraryPlan plan;
  uint32_t seed;        /**< of --humanize */
  RenderRequest render; /**< how each sound is rendered: of its stroke and file it knows nothing */
  uint32_t threads;
} LibraryRequest;

extern const Option library_options[];

/** Reads the command line. Free with library_request_free(), whatever the outcome. */
Outcome library_request_read(const Arguments *arguments, LibraryRequest *request);
void library_request_free(LibraryRequest *request);

#endif
