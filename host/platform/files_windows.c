/* SPDX-License-Identifier: MIT */
#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <stdlib.h>
#include <string.h>
#include <windows.h>

#include "platform/files.h"
#include "platform/wide.h"

/* Others may open, rename and remove a file that is open, as on POSIX. */
#define SHARED (FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE)
#define FOLDERS_TOO FILE_FLAG_BACKUP_SEMANTICS
#define MODE_WRITABLE 0222u

static bool failure(void) { return wide_set_errno() != 0; }

static HANDLE open_handle(const char *path, DWORD access, DWORD creation, DWORD flags) {
  wchar_t *const wide = wide_from_utf8(path);
  if (!wide) return INVALID_HANDLE_VALUE;
  const HANDLE handle = CreateFileW(wide, access, SHARED, NULL, creation, flags, NULL);
  if (handle == INVALID_HANDLE_VALUE) (void)failure();
  free(wide);
  return handle;
}

static int to_descriptor(HANDLE handle, int flags) {
  if (handle == INVALID_HANDLE_VALUE) return -1;
  const int descriptor = _open_osfhandle((intptr_t)handle, flags | _O_BINARY | _O_NOINHERIT);
  if (descriptor < 0) (void)CloseHandle(handle);
  return descriptor;
}

/* ---- status ---- */

static bool status_of_handle(HANDLE handle, FileStatus *status) {
  BY_HANDLE_FILE_INFORMATION found;
  const DWORD type = GetFileType(handle);
  *status = (FileStatus){.kind = FILE_KIND_OTHER, .mode = MODE_WRITABLE};
  if (type == FILE_TYPE_PIPE) status->kind = FILE_KIND_PIPE;
  if (type == FILE_TYPE_CHAR) status->kind = FILE_KIND_CHARACTER;
  if (type != FILE_TYPE_DISK) return true;
  if (!GetFileInformationByHandle(handle, &found)) return failure();
  const bool is_folder = (found.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  status->kind = is_folder ? FILE_KIND_FOLDER : FILE_KIND_REGULAR;
  status->volume = found.dwVolumeSerialNumber;
  status->index = (uint64_t)found.nFileIndexHigh << 32 | found.nFileIndexLow;
  status->size = (uint64_t)found.nFileSizeHigh << 32 | found.nFileSizeLow;
  if ((found.dwFileAttributes & FILE_ATTRIBUTE_READONLY) != 0) status->mode = 0;
  return true;
}

bool file_status(const char *path, FileStatus *status) {
  const HANDLE handle = open_handle(path, FILE_READ_ATTRIBUTES, OPEN_EXISTING, FOLDERS_TOO);
  if (handle == INVALID_HANDLE_VALUE) return false;
  const bool found = status_of_handle(handle, status);
  (void)CloseHandle(handle);
  return found;
}

bool file_status_of(int descriptor, FileStatus *status) {
  const HANDLE handle = (HANDLE)_get_osfhandle(descriptor);
  if (handle == INVALID_HANDLE_VALUE) {
    errno = EBADF;
    return false;
  }
  if (status_of_handle(handle, status)) return true;
  if (GetFileType(handle) != FILE_TYPE_DISK) return false;
  status->kind = FILE_KIND_REGULAR; /* wine tells no more of a file that it inherited */
  return true;
}

bool file_is_same(const FileStatus *a, const FileStatus *b) {
  return a->volume == b->volume && a->index == b->index;
}

static DWORD attributes_of(const char *path) {
  wchar_t *const wide = wide_from_utf8(path);
  const DWORD attributes = wide ? GetFileAttributesW(wide) : INVALID_FILE_ATTRIBUTES;
  if (wide && attributes == INVALID_FILE_ATTRIBUTES) (void)failure();
  free(wide);
  return attributes;
}

bool file_exists(const char *path) { return attributes_of(path) != INVALID_FILE_ATTRIBUTES; }

bool file_is_writable(const char *path, const FileStatus *status) {
  (void)path;
  errno = EACCES;
  return status->mode != 0;
}

bool file_name_is_taken(const char *path) {
  const DWORD attributes = attributes_of(path);
  return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) == 0;
}

/* ---- opening ---- */

static bool is_folder(const char *path) {
  FileStatus status;
  return file_status(path, &status) && status.kind == FILE_KIND_FOLDER;
}

/* Windows opens no folder; it only denies access. */
int file_open_to_read(const char *path) {
  if (is_folder(path)) {
    errno = EISDIR;
    return -1;
  }
  return to_descriptor(open_handle(path, GENERIC_READ, OPEN_EXISTING, 0), _O_RDONLY);
}

FILE *file_stream_to_read(const char *path) {
  const int descriptor = file_open_to_read(path);
  FILE *const stream = descriptor >= 0 ? _fdopen(descriptor, "rb") : NULL;
  if (!stream && descriptor >= 0) (void)_close(descriptor);
  return stream;
}

int file_open_to_write(const char *path) {
  return to_descriptor(open_handle(path, GENERIC_WRITE, OPEN_EXISTING, 0), _O_WRONLY);
}

/* Six letters from the clock and the process, other ones after each failure. */
static void write_letters(char *end, uint64_t number) {
  static const char letters[] = "abcdefghijklmnopqrstuvwxyz0123456789";
  for (int i = 0; i < 6; i++, number /= 36) end[i] = letters[number % 36];
}

