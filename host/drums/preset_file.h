/* SPDX-License-Identifier: MIT */
/**
 * @file preset_file.h
 * Reads the pairs of a preset file, which is an INI file:
 *
 *     ; a comment
 *     [batter]
 *     tension = 3000   ; N/m: why
 *
 * inih parses the lines. Errors that inih would accept silently are refused before: more than 64 KiB;
 * invalid UTF-8; control characters other than tab and line ends; lines over PRESET_LINE_LIMIT bytes,
 * section names and keys over 49 (inih truncates them); indented lines (inih appends them to the previous
 * value); text after a section's ']'; ':' for '='; a key before the first section; sections and keys that
 * occur twice; and a last line that ends right after its value without a line end, because a file
 * truncated there would give another number.
 *
 * The caller interprets sections, keys and values.
 */
#ifndef TABOR_HOST_PRESET_FILE_H
#define TABOR_HOST_PRESET_FILE_H

#include <stdbool.h>
#include <stddef.h>

/** Largest preset file [bytes]. */
#define PRESET_FILE_LIMIT 65536
/** Longest line without its end that inih 55 keeps [bytes]. */
#define PRESET_LINE_LIMIT 198

/**
 * Takes the pair in line @p line of the file; for the line of a section, @p key and @p value are NULL.
 * Returns false on an error, with one line about it in @p message; reading then ends.
 */
typedef bool PresetPairFn(void *context, const char *section, const char *key, const char *value,
                          unsigned line, char *message, size_t size);

typedef enum PresetFileStatus {
  PRESET_FILE_OK,
  PRESET_FILE_UNREADABLE, /**< missing, not permitted, not a regular file, a failed read */
  PRESET_FILE_INVALID     /**< malformed, or a pair was refused */
} PresetFileStatus;

/**
 * Calls @p pair for every section and pair of the file, in order; for none if the file as a whole is
 * malformed. On any status but PRESET_FILE_OK, @p message is one line that names the file, the line and
 * the error. Never waits for a FIFO or device and never reads more than the limit.
 */
PresetFileStatus preset_file_read(const char *path, PresetPairFn *pair, void *context,
                                  char *message, size_t size);

/** The two halves of preset_file_read(): the bytes of a file in *text, which the caller frees; NULL on an error. Of a file
 * that is too large, one byte more than the limit. */
PresetFileStatus preset_file_load(const char *path, char **text, size_t *length, char *message,
                                  size_t size);
/** The pairs of a text, which messages call @p name. */
PresetFileStatus preset_file_parse(const char *name, const char *text, size_t length,
                                   PresetPairFn *pair, void *context, char *message, size_t size);

#endif
