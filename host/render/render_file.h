/* SPDX-License-Identifier: MIT */
/**
 * @file render_file.h
 * Renders one sound: plays a parsed request into its files.
 */
#ifndef TABOR_HOST_RENDER_FILE_H
#define TABOR_HOST_RENDER_FILE_H

#include <jansson.h>

#include "render/render_request.h"

/** Called every few milliseconds of sound with the number of frames played so far. */
typedef void PlayedFn(void *context, uint32_t frames);

/**
 * Renders @p request and prints the report; with --json, gives the facts to *report. Other threads
 * may render other requests. The request cannot be rendered again, but must still be freed.
 */
Outcome render_file(RenderRequest *request, PlayedFn *played, void *context, json_t **report);

#endif
