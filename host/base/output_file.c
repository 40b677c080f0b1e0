/* SPDX-License-Identifier: MIT */
#include "base/output_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/interrupt.h"

#define MOST_LINKS 40

Outcome output_failure(const OutputFile *file) {
  if (strcmp(file->name, "-") == 0) return standard_output_failure();
  return fail("cannot write '%s': %s", file->name, strerror(errno));
}

/* ---- planning ---- */

/* Length of the folder part of a path, with its last slash. */
static size_t folder_length(const char *path) {
  const char *const slash = strrchr(path, '/');
  return slash ? (size_t)(slash - path) + 1 : 0;
}

/* "FOLDER/name" of two parts, the first with its slash. */
static char *join(const char *folder, size_t length, const char *name) {
  char *const path = malloc(length + strlen(name) + 1);
  if (!path) return NULL;
  memcpy(path, folder, length);
  memcpy(path + length, name, strlen(name) + 1);
  return path;
}

/* Path that the symbolic link *path leads to, in one step. */
static char *read_link(const char *path) {
  char text[4096];
  const ssize_t length = readlink(path, text, sizeof text - 1);
  if (length < 0) return NULL;
  text[length] = '\0';
  return join(path, text[0] == '/' ? 0 : folder_length(path), text);
}

/* Follows links at the end of the path; what it leads to need not exist. */
static char *follow_links(const char *name) {
  char *path = strdup(name);
  struct stat status;
  for (int i = 0; path && lstat(path, &status) == 0 && S_ISLNK(status.st_mode); i++) {
    char *const next = i < MOST_LINKS ? read_link(path) : NULL;
    if (i == MOST_LINKS) errno = ELOOP;
    free(path);
    path = next;
  }
  return path;
}

/* For root every file is writable, but a file without any write bit is meant to stay. */
static bool is_writable(const char *path, mode_t mode) {
  errno = EACCES;
  return (mode & (S_IWUSR | S_IWGRP | S_IWOTH)) != 0 && access(path, W_OK) == 0;
}

static Outcome plan_existing(OutputFile *file) {
  const mode_t mode = file->status.st_mode;
  if (S_ISDIR(mode)) return fail("cannot write '%s': it is a folder", file->name);
  if (file->keep_existing) return fail("'%s' exists and is not overwritten (-n)", file->name);
  if (!is_writable(file->name, mode)) {
    return fail("cannot write '%s': it is write-protected", file->name);
  }
  return OUTCOME_OK;
}

static Outcome plan_standard_output(OutputFile *file) {
  file->keep_existing = false;
  file->exists = true;
  return fstat(STDOUT_FILENO, &file->status) == 0 ? OUTCOME_OK : output_failure(file);
}

static Outcome plan_path(OutputFile *file) {
  if (stat(file->name, &file->status) == 0) {
    file->exists = true;
    const Outcome outcome = plan_existing(file);
    if (outcome != OUTCOME_OK) return outcome;
  } else if (errno != ENOENT) {
    return output_failure(file);
  }
  if (file->exists && !S_ISREG(file->status.st_mode)) {
    file->target = strdup(file->name);
  } else {
    file->target = follow_links(file->name);
  }
  return file->target ? OUTCOME_OK : output_failure(file);
}

Outcome output_plan(OutputFile *file, const char *name, bool keep_existing) {
  *file = OUTPUT_FILE_NONE;
  file->name = strcmp(name, "/dev/stdout") == 0 ? "-" : name;
  file->keep_existing = keep_existing;
  const bool standard = strcmp(file->name, "-") == 0;
  const Outcome outcome = standard ? plan_standard_output(file) : plan_path(file);
  const mode_t mode = file->status.st_mode;
  if (!file->exists || (S_ISREG(mode) && !standard)) {
    file->kind = OUTPUT_REPLACED;
  } else {
    file->kind = S_ISFIFO(mode) || S_ISSOCK(mode) ? OUTPUT_STREAMED : OUTPUT_GATHERED;
  }
  return outcome;
}

