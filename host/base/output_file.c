/* SPDX-License-Identifier: MIT */
#include "base/output_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/interrupt.h"
#include "base/part_name.h"
#include "platform/paths.h"

#define MOST_PARTS 999 /* numbers of temporary names that a person finds */

Outcome output_failure(const OutputFile *file) {
  if (strcmp(file->name, "-") == 0) return standard_output_failure();
  return fail("cannot write '%s': %s", file->name, strerror(errno));
}

/* ---- planning ---- */

/* "FOLDER/name" of two parts, the first with its slash. */
static char *join(const char *folder, size_t length, const char *name) {
  char *const path = malloc(length + strlen(name) + 1);
  if (!path) return NULL;
  memcpy(path, folder, length);
  memcpy(path + length, name, strlen(name) + 1);
  return path;
}

static Outcome plan_existing(OutputFile *file) {
  if (file->status.kind == FILE_KIND_FOLDER)
    return fail("cannot write '%s': it is a folder", file->name);
  if (file->keep_existing) return fail("'%s' exists and is not overwritten (-n)", file->name);
  if (!file_is_writable(file->name, &file->status)) {
    return fail("cannot write '%s': it is write-protected", file->name);
  }
  return OUTCOME_OK;
}

static Outcome plan_standard_output(OutputFile *file) {
  file->keep_existing = false;
  file->exists = true;
  return file_status_of(STDOUT_FILENO, &file->status) ? OUTCOME_OK : output_failure(file);
}

static Outcome plan_path(OutputFile *file) {
  if (file_status(file->name, &file->status)) {
    file->exists = true;
    const Outcome outcome = plan_existing(file);
    if (outcome != OUTCOME_OK) return outcome;
  } else if (errno != ENOENT) {
    return output_failure(file);
  }
  if (file->exists && file->status.kind != FILE_KIND_REGULAR) {
    file->target = strdup(file->name);
  } else {
    file->target = file_follow_links(file->name);
  }
  return file->target ? OUTCOME_OK : output_failure(file);
}

Outcome output_plan(OutputFile *file, const char *name, bool keep_existing) {
  *file = OUTPUT_FILE_NONE;
  file->name = strcmp(name, "/dev/stdout") == 0 ? "-" : name;
  file->keep_existing = keep_existing;
  const bool standard = strcmp(file->name, "-") == 0;
  const Outcome outcome = standard ? plan_standard_output(file) : plan_path(file);
  const FileKind kind = file->status.kind;
  if (!file->exists || (kind == FILE_KIND_REGULAR && !standard)) {
    file->kind = OUTPUT_REPLACED;
  } else {
    file->kind = kind == FILE_KIND_PIPE ? OUTPUT_STREAMED : OUTPUT_GATHERED;
  }
  return outcome;
}

/* Status of the folder that a path lies in. */
static bool folder_status(const char *path, FileStatus *status) {
  char *const folder = join(path, path_folder_length(path), ".");
  const bool found = folder && file_status(folder, status);
  free(folder);
  return found;
}

bool output_same(const OutputFile *a, const OutputFile *b) {
  if (a->exists != b->exists) return false;
  if (a->exists) {
    return file_is_same(&a->status, &b->status) && a->status.kind != FILE_KIND_CHARACTER;
  }
  FileStatus folder_a, folder_b;
  return strcmp(path_base(a->target), path_base(b->target)) == 0 &&
         folder_status(a->target, &folder_a) && folder_status(b->target, &folder_b) &&
         file_is_same(&folder_a, &folder_b);
}

bool output_overwrites(const OutputFile *file, const char *path) {
  FileStatus status;
  return file->exists && file->status.kind == FILE_KIND_REGULAR && file_status(path, &status) &&
         file_is_same(&file->status, &status);
}

/* ---- opening ---- */

static int create_hidden(OutputFile *file) {
  file->temporary = join(file->target, path_folder_length(file->target), ".tabor-XXXXXX");
  return file->temporary ? file_create_unique(file->temporary) : -1;
}

/* What a program that was killed has left keeps its name. */
static int create_findable(OutputFile *file) {
  int descriptor = -1;
  errno = EEXIST;
  for (unsigned number = 1; number <= MOST_PARTS && descriptor < 0 && errno == EEXIST; number++) {
    free(file->temporary);
    file->temporary = part_name(file->target, number);
    if (!file->temporary) return -1;
    descriptor = file_create_new(file->temporary);
  }
  if (descriptor >= 0 || errno != ENAMETOOLONG) return descriptor;
  free(file->temporary);
  return create_hidden(file);
}

static Outcome open_beside(OutputFile *file) {
  SignalMask before;
  interrupt_hold(&before);
  file->descriptor = file->findable ? create_findable(file) : create_hidden(file);
  const int error = errno;
  const bool is_named = file->temporary != NULL;
  if (file->descriptor >= 0) {
    interrupt_guard(file->temporary);
    file_take_permissions(file->descriptor, file->exists ? &file->status : NULL);
  } else {
    free(file->temporary);
    file->temporary = NULL;
  }
  interrupt_resume(&before);
  errno = error;
  if (file->descriptor >= 0) return OUTCOME_OK;
  return is_named ? output_failure(file) : fail_memory();
}

static int open_place(const OutputFile *file) {
  if (!file->target) return dup(STDOUT_FILENO);
  return file_open_to_write(file->target);
}

/* A file without a name: nothing to remove, whatever happens. */
static int open_unnamed(void) {
  FILE *const stream = file_stream_unnamed();
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

Outcome output_step_back(OutputFile *file, size_t size) {
  const bool done = lseek(file->descriptor, -(off_t)size, SEEK_CUR) >= 0;
  return done ? OUTCOME_OK : output_failure(file);
}

void output_keep(OutputFile *file) {
  SignalMask before;
  interrupt_hold(&before);
  if (file->temporary) interrupt_unguard(file->temporary);
  interrupt_resume(&before);
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
  if (file_link(from, to)) return file_remove(from);
  if (errno == EEXIST || file_exists(to) || file_name_is_taken(to)) return false;
  return file_rename(from, to); /* a file system without hard links */
}

static void forget_temporary(OutputFile *file) {
  interrupt_unguard(file->temporary);
  free(file->temporary);
  file->temporary = NULL;
}

static bool put_in_place(OutputFile *file) {
  SignalMask before;
  interrupt_hold(&before);
  const bool moved = file->keep_existing ? move_without_overwriting(file->temporary, file->target)
                                         : file_rename(file->temporary, file->target);
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
  if (!file_name_is_taken(file->target) || file->keep_existing) return true;
  file->set_aside = join(file->temporary, strlen(file->temporary), "~");
  if (!file->set_aside) return false;
  if (file_link(file->target, file->set_aside)) return true;
  /* a file system without hard links, or a file of someone else */
  if (errno != EEXIST && file_rename(file->target, file->set_aside)) return true;
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
  if (file->set_aside) (void)file_remove(file->set_aside);
  free(file->set_aside);
  file->set_aside = NULL;
}

/* rename() does nothing where both names still belong to one file: hence drop_older(). */
static void withdraw(OutputFile *file) {
  if (file->set_aside) {
    (void)file_rename(file->set_aside, file->target);
  } else if (file->delivered) {
    (void)file_remove(file->target);
  }
}

Outcome output_deliver(OutputFile *const *files, size_t count) {
  SignalMask before;
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
    SignalMask before;
    interrupt_hold(&before);
    (void)file_remove(file->temporary);
    forget_temporary(file);
    interrupt_resume(&before);
  }
  free(file->target);
  file->target = NULL;
}
