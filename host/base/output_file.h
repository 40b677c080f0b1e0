/* SPDX-License-Identifier: MIT */
/**
 * @file output_file.h
 * Files that appear complete or not at all.
 *
 * A regular file is written beside its target under a temporary name and renamed when it is
 * complete; until then an older file of that name stays untouched. Anything else is written in
 * place: to pipes the bytes go as they come, for devices (and for pipes, if the format has to go
 * back to its header) they are gathered in an unnamed temporary file first. A symbolic link stays:
 * the file that it points to is written.
 *
 * Life: plan (looks, touches nothing), open, write, complete, deliver; discard at any time, any
 * number of times. Of several files all are completed before the first is delivered.
 */
#ifndef TABOR_HOST_OUTPUT_FILE_H
#define TABOR_HOST_OUTPUT_FILE_H

#include <stddef.h>
#include <sys/stat.h>

#include "base/message.h"

typedef enum OutputKind {
  OUTPUT_REPLACED, /**< a regular file: written beside, then renamed */
  OUTPUT_STREAMED, /**< a pipe: every byte goes out at once, no seeking */
  OUTPUT_GATHERED  /**< a device: the bytes are copied to it at the end */
} OutputKind;

typedef struct OutputFile {
  const char *name;   /**< as the user wrote it; "-" is the standard output */
  bool keep_existing; /**< refuse to overwrite */
  OutputKind kind;
  bool exists; /**< when it was planned; then status is valid */
  struct stat status;
  char *target;    /**< name with links followed; NULL for the standard output */
  char *temporary; /**< name of the file written beside, or NULL */
  char *set_aside; /**< name of the older file while others are delivered, or NULL */
  bool delivered;  /**< has its name */
  int descriptor;  /**< where to write, or -1 */
  int destination; /**< pipe or device that the gathered bytes go to, or -1 */
} OutputFile;

/** What an OutputFile is before output_plan(): safe to discard. */
#define OUTPUT_FILE_NONE ((OutputFile){.descriptor = -1, .destination = -1})

/**
 * Finds out what @p name is and whether it may be written. Folders, files without write permission
 * and, with @p keep_existing, existing files fail.
 */
Outcome output_plan(OutputFile *file, const char *name, bool keep_existing);
/** True if both would be written to the same place (character devices do not count). */
bool output_same(const OutputFile *a, const OutputFile *b);
/** True if the regular file @p path is what would be overwritten. */
bool output_overwrites(const OutputFile *file, const char *path);
/** Creates the temporary file or opens the pipe or device. @p seeks: a pipe is gathered, too. */
Outcome output_open(OutputFile *file, bool seeks);
/** Writes all bytes to descriptor. */
Outcome output_write(OutputFile *file, const void *bytes, size_t size);
/** Fails with the reason of errno for writing this file. */
Outcome output_failure(const OutputFile *file);
/** No more bytes: copies what was gathered to its destination, and closes. */
Outcome output_complete(OutputFile *file);
/**
 * Gives @p count completed files their names, in one go as far as signals are concerned. If one
 * cannot get its name, the others are taken away again and older files of their names come back.
 */
Outcome output_deliver(OutputFile *const *files, size_t count);
/** Removes what is not delivered, and frees. */
void output_discard(OutputFile *file);

#endif
