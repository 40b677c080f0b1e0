/* SPDX-License-Identifier: MIT */
/**
 * @file library_sfz.h
 * The instrument file of a sample library, which samplers load: SFZ with velocity layers, a key for each
 * place, and round robins. Every sound has the level of its stroke, so samplers are told to add none.
 */
#ifndef TABOR_HOST_LIBRARY_SFZ_H
#define TABOR_HOST_LIBRARY_SFZ_H

#include "library/library_request.h"

/** Writes FOLDER/PRESET.sfz as @p path, unless it is there already. */
Outcome library_sfz_write(const LibraryRequest *request, const char *path);

#endif
