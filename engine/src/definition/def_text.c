/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* strnlen */
#include "definition/def_text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/decimal.h"

#define LONGEST_WORD 128 /* for the edit distance; longer ones are cut */

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

static const char *skip_digits(const char *text) {
  while (is_digit(*text)) text++;
  return text;
}

/* No blanks, "nan", "infinity" or hexadecimal, which strtod() would take. */
static bool is_decimal(const char *text) {
  const char *const start = text + (*text == '-' || *text == '+');
  const char *end = skip_digits(start);
  size_t digits = (size_t)(end - start);
  if (*end == '.') {
    const char *const fraction = end + 1;
    end = skip_digits(fraction);
    digits += (size_t)(end - fraction);
  }
  if (digits == 0) return false;
  if (*end == 'e' || *end == 'E') {
    const char *const exponent = end + 1 + (end[1] == '-' || end[1] == '+');
    end = skip_digits(exponent);
    if (end == exponent) return false;
  }
  return *end == '\0';
}

TbParse tb_number_parse(const char *text, double *value) {
  if (!is_decimal(text)) return TB_PARSE_INVALID;
  const double result = tb_decimal_read(text);
  if (isinf(result)) return TB_PARSE_OVERFLOW;
  *value = result;
  return TB_PARSE_OK;
}

TbParse tb_whole_parse(const char *text, uint32_t *value) {
  if (!is_digit(*text) || *skip_digits(text)) return TB_PARSE_INVALID;
  uint64_t sum = 0;
  for (; *text; text++) {
    sum = 10 * sum + (uint64_t)(*text - '0');
    if (sum > UINT32_MAX) return TB_PARSE_OVERFLOW;
  }
  *value = (uint32_t)sum;
  return TB_PARSE_OK;
}

/* Decimal digits of a finite number: value = 0.d1 d2 d3 ... times 10^point. */
typedef struct Decimal {
  bool negative;
  char digits[20];
  int count, point;
} Decimal;

/* @p precision digits. snprintf() may write any decimal point: only digits are taken from it. */
static Decimal to_decimal(double value, int precision) {
  char text[64];
  (void)snprintf(text, sizeof text, "%.*e", precision - 1, value);
  Decimal decimal = {.negative = signbit(value) != 0};
  const char *c = text;
  for (; *c != 'e'; c++) {
    if (is_digit(*c)) decimal.digits[decimal.count++] = *c;
  }
  decimal.point = (int)strtol(c + 1, NULL, 10) + 1;
  while (decimal.count > 1 && decimal.digits[decimal.count - 1] == '0') decimal.count--;
  return decimal;
}

/* "0.00012", "3000", "12.5" */
static char *write_plain(char *to, const Decimal *decimal) {
  int position = decimal->point < 1 ? decimal->point - 1 : 0;
  const int end = decimal->count > decimal->point ? decimal->count : decimal->point;
  for (; position < end; position++) {
    if (position == decimal->point) *to++ = '.';
    *to++ = position >= 0 && position < decimal->count ? decimal->digits[position] : '0';
  }
  return to;
}

/* "1.5e-7" */
static char *write_scientific(char *to, const Decimal *decimal) {
  *to++ = decimal->digits[0];
  if (decimal->count > 1) *to++ = '.';
  for (int i = 1; i < decimal->count; i++) *to++ = decimal->digits[i];
  return to + snprintf(to, 8, "e%d", (decimal->point - 1) % 1000);
}

static void write_decimal(char *to, const Decimal *decimal) {
  if (decimal->negative) *to++ = '-';
  const int zeros = decimal->point - decimal->count; /* that would have to fill up a whole number */
  const bool plain = decimal->point > -4 && decimal->point <= 16 && zeros <= 6;
  to = plain ? write_plain(to, decimal) : write_scientific(to, decimal);
  *to = '\0';
}

