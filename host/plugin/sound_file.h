/* SPDX-License-Identifier: MIT */
/**
 * @file sound_file.h
 * Reads sound files in plugins. These need nothing but the C library to be loaded, so libsndfile is
 * asked for when there is a file to read.
 */
#ifndef TABOR_PLUGIN_SOUND_FILE_H
#define TABOR_PLUGIN_SOUND_FILE_H

#include <stddef.h>

#include "kit/kit_sounds.h"

/** Reads the file @p path, mono or the first two channels. False, with one line in @p message, if
 * there is no sound to be had. */
bool sound_file_read(const char *path, KitSound *sound, char *message, size_t size);

#endif
