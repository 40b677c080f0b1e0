/* SPDX-License-Identifier: MIT */
/**
 * @file stream_text.h
 * States are texts: written to and read from a host's stream as a whole. MAIN: all functions.
 */
#ifndef TABOR_CLAP_STREAM_TEXT_H
#define TABOR_CLAP_STREAM_TEXT_H

#include <clap/clap.h>

/** Writes @p size bytes. False if the host does not take them all. */
bool stream_write(const clap_ostream_t *stream, const char *text, size_t size);
/** Everything that the stream has, terminated; NULL if it is longer than @p limit or cannot be
 * read. The caller frees it. */
char *stream_read(const clap_istream_t *stream, size_t limit);
/** The bits of a value as 8 hexadecimal digits, and back. False if @p digits are no finite number.
 */
void stream_float_digits(float value, char digits[9]);
bool stream_float(const char *digits, float *value);

#endif
