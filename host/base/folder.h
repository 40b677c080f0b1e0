/* SPDX-License-Identifier: MIT */
/**
 * @file folder.h
 * Output folders for sounds.
 */
#ifndef TABOR_HOST_FOLDER_H
#define TABOR_HOST_FOLDER_H

#include "base/message.h"

/** Returns "FOLDER/" for a path with or without its last separator. The caller frees it; NULL if
 * memory is short. */
char *folder_name(const char *path);
/** Joins "FOLDER/" and "file" to "FOLDER/file". The caller frees it; NULL if memory is short. */
char *folder_path(const char *folder, const char *file);
/** Refuses an existing path that is not a folder; accepts a path that does not exist. */
Outcome folder_check(const char *path);
/** Creates @p folder unless it exists. */
Outcome folder_create(const char *folder);
/** The same with the folders that it lies in. */
Outcome folder_create_whole(const char *folder);

#endif
