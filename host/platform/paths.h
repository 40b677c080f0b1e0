/* SPDX-License-Identifier: MIT */
/**
 * @file paths.h
 * What paths look like: POSIX separates names with '/', Windows also with '\' and after a drive's
 * ':'.
 */
#ifndef TABOR_HOST_PATHS_H
#define TABOR_HOST_PATHS_H

#include <stdbool.h>
#include <stddef.h>

/** True if @p path has a folder part, such as "./tabor". */
bool path_has_folder(const char *path);
/** Length of the folder part of @p path with its last separator; 0 without a folder part. */
size_t path_folder_length(const char *path);
/** The part of @p path after its folder part. */
const char *path_base(const char *path);
/** True if @p path ends with a separator, so that it can only be a folder. */
bool path_ends_with_separator(const char *path);

#endif
