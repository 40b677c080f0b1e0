/* SPDX-License-Identifier: MIT */
/**
 * @file output_file.h
 * Output files that appear complete or not at all.
 *
 * A regular file is written under a temporary name in the folder of its target and renamed when it
 * is complete; until then an older file of that name stays unchanged. Other targets are written in
 * place. A pipe gets the bytes as they are written. For a device, and for a pipe if the format must
 * return to its header, the bytes are first gathered in an unnamed temporary file. A symbolic link
 * stays; the file that it points to is written.
 *
 * The temporary name is hidden and drawn at random, or one that a person finds if the program is
 * killed: "take.part.wav" of "take.wav", "take.part-2.wav" if that name is taken, and so on.
 *
 * Order of calls: plan (changes nothing), open, write, complete, deliver; discard at any time, any
 * number of times. With several files, complete all of them before delivering the first.
 */
#ifndef TABOR_HOST_OUTPUT_FILE_H
#define TABOR_HOST_OUTPUT_FILE_H

#include <stddef.h>

#include "base/message.h"
#include "platform/files.h"

typedef enum OutputKind {
  OUTPUT_REPLACED, /**< a regular file: written under a temporary name, then renamed */
  OUTPUT_STREAMED, /**< a pipe: every byte is written at once, no seeking */
  OUTPUT_GATHERED  /**< a device: the bytes are copied to it at the end */
} OutputKind;

typedef struct OutputFile {
  const char *name;   /**< as the user wrote it; "-" is standard output */
  bool keep_existing; /**< refuse to overwrite */
  OutputKind kind;
  bool exists; /**< at the time of planning; if true, status is valid */
  FileStatus status;
  char *target;    /**< name with links resolved; NULL for standard output */
  char *temporary; /**< temporary name, or NULL */
  bool findable;   /**< a person finds the temporary name; set after planning */
  char *set_aside; /**< temporary name of the older file during delivery, or NULL */
  bool delivered;  /**< the file has its name */
  int descriptor;  /**< descriptor to write to, or -1 */
  int destination; /**< pipe or device for the gathered bytes, or -1 */
} OutputFile;

/** Initial value of an OutputFile before output_plan(); safe to discard. */
#define OUTPUT_FILE_NONE ((OutputFile){.descriptor = -1, .destination = -1})

/**
 * Determines the kind of @p name and whether it may be written. Fails for folders, files without
 * write permission and, with @p keep_existing, existing files.
 */
Outcome output_plan(OutputFile *file, const char *name, bool keep_existing);
/** True if both have the same target (character devices do not count). */
bool output_same(const OutputFile *a, const OutputFile *b);
/** True if @p file would overwrite the regular file @p path. */
bool output_overwrites(const OutputFile *file, const char *path);
/** Creates the temporary file or opens the pipe or device. @p seeks: gather the bytes for a pipe,
 * too. */
Outcome output_open(OutputFile *file, bool seeks);
/** Writes all bytes to descriptor. */
Outcome output_write(OutputFile *file, const void *bytes, size_t size);
/** Goes back so many bytes, which are then written over. Not for OUTPUT_STREAMED. */
Outcome output_step_back(OutputFile *file, size_t size);
/** From now on the temporary file stays if a signal ends the program: it is worth finding. */
void output_keep(OutputFile *file);
/** Fails: this file could not be written, with the reason of errno. */
Outcome output_failure(const OutputFile *file);
/** Ends the writing: copies gathered bytes to their destination, and closes. */
Outcome output_complete(OutputFile *file);
/**
 * Gives @p count completed files their names. Signals cannot interrupt this. If one file cannot get
 * its name, the others are removed again and older files of their names are restored.
 */
Outcome output_deliver(OutputFile *const *files, size_t count);
/** Removes an undelivered file and frees the memory. */
void output_discard(OutputFile *file);

#endif
