/* SPDX-License-Identifier: MIT */
/**
 * @file drum_file.h
 * Reads preset files: one drum each.
 */
#ifndef TABOR_HOST_DRUM_FILE_H
#define TABOR_HOST_DRUM_FILE_H

#include <tabor/tabor.h>

#include "drums/preset_file.h"

/** Reads a file to @p def, as preset_file_read(). Ranges and rules are left to
 * tabor_drum_def_validate(). */
PresetFileStatus drum_file_read(const char *path, TaborDrumDef *def, char *message, size_t size);

#endif
