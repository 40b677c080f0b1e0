/* SPDX-License-Identifier: MIT */
/**
 * @file preset_file.h
 * Files of the form that tabor_text_read() reads: presets, kits, MIDI maps, keys.
 */
#ifndef TABOR_HOST_PRESET_FILE_H
#define TABOR_HOST_PRESET_FILE_H

#include <stddef.h>
#include <tabor/tabor.h>

typedef enum PresetFileStatus {
  PRESET_FILE_OK,
  PRESET_FILE_UNREADABLE, /**< missing, not permitted, not a regular file, too large, a failed read
                           */
  PRESET_FILE_INVALID     /**< malformed, or a line was refused */
} PresetFileStatus;

/**
 * Puts the text of a file into *text, which the caller frees; NULL on an error, which @p message
 * then tells in one line that names the file. Never waits for a FIFO or device and never reads more
 * than TABOR_TEXT_LIMIT bytes.
 */
PresetFileStatus preset_file_load(const char *path, char **text, size_t *length, char *message,
                                  size_t size);

/** Reads a file with tabor_text_read(). On an error, @p message is one line that names the file,
 * the line and the error. */
PresetFileStatus preset_file_read(const char *path, TaborTextTake *take, void *context,
                                  char *message, size_t size);
/** The same of a text, which messages call @p name. */
PresetFileStatus preset_file_parse(const char *name, const char *text, size_t length,
                                   TaborTextTake *take, void *context, char *message, size_t size);
/** Writes "name:line: what is wrong" to @p message; of a long name the end. */
PresetFileStatus preset_file_refuse(const char *name, const TaborError *error, char *message,
                                    size_t size);

#endif
