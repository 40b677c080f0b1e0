/* SPDX-License-Identifier: MIT */
/**
 * @file preset_file.h
 * Reads the pairs of a preset file, which is an INI file:
 *
 *     ; a comment
 *     [batter]
 *     tension = 3000   ; N/m: why
 *
 * inih takes the lines apart. What it would let through in silence is refused before it sees the
 * text: more than 64 KiB; anything but valid UTF-8; control characters other than tab and line
 * ends; lines over PRESET_LINE_LIMIT, section names and keys over 49 (it cuts them); indented lines (it
 * appends them to the value before); text after a section's ']'; ':' for '='; a key before the
 * first section; sections and keys that occur twice. So is a last line that ends right after its
 * value without a line end: a file that was cut off there would give another number.
 *
 * What sections, keys and values mean is up to the caller.
 */
#ifndef TABOR_HOST_PRESET_FILE_H
#define TABOR_HOST_PRESET_FILE_H

#include <stdbool.h>
#include <stddef.h>

/** Largest preset file [bytes]. */
#define PRESET_FILE_LIMIT 65536
/** Longest line [bytes], without its end: what inih 55 keeps. */
#define PRESET_LINE_LIMIT 198

/**
 * Takes a pair of the file's line @p line, or the line of a section, where @p key and @p value are
 * NULL. On false, it has written one line about what is wrong into @p message, and reading ends.
 */
typedef bool PresetPairFn(void *context, const char *section, const char *key, const char *value,
                          unsigned line, char *message, size_t size);

typedef enum PresetFileStatus {
  PRESET_FILE_OK,
  PRESET_FILE_UNREADABLE, /**< missing, not permitted, not a regular file, a failed read */
  PRESET_FILE_INVALID     /**< read, but no preset; or a pair was refused */
} PresetFileStatus;

/**
 * Calls @p pair for every section and pair of the file, in order; for none if the file as a whole is
 * malformed. Otherwise than with PRESET_FILE_OK, @p message is one line that names the file, the
 * line and the thing. Never waits for a FIFO or device and never reads more than the limit.
 */
PresetFileStatus preset_file_read(const char *path, PresetPairFn *pair, void *context,
                                  char *message, size_t size);

#endif
