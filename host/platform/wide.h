/* SPDX-License-Identifier: MIT */
/**
 * @file wide.h
 * Windows only: text for its wide functions.
 */
#ifndef TABOR_HOST_WIDE_H
#define TABOR_HOST_WIDE_H

#include <wchar.h>

/** UTF-16 of UTF-8. The caller frees it; NULL with errno if memory is short or @p text is not
 * UTF-8. */
wchar_t *wide_from_utf8(const char *text);
/** UTF-8 of UTF-16, likewise. */
char *wide_to_utf8(const wchar_t *text);
/** Sets errno from GetLastError(). Returns false. */
int wide_set_errno(void);

#endif
