/* SPDX-License-Identifier: MIT */
/**
 * @file kit_hashes.h
 * Hashes of what kits give, as lines of sound_hashes.c, whose options these functions take.
 */
#ifndef TABOR_TEST_KIT_HASHES_H
#define TABOR_TEST_KIT_HASHES_H

#include <stdbool.h>

#include "tabor/tabor.h"

/** Prints the names of the built-in kits. */
void kit_hashes_list(void);
bool kit_hashes_is_kit(const char *name);
/** Plays a kit in blocks of 64, 1 and 1000 frames; the samples of the mix go to a file in @p
 * folder, unless that is NULL. */
void kit_hashes_print(const char *name, const char *quality_name, TaborQuality quality,
                      double seconds, const char *folder);

#endif