void tb_number_print(double value, char text[TB_NUMBER_SIZE]) {
  if (!isfinite(value)) {
    (void)snprintf(text, TB_NUMBER_SIZE, "%s", isnan(value) ? "nan" : value < 0 ? "-inf" : "inf");
    return;
  }
  for (int precision = 1; precision <= 17; precision++) { /* 17 digits tell all doubles apart */
    const Decimal decimal = to_decimal(value, precision);
    write_decimal(text, &decimal);
    double back;
    if (tb_number_parse(text, &back) == TB_PARSE_OK && memcmp(&back, &value, sizeof back) == 0)
      return;
  }
}

static bool is_continuation(unsigned char c) { return (c & 0xC0u) == 0x80u; }

size_t tb_text_step(const char *text) {
  const unsigned char *const c = (const unsigned char *)text;
  if (c[0] < 0x80) return c[0] >= 0x20 && c[0] != 0x7F ? 1 : 0;
  if (c[0] < 0xC2 || c[0] > 0xF4 || !is_continuation(c[1])) return 0;
  if (c[0] == 0xC2 && c[1] < 0xA0) return 0; /* C1 controls */
  if (c[0] < 0xE0) return 2;
  if (!is_continuation(c[2])) return 0;
  if (c[0] == 0xE0 && c[1] < 0xA0) return 0; /* overlong */
  if (c[0] == 0xED && c[1] > 0x9F) return 0; /* surrogates */
  if (c[0] < 0xF0) return 3;
  if (!is_continuation(c[3])) return 0;
  if (c[0] == 0xF0 && c[1] < 0x90) return 0; /* overlong */
  if (c[0] == 0xF4 && c[1] > 0x8F) return 0; /* above U+10FFFF */
  return 4;
}

static bool is_terminated(const char *text, size_t size) {
  return memchr(text, '\0', size) != NULL;
}

bool tb_text_is_valid(const char *text, size_t size) {
  if (!is_terminated(text, size)) return false;
  for (size_t step; *text; text += step) {
    step = tb_text_step(text);
    if (step == 0) return false;
  }
  return true;
}

static bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '-' || c == '_';
}

bool tb_name_is_valid(const char *text, size_t size) {
  if (!is_terminated(text, size) || !*text) return false;
  while (is_name_character(*text)) text++;
  return *text == '\0';
}

void tb_text_copy(char *to, size_t size, const char *from) {
  while (*from) {
    const size_t step = tb_text_step(from);
    const size_t bytes = step ? step : 1;
    if (bytes >= size) break;
    if (step) {
      memcpy(to, from, step);
    } else {
      *to = '?';
    }
    to += bytes;
    from += bytes;
    size -= bytes;
  }
  *to = '\0';
}

bool tb_begins(const char *text, const char *start) {
  return strncmp(text, start, strlen(start)) == 0;
}

static size_t smaller(size_t a, size_t b) { return a < b ? a : b; }

size_t tb_edit_distance(const char *a, const char *b) {
  const size_t rows = strnlen(a, LONGEST_WORD), columns = strnlen(b, LONGEST_WORD);
  size_t table[3][LONGEST_WORD + 1]; /* rows i - 2, i - 1 and i, in turn */
  for (size_t j = 0; j <= columns; j++) table[0][j] = j;
  for (size_t i = 1; i <= rows; i++) {
    size_t *const row = table[i % 3];
    const size_t *const last = table[(i - 1) % 3], *const before = table[(i + 1) % 3];
    row[0] = i;
    for (size_t j = 1; j <= columns; j++) {
      const size_t change = last[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = smaller(change, smaller(last[j], row[j - 1]) + 1);
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = smaller(row[j], before[j - 2] + 1);
    }
  }
  return table[rows % 3][columns];
}

static size_t word_distance(const char *word, const char *candidate) {
  const bool begins = *word && strncmp(word, candidate, strlen(word)) == 0;
  const size_t distance = tb_edit_distance(word, candidate);
  return begins && distance > 1 ? 1 : distance;
}

bool tb_word_is_nearer(const char *word, const char *candidate, size_t *smallest) {
  const size_t length = strnlen(word, LONGEST_WORD);
  const size_t distance = word_distance(word, candidate);
  const bool is_near = distance < (length < 3 ? length : length / 3 + 1);
  if (!is_near || distance >= *smallest) return false;
  *smallest = distance;
  return true;
}
