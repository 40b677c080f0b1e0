/* SPDX-License-Identifier: MIT */
/**
 * @file def_text.h
 * Numbers, names and UTF-8 as text, the same whatever the locale. Set-up code.
 */
#ifndef TABOR_SRC_TEXT_H
#define TABOR_SRC_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Longest text of tb_number_print() with its terminator: "-1.2345678901234567e-308". */
#define TB_NUMBER_SIZE 32

typedef enum TbParse {
  TB_PARSE_OK,
  TB_PARSE_INVALID, /**< not a number at all */
  TB_PARSE_OVERFLOW /**< a number too large for the type */
} TbParse;

/**
 * Reads a decimal number, "-12", ".5", "1e-3": all of @p text, no blanks, no hexadecimal, no "nan",
 * no "inf". Correctly rounded; what is too small becomes zero or a denormal.
 */
TbParse tb_number_parse(const char *text, double *value);

/** Reads digits only. */
TbParse tb_whole_parse(const char *text, uint32_t *value);

/** Writes the shortest text that tb_number_parse() reads back to the same bits; "nan", "inf",
 *  "-inf" for those that it would not read. */
void tb_number_print(double value, char text[TB_NUMBER_SIZE]);

/**
 * Bytes of the printable UTF-8 character at @p text, 0 at its end, before a control character (C0,
 * DEL, C1) or an invalid, overlong or surrogate sequence. Never reads past a terminator.
 */
size_t tb_text_step(const char *text);

/** True if @p text holds a terminator within @p size bytes, and printable UTF-8 only up to it. */
bool tb_text_is_valid(const char *text, size_t size);

/** True for 1 to @p size - 1 letters, digits, '-' and '_' with a terminator. */
bool tb_name_is_valid(const char *text, size_t size);

/** Copies with '?' for every byte that is not printable UTF-8, cut between characters to fit. */
void tb_text_copy(char *to, size_t size, const char *from);

/** Insertions, deletions, changes and exchanges of neighbours that turn @p a into @p b. */
size_t tb_edit_distance(const char *a, const char *b);

/** How far @p word is from meaning @p candidate: as above, but the start of a word is near it. */
size_t tb_word_distance(const char *word, const char *candidate);

/** True if what is @p distance from @p word may have been meant: a third of it differs at most. */
bool tb_word_is_near(const char *word, size_t distance);

#endif /* TABOR_SRC_TEXT_H */
