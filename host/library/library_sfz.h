/* SPDX-License-Identifier: MIT */
/**
 * @file library_sfz.h
 * The instrument file of a sample library for samplers: SFZ with velocity layers, one key per
 * position, and round robins. Each sound has the level of its stroke, so the file switches off the
 * samplers' velocity scaling.
 */
#ifndef TABOR_HOST_LIBRARY_SFZ_H
#define TABOR_HOST_LIBRARY_SFZ_H

#include "library/library_request.h"

/** Writes FOLDER/PRESET.sfz as @p path, unless that file exists. */
Outcome library_sfz_write(const LibraryRequest *request, const char *path);

#endif
