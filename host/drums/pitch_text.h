/* SPDX-License-Identifier: MIT */
/**
 * @file pitch_text.h
 * Pitches as musicians write them: a note and cents, "A3 +12 ct". A4 = 440 Hz, equal temperament,
 * C4 is middle C.
 *
 * SET-UP: all functions.
 */
#ifndef TABOR_DRUMS_PITCH_TEXT_H
#define TABOR_DRUMS_PITCH_TEXT_H

#include <stdbool.h>
#include <stddef.h>

/** Names of notes, from C on, as they are written everywhere. */
extern const char *const pitch_names[12];

/**
 * Writes the note nearest to @p frequency [Hz] and the whole cents to it, -50 to 49, which are left
 * out where they are 0: "A3 +12 ct", "F#2". Below C0 and above B9 it is "9.5 Hz". Returns the
 * length as snprintf() does.
 */
int pitch_text(double frequency, char *text, size_t size);
/**
 * Reads such a text, and also "A3+12", "Bb2 -5", "220 Hz" and "220". Notes have the frequencies
 * that tabor_drum_def_set() gives them. False, with @p frequency unchanged, if @p text is something
 * else.
 */
bool pitch_read(const char *text, double *frequency);

#endif
