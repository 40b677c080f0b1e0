/* SPDX-License-Identifier: MIT */
/**
 * @file library_request.h
 * The request to `tabor library`, checked in full before anything is computed or written.
 */
#ifndef TABOR_HOST_LIBRARY_REQUEST_H
#define TABOR_HOST_LIBRARY_REQUEST_H

#include "library/library_plan.h"
#include "render/render_request.h"

/** A kit, instead of a drum: library_kit.h. */
typedef struct LibraryKit LibraryKit;

typedef struct LibraryRequest {
  const char *preset; /**< or the kit */
  LibraryKit *kit;    /**< NULL: a single drum */
  char *stem;         /**< start of the file names */
  char *folder;       /**< "FOLDER/" */
  char *instrument;   /**< "FOLDER/PRESET.sfz" */
  LibraryPlan plan;
  uint32_t seed;        /**< seed of --humanize */
  RenderRequest render; /**< settings for every sound, without stroke and file */
  uint32_t threads;
} LibraryRequest;

extern const Option library_options[];

/** Reads the command line. Free with library_request_free(), whatever the outcome. */
Outcome library_request_read(const Arguments *arguments, LibraryRequest *request);
void library_request_free(LibraryRequest *request);

#endif
