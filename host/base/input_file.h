/* SPDX-License-Identifier: MIT */
/**
 * @file input_file.h
 * Reads a whole file of limited size into memory, also from standard input and pipes.
 */
#ifndef TABOR_HOST_INPUT_FILE_H
#define TABOR_HOST_INPUT_FILE_H

#include <stddef.h>

#include "base/message.h"

/**
 * Reads file @p name, "-" for standard input. *bytes has a terminator after its *length bytes. The
 * caller frees it with free(), whatever the outcome; it is NULL if nothing was read. Refuses more
 * than @p limit bytes.
 */
Outcome input_file_read(const char *name, size_t limit, char **bytes, size_t *length);

#define INPUT_PLACE_SIZE 256

/** Writes where a message is about, "drums.csv:3:"; of a long path its end. */
void input_place(char place[INPUT_PLACE_SIZE], const char *name, unsigned line);

#endif
