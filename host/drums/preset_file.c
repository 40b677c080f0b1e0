/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "drums/preset_file.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "platform/files.h"

/* A byte of a path that a message can carry. */
static char printable(char c) { return (unsigned char)c < 0x20 || c == 0x7F ? '?' : c; }

/* "name: " or "name:12: ". A long name leaves half of the room for what is wrong. */
static size_t write_place(const char *name, uint32_t line, char *message, size_t size) {
  const size_t room = size / 2, length = strlen(name);
  const bool cut = length > room;
  char number[16] = "";
  if (line > 0) (void)snprintf(number, sizeof number, ":%lu", (unsigned long)line);
  const int written =
    snprintf(message, size, "%s%s%s: ", cut ? "..." : "", name + (cut ? length - room : 0), number);
  for (char *c = message; *c; c++) *c = printable(*c);
  return written >= 0 && (size_t)written < size ? (size_t)written : size - 1;
}

static void write_message(const char *name, uint32_t line, const char *what, char *message,
                          size_t size) {
  if (size == 0) return;
  const size_t place = write_place(name, line, message, size);
  (void)snprintf(message + place, size - place, "%s", what);
}

PresetFileStatus preset_file_refuse(const char *name, const TaborError *error, char *message,
                                    size_t size) {
  write_message(name, error->line, error->message, message, size);
  return PRESET_FILE_INVALID;
}

/* ---- files ----------------------------------------------------------------------------------- */

/* What is wrong, or NULL. */
static const char *read_bytes(int file, char *text, size_t room, size_t *length) {
  while (*length < room) {
    const ssize_t count = read(file, text + *length, (unsigned)(room - *length));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return strerror(errno);
    if (count == 0) return NULL;
    *length += (size_t)count;
  }
  return NULL;
}

/* Of a file that is too large, one byte more than the limit. */
static const char *read_regular(int file, char **text, size_t *length) {
  FileStatus status;
  if (!file_status_of(file, &status)) return strerror(errno);
  if (status.kind == FILE_KIND_FOLDER) return strerror(EISDIR);
  if (status.kind != FILE_KIND_REGULAR) return "not a regular file";
  const size_t room = status.size <= TABOR_TEXT_LIMIT ? (size_t)status.size : TABOR_TEXT_LIMIT + 1;
  *text = calloc(room + 1, 1);
  return *text ? read_bytes(file, *text, room, length) : "out of memory";
}

PresetFileStatus preset_file_load(const char *path, char **text, size_t *length, char *message,
                                  size_t size) {
  if (size > 0) message[0] = '\0';
  *text = NULL;
  *length = 0;
  /* Without waiting for a FIFO's writer; nothing else is read from it, as it is no regular file. */
  const int file = file_open_to_read(path);
  const char *const wrong = file < 0 ? strerror(errno) : read_regular(file, text, length);
  if (wrong) {
    write_message(path, 0, wrong, message, size);
    free(*text);
    *text = NULL;
  }
  if (file >= 0) (void)close(file);
  return wrong ? PRESET_FILE_UNREADABLE : PRESET_FILE_OK;
}

/* ---- texts ----------------------------------------------------------------------------------- */

PresetFileStatus preset_file_parse(const char *name, const char *text, size_t length,
                                   TaborTextTake *take, void *context, char *message, size_t size) {
  TaborError error;
  if (size > 0) message[0] = '\0';
  if (tabor_text_read(text, length, take, context, &error) == TABOR_OK) return PRESET_FILE_OK;
  return preset_file_refuse(name, &error, message, size);
}

PresetFileStatus preset_file_read(const char *path, TaborTextTake *take, void *context,
                                  char *message, size_t size) {
  char *text;
  size_t length;
  PresetFileStatus status = preset_file_load(path, &text, &length, message, size);
  if (status == PRESET_FILE_OK) {
    status = preset_file_parse(path, text, length, take, context, message, size);
  }
  free(text);
  return status;
}