static HANDLE create_new(const char *path) {
  return open_handle(path, GENERIC_READ | GENERIC_WRITE, CREATE_NEW, FILE_ATTRIBUTE_NORMAL);
}

int file_create_unique(char *path) {
  char *const end = path + strlen(path) - strlen("XXXXXX");
  for (uint64_t attempt = 0; attempt < 1000; attempt++) {
    LARGE_INTEGER ticks;
    (void)QueryPerformanceCounter(&ticks);
    write_letters(end, (uint64_t)ticks.QuadPart * 7919 + GetCurrentProcessId() + 104729 * attempt);
    const HANDLE handle = create_new(path);
    if (handle != INVALID_HANDLE_VALUE || errno != EEXIST) return to_descriptor(handle, _O_RDWR);
  }
  return -1;
}

int file_create_new(const char *path) { return to_descriptor(create_new(path), _O_RDWR); }

/* Files inherit the permissions of their folder. */
void file_take_permissions(int descriptor, const FileStatus *older) {
  (void)descriptor;
  (void)older;
}

/* tmpfile() of Windows' C library wants to write to the root of the drive. */
FILE *file_stream_unnamed(void) {
  wchar_t folder[MAX_PATH + 1], path[MAX_PATH + 1];
  if (GetTempPathW(MAX_PATH, folder) == 0 || GetTempFileNameW(folder, L"tab", 0, path) == 0) {
    (void)failure();
    return NULL;
  }
  const HANDLE handle = CreateFileW(path, GENERIC_READ | GENERIC_WRITE, SHARED, NULL, CREATE_ALWAYS,
                                    FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, NULL);
  if (handle == INVALID_HANDLE_VALUE) (void)failure();
  const int descriptor = to_descriptor(handle, _O_RDWR);
  return descriptor >= 0 ? _fdopen(descriptor, "w+b") : NULL;
}

int file_open_nowhere(bool to_write) {
  return _open("NUL", (to_write ? _O_WRONLY : _O_RDONLY) | _O_BINARY | _O_NOINHERIT);
}

int file_duplicate(int descriptor) { return _dup(descriptor); }

/* ---- names ---- */

char *file_absolute(const char *path) {
  wchar_t *const wide = wide_from_utf8(path);
  wchar_t *const whole = wide ? _wfullpath(NULL, wide, 0) : NULL;
  char *const absolute = whole ? wide_to_utf8(whole) : NULL;
  free(wide);
  free(whole);
  return absolute;
}

/* Replacing a name that is a symbolic link replaces the link. */
char *file_follow_links(const char *path) { return _strdup(path); }

typedef BOOL WINAPI TwoNames(const wchar_t *from, const wchar_t *to);

static bool with_names(TwoNames *call, const char *from, const char *to) {
  wchar_t *const wide_from = wide_from_utf8(from);
  wchar_t *const wide_to = wide_from ? wide_from_utf8(to) : NULL;
  const bool done = wide_to && (call(wide_from, wide_to) || failure());
  free(wide_from);
  free(wide_to);
  return done;
}

static BOOL WINAPI link_names(const wchar_t *from, const wchar_t *to) {
  return CreateHardLinkW(to, from, NULL);
}

static BOOL WINAPI move_names(const wchar_t *from, const wchar_t *to) {
  return MoveFileExW(from, to, MOVEFILE_REPLACE_EXISTING);
}

bool file_link(const char *from, const char *to) { return with_names(link_names, from, to); }

bool file_rename(const char *from, const char *to) { return with_names(move_names, from, to); }

bool file_remove(const char *path) {
  wchar_t *const wide = wide_from_utf8(path);
  const bool done = wide && (DeleteFileW(wide) || failure());
  free(wide);
  return done;
}

/* ---- folders and locks ---- */

bool folder_make(const char *path) {
  wchar_t *const wide = wide_from_utf8(path);
  const bool done = wide && (CreateDirectoryW(wide, NULL) || failure());
  free(wide);
  return done;
}

void folder_visit(const char *folder, void (*visit)(void *context, const char *name),
                  void *context) {
  WIN32_FIND_DATAW entry;
  const size_t size = strlen(folder) + sizeof "/*";
  char *const pattern = malloc(size);
  if (pattern) (void)snprintf(pattern, size, "%s/*", folder);
  wchar_t *const wide = pattern ? wide_from_utf8(pattern) : NULL;
  const HANDLE search = wide ? FindFirstFileW(wide, &entry) : INVALID_HANDLE_VALUE;
  for (BOOL more = search != INVALID_HANDLE_VALUE; more; more = FindNextFileW(search, &entry)) {
    char *const name = wide_to_utf8(entry.cFileName);
    if (name) visit(context, name);
    free(name);
  }
  if (search != INVALID_HANDLE_VALUE) (void)FindClose(search);
  free(wide);
  free(pattern);
}

/* Windows keeps others from reading what is locked: so it is a byte behind everything. */
bool file_lock(int descriptor) {
  OVERLAPPED place = {.Offset = 0xFFFFFFFE, .OffsetHigh = 0x7FFFFFFF};
  const HANDLE handle = (HANDLE)_get_osfhandle(descriptor);
  const DWORD flags = LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY;
  return LockFileEx(handle, flags, 0, 1, 0, &place) || GetLastError() != ERROR_LOCK_VIOLATION;
}
