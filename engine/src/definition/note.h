/* SPDX-License-Identifier: MIT */
/**
 * @file note.h
 * Notes as frequencies.
 */
#ifndef TABOR_SRC_NOTE_H
#define TABOR_SRC_NOTE_H

#include <stdbool.h>

/**
 * Reads a note such as "A3", "F#3" or "Eb2+30": a letter A to G of either case, '#' or 'b' if it is
 * raised or lowered, its octave 0 to 9 (C4 is middle C), and cents from -100 to 100 with their
 * sign. Equal temperament, A4 = 440 Hz. False, with @p frequency unchanged, if @p text is something
 * else. The same bits on every machine.
 */
bool tb_note_parse(const char *text, double *frequency);

#endif /* TABOR_SRC_NOTE_H */
