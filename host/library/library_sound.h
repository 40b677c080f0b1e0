/* SPDX-License-Identifier: MIT */
/**
 * @file library_sound.h
 * Checks whether an earlier run finished a sound of a library.
 */
#ifndef TABOR_HOST_LIBRARY_SOUND_H
#define TABOR_HOST_LIBRARY_SOUND_H

#include <stdbool.h>

#include "render/render_request.h"

/**
 * True if @p path is a complete sound file with the format and length of @p request. A damaged or unreadable
 * file is not finished.
 */
bool library_sound_is_finished(const char *path, const RenderRequest *request);

#endif
