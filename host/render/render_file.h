/* SPDX-License-Identifier: MIT */
/**
 * @file render_file.h
 * One sound: a request that has been read is played into its files.
 */
#ifndef TABOR_HOST_RENDER_FILE_H
#define TABOR_HOST_RENDER_FILE_H

#include <jansson.h>

#include "render/render_request.h"

/** Hears every few milliseconds of sound how many frames have been played. */
typedef void PlayedFn(void *context, uint32_t frames);

/**
 * Renders @p request and says what there is to say; with --json, gives the facts to *report. Other
 * threads may render other requests. Uses the request up, which is freed all the same.
 */
Outcome render_file(RenderRequest *request, PlayedFn *played, void *context, json_t **report);

#endif
