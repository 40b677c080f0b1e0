/* SPDX-License-Identifier: MIT */
/**
 * @file duration.h
 * What becomes of a --duration that ends before what is to be played.
 */
#ifndef TABOR_HOST_DURATION_H
#define TABOR_HOST_DURATION_H

#include "base/options.h"

/**
 * Of a song, @p is_song, the beginning may be enough: a note says so, unless @p quiet. A stroke of
 * --strike or --events that would not be heard is a mistake. @p last is when the last stroke comes,
 * after --duration [s].
 */
Outcome duration_too_short(const Arguments *arguments, bool is_song, double last, bool quiet);

#endif
