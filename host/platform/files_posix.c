/* SPDX-License-Identifier: MIT */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "platform/files.h"
#include "platform/paths.h"

#define MOST_LINKS 40

/* ---- status ---- */

static FileKind kind_of(mode_t mode) {
  if (S_ISREG(mode)) return FILE_KIND_REGULAR;
  if (S_ISDIR(mode)) return FILE_KIND_FOLDER;
  if (S_ISFIFO(mode) || S_ISSOCK(mode)) return FILE_KIND_PIPE;
  return S_ISCHR(mode) ? FILE_KIND_CHARACTER : FILE_KIND_OTHER;
}

static bool take_status(int result, const struct stat *found, FileStatus *status) {
  if (result != 0) return false;
  *status = (FileStatus){.kind = kind_of(found->st_mode),
                         .volume = (uint64_t)found->st_dev,
                         .index = (uint64_t)found->st_ino,
                         .size = (uint64_t)found->st_size,
                         .mode = (uint32_t)found->st_mode & 07777,
                         .owner = (uint32_t)found->st_uid,
                         .group = (uint32_t)found->st_gid};
  return true;
}

bool file_status(const char *path, FileStatus *status) {
  struct stat found;
  return take_status(stat(path, &found), &found, status);
}

bool file_status_of(int descriptor, FileStatus *status) {
  struct stat found;
  return take_status(fstat(descriptor, &found), &found, status);
}

bool file_is_same(const FileStatus *a, const FileStatus *b) {
  return a->volume == b->volume && a->index == b->index;
}

bool file_exists(const char *path) { return access(path, F_OK) == 0; }

/* For root every file is writable, but a file without any write bit is meant to stay. */
bool file_is_writable(const char *path, const FileStatus *status) {
  errno = EACCES;
  return (status->mode & (S_IWUSR | S_IWGRP | S_IWOTH)) != 0 && access(path, W_OK) == 0;
}

bool file_name_is_taken(const char *path) {
  struct stat status;
  return lstat(path, &status) == 0 && !S_ISDIR(status.st_mode);
}

/* ---- opening ---- */

FILE *file_stream_to_read(const char *path) { return fopen(path, "rb"); }

int file_open_to_read(const char *path) {
  return open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
}

int file_open_to_write(const char *path) { return open(path, O_WRONLY | O_NOCTTY); }

int file_create_unique(char *path) { return mkstemp(path); }

int file_create_new(const char *path) {
  return open(path, O_RDWR | O_CREAT | O_EXCL | O_NOCTTY, 0600);
}

/* The mask can only be read by changing it, and is that of all threads. */
void file_take_permissions(int descriptor, const FileStatus *older) {
  if (older) {
    if (fchown(descriptor, older->owner, older->group) != 0) errno = 0;
    (void)fchmod(descriptor, older->mode & 0777);
    return;
  }
  const mode_t mask = umask(0);
  (void)umask(mask);
  (void)fchmod(descriptor, 0666 & ~mask);
}

FILE *file_stream_unnamed(void) { return tmpfile(); }

int file_open_nowhere(bool to_write) {
  return open("/dev/null", (to_write ? O_WRONLY : O_RDONLY) | O_CLOEXEC);
}

int file_duplicate(int descriptor) { return fcntl(descriptor, F_DUPFD_CLOEXEC, 3); }

/* ---- names ---- */

/* Path that the symbolic link @p path leads to, in one step. */
static char *read_link(const char *path) {
  char text[4096];
  const ssize_t length = readlink(path, text, sizeof text - 1);
  if (length < 0) return NULL;
  text[length] = '\0';
  const size_t folder = text[0] == '/' ? 0 : path_folder_length(path);
  char *const whole = malloc(folder + (size_t)length + 1);
  if (!whole) return NULL;
  memcpy(whole, path, folder);
  memcpy(whole + folder, text, (size_t)length + 1);
  return whole;
}

char *file_absolute(const char *path) { return realpath(path, NULL); }

char *file_follow_links(const char *path) {
  char *followed = strdup(path);
  struct stat status;
  for (int i = 0; followed && lstat(followed, &status) == 0 && S_ISLNK(status.st_mode); i++) {
    char *const next = i < MOST_LINKS ? read_link(followed) : NULL;
    if (i == MOST_LINKS) errno = ELOOP;
    free(followed);
    followed = next;
  }
  return followed;
}

bool file_link(const char *from, const char *to) { return link(from, to) == 0; }

bool file_rename(const char *from, const char *to) { return rename(from, to) == 0; }

bool file_remove(const char *path) { return unlink(path) == 0; }

/* ---- folders and locks ---- */

bool folder_make(const char *path) { return mkdir(path, 0777) == 0; }

void folder_visit(const char *folder, void (*visit)(void *context, const char *name),
                  void *context) {
  DIR *const directory = opendir(folder);
  const struct dirent *entry;
  while (directory && (entry = readdir(directory))) visit(context, entry->d_name);
  if (directory) (void)closedir(directory);
}

/* Systems without such locks do without. */
bool file_lock(int descriptor) {
  return flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}
