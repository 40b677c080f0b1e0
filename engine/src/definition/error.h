/* SPDX-License-Identifier: MIT */
/**
 * @file error.h
 * Filling in a TaborError. The message is formatted here rather than by vsnprintf(), whose decimal
 * point follows the locale and whose %s would let control characters of a user's text through.
 */
#ifndef TABOR_SRC_ERROR_H
#define TABOR_SRC_ERROR_H

#include "tabor/tabor.h"

#if defined(__GNUC__)
/* With C11's formats: gcc takes those of Windows for "printf" there. */
#  if defined(__MINGW32__) && !defined(__clang__)
#    define TB_PRINTF(text, first) __attribute__((format(gnu_printf, text, first)))
#  else
#    define TB_PRINTF(text, first) __attribute__((format(printf, text, first)))
#  endif
#else
#  define TB_PRINTF(text, first)
#endif

/**
 * Fills in @p error, if it is not NULL, and returns @p status, so that a check can end with
 * `return tb_error_set(...)`.
 *
 * @param key     the offending key, or NULL
 * @param value   its value as text, or NULL
 * @param minimum,maximum the allowed range; NaN where no range applies
 * @param format  printf-like, with the conversions %s %d %u %zu %c %g %% only and no flags, widths
 *                or precisions; %g writes the shortest text that reads back the same, always with a
 *                '.'
 *
 * Bytes that are not printable UTF-8 become '?'. A %s is cut to 96 bytes, between characters.
 */
TaborStatus tb_error_set(TaborError *error, TaborStatus status, const char *key, const char *value,
                         double minimum, double maximum, const char *format, ...) TB_PRINTF(7, 8);

/** Reports a NULL argument: "the WHAT is NULL". */
TaborStatus tb_error_null(TaborError *error, const char *what);

/** Says where in a text the error is, and returns @p status. */
TaborStatus tb_error_place(TaborError *error, TaborStatus status, uint32_t line, uint32_t column);

/** Adds @p text to the message as far as there is room, and returns @p status. */
TaborStatus tb_error_add(TaborError *error, TaborStatus status, const char *text);

/** Sets @p error, if it is not NULL, to TABOR_OK without key, value, range or message. */
TaborStatus tb_error_clear(TaborError *error);

#endif /* TABOR_SRC_ERROR_H */
