/* SPDX-License-Identifier: MIT */
/**
 * @file text_file.h
 * Small text files, written in one call; a file appears complete or not at all.
 */
#ifndef TABOR_HOST_TEXT_FILE_H
#define TABOR_HOST_TEXT_FILE_H

#include "base/output_file.h"

/** Writes @p text into the file @p path; with @p keep_existing fails if it exists. */
Outcome text_file_write(const char *path, const char *text, bool keep_existing);
/** True if the contents of the file @p path are exactly @p text. */
bool text_file_holds(const char *path, const char *text);

#endif
