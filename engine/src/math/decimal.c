/* SPDX-License-Identifier: MIT */
#include "math/decimal.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

enum {
  DIGITS = 780, /* a number half-way between two doubles has no more than 767 */
  FAR = 400,    /* decimal places beyond which all is zero or infinite */
  WORDS = 128   /* 10^(DIGITS + FAR), and 64 bits more */
};

/* 0.d1 d2 d3 .. 10^point */
typedef struct Digits {
  uint32_t count;
  int32_t point;
  bool negative;
  char digit[DIGITS + 1];
} Digits;

/* A whole number, the lowest word first; words above `count` are zero. */
typedef struct Whole {
  uint32_t count;
  uint32_t word[WORDS];
} Whole;

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

/* Counted as far as it matters. */
static int32_t step(int32_t point, int32_t by) {
  const int32_t next = point + by;
  return next > 100000000 ? 100000000 : (next < -100000000 ? -100000000 : next);
}

/* Leading zeros only move the point. Digits beyond those kept are as good as a last 1, if they are
 * not zero. */
static void add_digit(Digits *d, char c, bool fraction) {
  const char digit = (char)(c - '0');
  if (d->count == 0 && digit == 0) {
    if (fraction) d->point = step(d->point, -1);
    return;
  }
  if (!fraction) d->point = step(d->point, 1);
  if (d->count < DIGITS) {
    d->digit[d->count++] = digit;
  } else if (digit != 0) {
    d->digit[DIGITS] = 1;
    d->count = DIGITS + 1;
  }
}

static int32_t read_exponent(const char *text) {
  const bool negative = *text == '-';
  int32_t exponent = 0;
  for (text += negative || *text == '+'; is_digit(*text); text++) {
    if (exponent < 100000000) exponent = 10 * exponent + (*text - '0');
  }
  return negative ? -exponent : exponent;
}

static void read_digits(const char *text, Digits *d) {
  *d = (Digits){.negative = *text == '-'};
  bool fraction = false;
  for (text += *text == '-' || *text == '+'; is_digit(*text) || *text == '.'; text++) {
    if (*text == '.') {
      fraction = true;
    } else {
      add_digit(d, *text, fraction);
    }
  }
  if (*text) d->point += read_exponent(text + 1);
}

/* ---- few digits ------------------------------------------------------------------------------ */

static bool read_few(const Digits *d, double *value) {
  static const double tens[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const int32_t exponent = d->point - (int32_t)d->count;
  if (d->count > 15 || exponent < -22 || exponent > 22) return false;
  uint64_t whole = 0;
  for (uint32_t i = 0; i < d->count; i++) whole = 10 * whole + (uint64_t)d->digit[i];
  *value = exponent < 0 ? (double)whole / tens[-exponent] : (double)whole * tens[exponent];
  return true;
}

/* ---- whole numbers --------------------------------------------------------------------------- */

/* n = n factor + carry */
static void multiply_add(Whole *n, uint32_t factor, uint32_t carry) {
  uint64_t rest = carry;
  for (uint32_t i = 0; i < n->count; i++) {
    rest += (uint64_t)n->word[i] * factor;
    n->word[i] = (uint32_t)rest;
    rest >>= 32;
  }
  if (rest) n->word[n->count++] = (uint32_t)rest;
}

static uint32_t bits_of(const Whole *n) {
  uint32_t bits = 32 * (n->count - 1);
  for (uint32_t top = n->word[n->count - 1]; top; top >>= 1) bits++;
  return bits;
}

static void shift_up(Whole *n, uint32_t bits) {
  const uint32_t words = bits / 32, rest = bits % 32;
  memmove(n->word + words, n->word, n->count * sizeof *n->word);
  memset(n->word, 0, words * sizeof *n->word);
  n->count += words;
  if (rest) multiply_add(n, (uint32_t)1 << rest, 0);
}

static bool is_less(const Whole *a, const Whole *b) {
  for (uint32_t i = a->count > b->count ? a->count : b->count; i-- > 0;) {
    if (a->word[i] != b->word[i]) return a->word[i] < b->word[i];
  }
  return false;
}

/* a -= b, a >= b */
static void subtract(Whole *a, const Whole *b) {
  uint64_t borrow = 0;
  for (uint32_t i = 0; i < a->count; i++) {
    const uint64_t difference = (uint64_t)a->word[i] - b->word[i] - borrow;
    a->word[i] = (uint32_t)difference;
    borrow = difference >> 63;
  }
}

static bool is_zero(const Whole *n) {
  for (uint32_t i = 0; i < n->count; i++) {
    if (n->word[i]) return false;
  }
  return true;
}

/* ---- the quotient ---------------------------------------------------------------------------- */

/* above / below = (quotient + something less than 1) 2^exponent; `left`: that is not 0. */
typedef struct Quotient {
  uint64_t bits; /* 63 or 64 */
  int32_t exponent;
  bool left;
} Quotient;

/* Both are changed. */
static Quotient divide(Whole *above, Whole *below) {
  const uint32_t of_above = bits_of(above), of_below = bits_of(below);
  if (of_above < of_below) shift_up(above, of_below - of_above);
  if (of_below < of_above) shift_up(below, of_above - of_below);
  Quotient q = {.exponent = (int32_t)of_above - (int32_t)of_below - 63};
  for (int bit = 63; bit >= 0; bit--) {
    if (!is_less(above, below)) {
      subtract(above, below);
      q.bits |= (uint64_t)1 << bit;
    }
    multiply_add(above, 2, 0);
  }
  q.left = !is_zero(above);
  return q;
}

/* To 53 bits, or as many as a number has that small. */
static double round_quotient(Quotient q) {
  const int32_t bits = q.bits >> 63 ? 64 : 63;
  const int32_t top = q.exponent + bits - 1; /* 2^top <= value < 2^(top + 1) */
  const int32_t kept = top < -1022 ? 53 + 1022 + top : 53, dropped = bits - kept;
  if (dropped > 64) return 0.0;
  const uint64_t half = (uint64_t)1 << (dropped - 1);
  const uint64_t rest = q.bits & (half | (half - 1));
  uint64_t mantissa = dropped == 64 ? 0 : q.bits >> dropped;
  if (rest > half || (rest == half && (q.left || (mantissa & 1)))) mantissa++;
  return ldexp((double)mantissa, q.exponent + dropped);
}

static double read_many(const Digits *d) {
  Whole above = {.count = 1}, below = {.count = 1, .word = {1}};
  for (uint32_t i = 0; i < d->count; i++) multiply_add(&above, 10, (uint32_t)d->digit[i]);
  int32_t exponent = d->point - (int32_t)d->count;
  for (; exponent > 0; exponent--) multiply_add(&above, 10, 0);
  for (; exponent < 0; exponent++) multiply_add(&below, 10, 0);
  return round_quotient(divide(&above, &below));
}

double tb_decimal_read(const char *text) {
  Digits d;
  double value = 0.0;
  read_digits(text, &d);
  if (d.count > 0 && d.point > FAR) {
    value = INFINITY;
  } else if (d.count > 0 && d.point > -FAR && !read_few(&d, &value)) {
    value = read_many(&d);
  }
  return d.negative ? -value : value;
}
