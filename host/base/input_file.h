/* SPDX-License-Identifier: MIT */
/**
 * @file input_file.h
 * A whole file in memory, of bounded size: from the standard input and pipes, too.
 */
#ifndef TABOR_HOST_INPUT_FILE_H
#define TABOR_HOST_INPUT_FILE_H

#include <stddef.h>

#include "base/message.h"

/**
 * Reads file @p name, "-" for the standard input. *bytes has a terminator behind its *length bytes, and
 * is the caller's to free(), whatever the outcome; NULL if nothing was read. Refuses more than
 * @p limit bytes.
 */
Outcome input_file_read(const char *name, size_t limit, char **bytes, size_t *length);

#endif
