/* SPDX-License-Identifier: MIT */
#include "definition/note.h"
#include "definition/def_text.h"

#include <math.h>

#include "math/portable_math.h"

static const double LOG_2 = 0.69314718055994530942;

/* Semitones of a letter above C; -1 for other characters. */
static int letter_semitones(char letter) {
  switch (letter) {
  case 'C':
  case 'c': return 0;
  case 'D':
  case 'd': return 2;
  case 'E':
  case 'e': return 4;
  case 'F':
  case 'f': return 5;
  case 'G':
  case 'g': return 7;
  case 'A':
  case 'a': return 9;
  case 'B':
  case 'b': return 11;
  default: return -1;
  }
}

/* "", "+30" or "-12.5" */
static bool parse_cents(const char *text, double *cents) {
  *cents = 0;
  if (!*text) return true;
  if (*text != '+' && *text != '-') return false;
  return tb_number_parse(text, cents) == TB_PARSE_OK && fabs(*cents) <= 100;
}

bool tb_note_parse(const char *text, double *frequency) {
  int semitones = letter_semitones(*text);
  if (semitones < 0) return false;
  text++;
  if (*text == '#' || *text == 'b') semitones += *text++ == '#' ? 1 : -1;
  if (*text < '0' || *text > '9') return false;
  const int octave = *text++ - '0';
  double cents;
  if (!parse_cents(text, &cents)) return false;
  const double above_a =
    (semitones - 9) / 12.0 + cents / 1200; /* octaves above the A of this octave */
  *frequency = 27.5 * (double)(1u << octave) * tb_exp(LOG_2 * above_a);
  return true;
}
