/* SPDX-License-Identifier: MIT */
/**
 * @file text_write.h
 * Writes texts of sections and keys, which tabor_text_read() reads. Set-up code.
 */
#ifndef TABOR_SRC_TEXT_WRITE_H
#define TABOR_SRC_TEXT_WRITE_H

#include "tabor/tabor.h"

/** A text that is written. */
typedef struct TbTextWriter {
  char *text;  /**< NULL: its length alone is counted */
  size_t size; /**< bytes of it */
  size_t length;
  TaborStatus status;
  TaborError *error; /**< may be NULL */
} TbTextWriter;

/** Begins an empty text. Errors: @p text NULL although @p size is not 0; @p form none of
 * TaborTextForm. */
TbTextWriter tb_text_write_begin(char *text, size_t size, uint32_t form, TaborError *error);
/** Begins a section, with an empty line before it unless it is the first; @p section has @p length
 * bytes. */
void tb_text_write_section(TbTextWriter *writer, const char *section, size_t length);
/**
 * Writes "key = value" for the full key @p full, of which @p key is the part behind the section,
 * with "; [unit] what" behind it, or above it where the line would be too long; @p unit and @p what
 * may be
 * "" or NULL. A value that would read back otherwise is an error.
 */
void tb_text_write_pair(TbTextWriter *writer, const char *full, const char *key, const char *value,
                        const char *unit, const char *what);
/** Ends it: the length to *length unless that is NULL. On an error the text is "". */
TaborStatus tb_text_write_end(TbTextWriter *writer, size_t *length);

#endif /* TABOR_SRC_TEXT_WRITE_H */
