/* SPDX-License-Identifier: MIT */
/**
 * @file library_sound.h
 * Whether a sound of a library is there from a run before.
 */
#ifndef TABOR_HOST_LIBRARY_SOUND_H
#define TABOR_HOST_LIBRARY_SOUND_H

#include <stdbool.h>

#include "render/render_request.h"

/**
 * True if @p path is a sound file of the format and length of @p request, and no part of it is missing.
 * What is damaged or cannot be read is not finished.
 */
bool library_sound_is_finished(const char *path, const RenderRequest *request);

#endif