static bool same_file(const struct stat *a, const struct stat *b) {
  return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* Status of the folder that a path lies in. */
static bool folder_status(const char *path, struct stat *status) {
  char *const folder = join(path, folder_length(path), ".");
  const bool found = folder && stat(folder, status) == 0;
  free(folder);
  return found;
}

bool output_same(const OutputFile *a, const OutputFile *b) {
  if (a->exists != b->exists) return false;
  if (a->exists) return same_file(&a->status, &b->status) && !S_ISCHR(a->status.st_mode);
  struct stat folder_a, folder_b;
  return strcmp(a->target + folder_length(a->target), b->target + folder_length(b->target)) == 0 &&
         folder_status(a->target, &folder_a) && folder_status(b->target, &folder_b) &&
         same_file(&folder_a, &folder_b);
}

bool output_overwrites(const OutputFile *file, const char *path) {
  struct stat status;
  return file->exists && S_ISREG(file->status.st_mode) && stat(path, &status) == 0 &&
         same_file(&file->status, &status);
}

/* ---- opening ---- */

/* The new file gets the permissions of the old one, or what a newly created file would have. Signals
   are held: the mask can only be read by changing it, and is that of all threads. */
static void take_permissions(const OutputFile *file) {
  if (file->exists) {
    if (fchown(file->descriptor, file->status.st_uid, file->status.st_gid) != 0) errno = 0;
    (void)fchmod(file->descriptor, file->status.st_mode & 0777);
    return;
  }
  const mode_t mask = umask(0);
  (void)umask(mask);
  (void)fchmod(file->descriptor, 0666 & ~mask);
}

static Outcome open_beside(OutputFile *file) {
  file->temporary = join(file->target, folder_length(file->target), ".tabor-XXXXXX");
  if (!file->temporary) return fail_memory();
  sigset_t before;
  interrupt_hold(&before);
  file->descriptor = mkstemp(file->temporary);
  const int error = errno;
  if (file->descriptor >= 0) {
    interrupt_guard(file->temporary);
    take_permissions(file);
  } else {
    free(file->temporary);
    file->temporary = NULL;
  }
  interrupt_resume(&before);
  errno = error;
  return file->descriptor >= 0 ? OUTCOME_OK : output_failure(file);
}

static int open_place(const OutputFile *file) {
  if (!file->target) return dup(STDOUT_FILENO);
  return open(file->target, O_WRONLY | O_NOCTTY);
}

/* A file without a name: nothing to remove, whatever happens. */
static int open_unnamed(void) {
  FILE *const stream = tmpfile();
  if (!stream) return -1;
  const int descriptor = dup(fileno(stream));
  (void)fclose(stream);
  return descriptor;
}

Outcome output_open(OutputFile *file, bool seeks) {
  if (file->kind == OUTPUT_REPLACED) return open_beside(file);
  if (seeks) file->kind = OUTPUT_GATHERED;
  file->destination = open_place(file);
  if (file->destination < 0) return output_failure(file);
  if (file->kind == OUTPUT_STREAMED) {
    file->descriptor = file->destination;
    file->destination = -1;
    return OUTCOME_OK;
  }
  file->descriptor = open_unnamed();
  if (file->descriptor < 0) return fail("cannot create a temporary file: %s", strerror(errno));
  return OUTCOME_OK;
}

/* ---- writing ---- */

static bool write_all(int descriptor, const char *bytes, size_t size) {
  while (size > 0) {
    const ssize_t written = write(descriptor, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes += written;
    size -= (size_t)written;
  }
  return true;
}

Outcome output_write(OutputFile *file, const void *bytes, size_t size) {
  return write_all(file->descriptor, bytes, size) ? OUTCOME_OK : output_failure(file);
}

/* ---- completing and delivering ---- */

/* close() can be the first to tell that the bytes did not reach a network disk. */
static bool close_once(int *descriptor) {
  const int closing = *descriptor;
  *descriptor = -1;
  return closing < 0 || close(closing) == 0;
}

static bool copy_gathered(const OutputFile *file) {
  char bytes[65536];
  if (lseek(file->descriptor, 0, SEEK_SET) != 0) return false;
  for (;;) {
    const ssize_t size = read(file->descriptor, bytes, sizeof bytes);
    if (size <= 0) return size == 0;
    if (!write_all(file->destination, bytes, (size_t)size)) return false;
  }
}

/* Unlike rename(), link() fails if the target has come into being since it was planned. */
static bool move_without_overwriting(const char *from, const char *to) {
  if (link(from, to) == 0) return unlink(from) == 0;
  struct stat status;
  if (errno == EEXIST || lstat(to, &status) == 0) return false;
  return rename(from, to) == 0; /* a file system without hard links */
}

static void forget_temporary(OutputFile *file) {
  interrupt_unguard(file->temporary);
  free(file->temporary);
  file->temporary = NULL;
}

static bool put_in_place(OutputFile *file) {
  sigset_t before;
  interrupt_hold(&before);
  const bool moved = file->keep_existing ? move_without_overwriting(file->temporary, file->target)
                                         : rename(file->temporary, file->target) == 0;
  if (moved) forget_temporary(file);
  interrupt_resume(&before);
  return moved;
}

Outcome output_complete(OutputFile *file) {
  const bool copied = file->kind != OUTPUT_GATHERED || copy_gathered(file);
  if (copied && close_once(&file->descriptor) && close_once(&file->destination)) return OUTCOME_OK;
  return output_failure(file);
}

/* Gives the file that is about to be replaced a second name, ".tabor-XXXXXX~", from which it could
 * come back. False if there is one and it cannot be kept. */
static bool set_aside(OutputFile *file) {
  struct stat status;
  const bool is_there = lstat(file->target, &status) == 0 && !S_ISDIR(status.st_mode);
  if (!is_there || file->keep_existing) return true;
  file->set_aside = join(file->temporary, strlen(file->temporary), "~");
  if (!file->set_aside) return false;
  if (link(file->target, file->set_aside) == 0) return true;
  /* a file system without hard links, or a file of someone else */
  if (errno != EEXIST && rename(file->target, file->set_aside) == 0) return true;
  free(file->set_aside);
  file->set_aside = NULL;
  return false;
}

static Outcome deliver(OutputFile *file, bool is_alone) {
  if (file->kind != OUTPUT_REPLACED) return OUTCOME_OK;
  file->delivered = (is_alone || set_aside(file)) && put_in_place(file);
  return file->delivered ? OUTCOME_OK : output_failure(file);
}

static void drop_older(OutputFile *file) {
  if (file->set_aside) (void)unlink(file->set_aside);
  free(file->set_aside);
  file->set_aside = NULL;
}

/* rename() does nothing where both names still belong to one file: hence drop_older(). */
static void withdraw(OutputFile *file) {
  if (file->set_aside) {
    (void)rename(file->set_aside, file->target);
  } else if (file->delivered) {
    (void)unlink(file->target);
  }
}

Outcome output_deliver(OutputFile *const *files, size_t count) {
  sigset_t before;
  interrupt_hold(&before);
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; i < count && outcome == OUTCOME_OK; i++) {
    outcome = deliver(files[i], count == 1);
  }
  for (size_t i = 0; i < count && outcome != OUTCOME_OK; i++) withdraw(files[i]);
  for (size_t i = 0; i < count; i++) drop_older(files[i]);
  interrupt_resume(&before);
  return outcome;
}

void output_discard(OutputFile *file) {
  (void)close_once(&file->descriptor);
  (void)close_once(&file->destination);
  if (file->temporary) {
    sigset_t before;
    interrupt_hold(&before);
    (void)unlink(file->temporary);
    forget_temporary(file);
    interrupt_resume(&before);
  }
  free(file->target);
  file->target = NULL;
}
