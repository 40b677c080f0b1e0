/* SPDX-License-Identifier: MIT */
/**
 * @file files.h
 * Files by their paths, which are UTF-8 on Windows and bytes elsewhere. A function that fails sets
 * errno. Descriptors are for read(), write(), lseek(), ftruncate() and close(), and never translate
 * line ends.
 */
#ifndef TABOR_HOST_FILES_H
#define TABOR_HOST_FILES_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef enum FileKind {
  FILE_KIND_REGULAR,
  FILE_KIND_FOLDER,
  FILE_KIND_PIPE,      /**< or a socket */
  FILE_KIND_CHARACTER, /**< a terminal, the null device */
  FILE_KIND_OTHER
} FileKind;

typedef struct FileStatus {
  FileKind kind;
  uint64_t volume, index;      /**< the same for two paths if they name one file */
  uint64_t size;               /**< [bytes] */
  uint32_t mode, owner, group; /**< permissions on POSIX; 0 on Windows, but for read-only files */
} FileStatus;

/** Status of what @p path leads to. */
bool file_status(const char *path, FileStatus *status);
bool file_status_of(int descriptor, FileStatus *status);
bool file_is_same(const FileStatus *a, const FileStatus *b);
/** True if @p path leads to something. */
bool file_exists(const char *path);
/** True if @p path, with this status, is not write-protected. */
bool file_is_writable(const char *path, const FileStatus *status);
/** True if the name @p path is taken, by a link or a file but not by a folder. */
bool file_name_is_taken(const char *path);

FILE *file_stream_to_read(const char *path);
/** Descriptor to read from, or -1; does not wait for the writer of a FIFO. */
int file_open_to_read(const char *path);
/** Descriptor to write to an existing file or device, or -1. */
int file_open_to_write(const char *path);
/** Creates a new file; replaces the XXXXXX that end @p path by letters. Returns its descriptor, or
 * -1. */
int file_create_unique(char *path);
/** Creates a new file; fails if the name is taken. Returns its descriptor, or -1. */
int file_create_new(const char *path);
/** Gives a new file the permissions of @p older, or with NULL those that a new file has. Not for
 * two threads at once. */
void file_take_permissions(int descriptor, const FileStatus *older);
/** A temporary file without a name, which goes when it is closed; NULL if there is none. */
FILE *file_stream_unnamed(void);
/** Descriptor of the null device, or -1. */
int file_open_nowhere(bool to_write);
/** Another descriptor of the same file, which child processes do not inherit; -1 if there is none.
 */
int file_duplicate(int descriptor);

/** The same file from any folder: @p path, which must exist, from the root. The caller frees the
 * result; NULL on an error. */
char *file_absolute(const char *path);
/** Follows symbolic links at the end of @p path; the file need not exist. The caller frees the
 * result. */
char *file_follow_links(const char *path);
/** Gives the file @p from the second name @p to. Fails if that is taken, or the file system has no
 * such names. */
bool file_link(const char *from, const char *to);
/** Renames; replaces a file of the name @p to. */
bool file_rename(const char *from, const char *to);
/** Removes a file. Async-signal-safe on POSIX. */
bool file_remove(const char *path);

bool folder_make(const char *path);
/** Calls @p visit for the name of each file of a folder, in no order; a file may be removed
 * meanwhile. */
void folder_visit(const char *folder, void (*visit)(void *context, const char *name),
                  void *context);

/** Locks a file until the process ends. False if another process has locked it. */
bool file_lock(int descriptor);

#endif
