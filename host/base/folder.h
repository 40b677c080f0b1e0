/* SPDX-License-Identifier: MIT */
/**
 * @file folder.h
 * Folders that sounds are written into.
 */
#ifndef TABOR_HOST_FOLDER_H
#define TABOR_HOST_FOLDER_H

#include <stdbool.h>

#include "base/message.h"

bool folder_ends_with_slash(const char *path);
/** "FOLDER/" of a path with or without the slash, to be freed; NULL without memory. */
char *folder_name(const char *path);
/** "FOLDER/file" of "FOLDER/" and "file", to be freed; NULL without memory. */
char *folder_path(const char *folder, const char *file);
/** Refuses what is there and no folder; what is not there may become one. */
Outcome folder_check(const char *path);
/** Creates @p folder unless it is there. */
Outcome folder_create(const char *folder);

#endif
