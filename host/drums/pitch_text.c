/* SPDX-License-Identifier: MIT */
#include "drums/pitch_text.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tabor/tabor.h>

#define NOTE_SIZE 32
#define HIGHEST_NOTE 119 /* B9, in semitones above C0 */

static const double A4 = 440; /* [Hz], 57 semitones above C0 */

const char *const pitch_names[12] = {"C",  "C#", "D",  "Eb", "E",  "F",
                                     "F#", "G",  "Ab", "A",  "Bb", "B"};

int pitch_text(double frequency, char *text, size_t size) {
  const double above = floor(1200 * log2(frequency / A4) + 5700 + 0.5); /* cents above C0 */
  const double semitones = floor((above + 50) / 100);
  if (!(semitones >= 0 && semitones <= HIGHEST_NOTE)) {
    return snprintf(text, size, "%.6g Hz", frequency);
  }
  const int note = (int)semitones, cents = (int)(above - 100 * semitones);
  if (cents == 0) return snprintf(text, size, "%s%d", pitch_names[note % 12], note / 12);
  return snprintf(text, size, "%s%d %+d ct", pitch_names[note % 12], note / 12, cents);
}

/* Copies @p text without blanks and without @p unit at its end. */
static bool pack(const char *text, const char *unit, char packed[NOTE_SIZE]) {
  size_t length = 0;
  for (; *text; text++) {
    if (isspace((unsigned char)*text)) continue;
    if (length == NOTE_SIZE - 1) return false;
    packed[length++] = *text;
  }
  packed[length] = '\0';
  const size_t tail = strlen(unit);
  if (length > tail && strcmp(packed + length - tail, unit) == 0) packed[length - tail] = '\0';
  return true;
}

static bool read_hertz(const char *text, double *frequency) {
  char packed[NOTE_SIZE], *end = NULL;
  if (!pack(text, "Hz", packed)) return false;
  const double value = strtod(packed, &end);
  if (end == packed || *end || !isfinite(value)) return false;
  *frequency = value;
  return true;
}

/* The engine reads notes where it reads the pitch of a head. */
static bool read_note(const char *text, double *frequency) {
  char packed[NOTE_SIZE];
  TaborDrumDef def;
  if (!pack(text, "ct", packed) || !isalpha((unsigned char)packed[0])) return false;
  tabor_drum_def_clear(&def);
  if (tabor_drum_def_set(&def, "batter.pitch", packed, NULL) != TABOR_OK) return false;
  *frequency = def.batter.pitch;
  return true;
}

bool pitch_read(const char *text, double *frequency) {
  return read_hertz(text, frequency) || read_note(text, frequency);
}
