/* SPDX-License-Identifier: MIT */
/**
 * @file kit_file.h
 * Reads kit files (docs/kit.md).
 */
#ifndef TABOR_HOST_KIT_FILE_H
#define TABOR_HOST_KIT_FILE_H

#include <tabor/kit.h>

#include "drums/preset_file.h"

/**
 * Reads a file to @p def, as preset_file_read(), and as tabor_kit_def_read(), but for presets
 * (kit_file_set()) and sound files, which then have the names by which they are found from here.
 * Ranges and rules are left to tabor_kit_def_validate().
 */
PresetFileStatus kit_file_read(const char *path, TaborKitDef *def, char *message, size_t size);
/** The same of the text of a kit file @p name, by which messages call it. */
PresetFileStatus kit_file_parse(const char *name, const char *text, size_t length, TaborKitDef *def,
                                char *message, size_t size);
/** tabor_kit_def_set(), where the preset of a drum may be the user's own, too: a name, or a file.
 */
TaborStatus kit_file_set(TaborKitDef *def, const char *key, const char *value, TaborError *error);
/** Gives sound files their names from the root, so that the kit can be written anywhere. */
void kit_file_root_samples(TaborKitDef *def);
/** Names a kit as its file is called, without folder and extension. */
void kit_name_after(TaborKitDef *def, const char *path);
/** True if the definition can play: it has a drum, each can stand in its place, and passes
 * tabor_kit_def_validate(). Otherwise @p message says why. */
bool kit_file_check(const char *name, const TaborKitDef *def, char *message, size_t size);

#endif
