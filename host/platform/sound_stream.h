/* SPDX-License-Identifier: MIT */
/**
 * @file sound_stream.h
 * Opens sound files by their paths, see files.h.
 */
#ifndef TABOR_HOST_SOUND_STREAM_H
#define TABOR_HOST_SOUND_STREAM_H

#include <sndfile.h>

/** sf_open() to read. */
SNDFILE *sound_stream_to_read(const char *path, SF_INFO *info);

#endif
