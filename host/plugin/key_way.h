/* SPDX-License-Identifier: MIT */
/**
 * @file key_way.h
 * Where values of the engine's parameters stand on the way of a control, 0 to 1, as knob.h has it
 * for knobs.
 *
 * SET-UP: all functions.
 */
#ifndef TABOR_PLUGIN_KEY_WAY_H
#define TABOR_PLUGIN_KEY_WAY_H

#include <stddef.h>
#include <tabor/tabor.h>

/** Where a value, as the engine writes it, stands; negative: it has no place, as a text, or a pitch
 * that follows from the tension. */
double key_position(const TaborParameter *parameter, const char *value);
/** Writes the value at a place of one that has places: a number of four digits, a whole one, or a
 * word. */
void key_at_position(const TaborParameter *parameter, double position, char *value, size_t size);
/** Number of values of a choice or a whole number; 0 of other numbers. */
uint32_t key_choices(const TaborParameter *parameter);

#endif
