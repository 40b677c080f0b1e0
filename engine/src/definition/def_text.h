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

/** Size of the longest text of tb_number_print(), "-1.2345678901234567e-308", with its
 * terminator. */
#define TB_NUMBER_SIZE 32

typedef enum TbParse {
  TB_PARSE_OK,
  TB_PARSE_INVALID, /**< not a number at all */
  TB_PARSE_OVERFLOW /**< a number too large for the type */
} TbParse;

/**
 * Reads a decimal number such as "-12", ".5" or "1e-3". All of @p text must be the number: no
 * blanks, no hexadecimal, no "nan", no "inf". The result is correctly rounded; too small a number
 * becomes zero or a denormal.
 */
TbParse tb_number_parse(const char *text, double *value);

/** Reads a whole number that consists of digits only. */
TbParse tb_whole_parse(const char *text, uint32_t *value);

/** Writes the shortest text that tb_number_parse() reads back to the same bits. Values that
 * tb_number_parse() does not read become "nan", "inf" or "-inf". */
void tb_number_print(double value, char text[TB_NUMBER_SIZE]);

/**
 * Number of bytes of the printable UTF-8 character at @p text. 0 at the terminator, before a
 * control character (C0, DEL, C1), and before an invalid, overlong or surrogate sequence. Never
 * reads past a terminator.
 */
size_t tb_text_step(const char *text);

/** True if @p text has a terminator within @p size bytes, and only printable UTF-8 before it. */
bool tb_text_is_valid(const char *text, size_t size);

/** True for 1 to @p size - 1 letters, digits, '-' and '_' with a terminator. */
bool tb_name_is_valid(const char *text, size_t size);

/** Copies @p from, with '?' for every byte that is not printable UTF-8. A text that is too long is
 * cut between characters. */
void tb_text_copy(char *to, size_t size, const char *from);

/** True if @p text begins with @p start. */
bool tb_begins(const char *text, const char *start);

/** Number of insertions, deletions, changes and exchanges of neighbours that turn @p a into
 * @p b. */
size_t tb_edit_distance(const char *a, const char *b);

/** One step of the search for the candidate that may have been meant by @p word. True if at most a
 * third of the word differs from @p candidate, and it is nearer than *smallest, which becomes its
 * distance; start with SIZE_MAX. The distance is tb_edit_distance(), except that the start of a
 * word counts as near to the word. */
bool tb_word_is_nearer(const char *word, const char *candidate, size_t *smallest);

#endif /* TABOR_SRC_TEXT_H */
