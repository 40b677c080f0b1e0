/* SPDX-License-Identifier: MIT */
/**
 * @file user_presets.h
 * The user's own drums and kits: the files NAME.ini in a folder of theirs, which the program and
 * the plugins share.
 */
#ifndef TABOR_HOST_USER_PRESETS_H
#define TABOR_HOST_USER_PRESETS_H

#include <stdbool.h>
#include <stddef.h>

#define USER_PRESET_PATH 4096 /**< bytes of a path */

/**
 * Names the folder: tabor in $XDG_DATA_HOME or ~/.local/share, on Windows in %APPDATA%. It need not
 * be there. False if the user has no such place.
 */
bool user_folder(char path[USER_PRESET_PATH]);
/** Names a file of the folder, which need not be there. */
bool user_file_path(const char *file, char path[USER_PRESET_PATH]);
/** Writes a file of the folder, which is made if need be, as a whole or not at all. False, with one
 * line in @p message. */
bool user_folder_write(const char *file, const char *text, char *message, size_t size);
/** Names the file of the preset @p name, which need not be there. False if the user has no such
 * folder. */
bool user_preset_path(const char *name, char path[USER_PRESET_PATH]);
/** Returns the file of the preset @p name, in @p room; NULL if there is none. */
const char *user_preset_find(const char *name, char room[USER_PRESET_PATH]);

/** True if @p preset is a file: it has a folder part or ends in ".ini". */
bool preset_is_file(const char *preset);
/** Start of the file names for a preset. */
typedef struct PresetStem {
  const char *text;
  int length;
} PresetStem;
/** Gives "snare-14x5.5" for "snare-14x5.5" and for "drums/snare-14x5.5.ini". */
PresetStem preset_stem(const char *preset);

#endif
