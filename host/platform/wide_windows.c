/* SPDX-License-Identifier: MIT */
#include <errno.h>
#include <stdlib.h>
#include <windows.h>

#include "platform/wide.h"

wchar_t *wide_from_utf8(const char *text) {
  const int count = MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, text, -1, NULL, 0);
  wchar_t *const wide = count > 0 ? malloc((size_t)count * sizeof *wide) : NULL;
  errno = count > 0 ? ENOMEM : EILSEQ;
  if (wide) (void)MultiByteToWideChar(CP_UTF8, 0, text, -1, wide, count);
  return wide;
}

char *wide_to_utf8(const wchar_t *text) {
  const int count = WideCharToMultiByte(CP_UTF8, 0, text, -1, NULL, 0, NULL, NULL);
  char *const narrow = count > 0 ? malloc((size_t)count) : NULL;
  errno = count > 0 ? ENOMEM : EILSEQ;
  if (narrow) (void)WideCharToMultiByte(CP_UTF8, 0, text, -1, narrow, count, NULL, NULL);
  return narrow;
}

static int errno_of(DWORD error) {
  switch (error) {
  case ERROR_FILE_NOT_FOUND:
  case ERROR_PATH_NOT_FOUND:
  case ERROR_INVALID_NAME:
  case ERROR_BAD_NETPATH:
  case ERROR_BAD_PATHNAME:
  case ERROR_INVALID_DRIVE: return ENOENT;
  case ERROR_FILE_EXISTS:
  case ERROR_ALREADY_EXISTS: return EEXIST;
  case ERROR_ACCESS_DENIED:
  case ERROR_SHARING_VIOLATION:
  case ERROR_LOCK_VIOLATION:
  case ERROR_WRITE_PROTECT: return EACCES;
  case ERROR_FILENAME_EXCED_RANGE: return ENAMETOOLONG;
  case ERROR_DISK_FULL:
  case ERROR_HANDLE_DISK_FULL: return ENOSPC;
  case ERROR_NOT_ENOUGH_MEMORY:
  case ERROR_OUTOFMEMORY: return ENOMEM;
  case ERROR_TOO_MANY_OPEN_FILES: return EMFILE;
  case ERROR_INVALID_HANDLE: return EBADF;
  default: return EIO;
  }
}

int wide_set_errno(void) {
  errno = errno_of(GetLastError());
  return 0;
}
