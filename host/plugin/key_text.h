/* SPDX-License-Identifier: MIT */
/**
 * @file key_text.h
 * Values of the engine's parameters as players read and type them: lengths below 1 m in
 * millimetres, masses below 1 kg in grams, pitches as notes, or "by tension" where that leads, the
 * rest with the unit of the table.
 *
 * SET-UP: all functions.
 */
#ifndef TABOR_PLUGIN_KEY_TEXT_H
#define TABOR_PLUGIN_KEY_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <tabor/tabor.h>

/** Writes @p value, as the engine writes it, for players: "0.1778" of a radius is "177.8 mm".
 * Returns the length as snprintf() does. */
int key_text(const TaborParameter *parameter, const char *value, char *text, size_t size);
/**
 * Reads such a text into what the engine reads. A number without a unit has the unit in which @p
 * value, the present one, is shown; mm, cm, m, in (inches of 25.4 mm), g and kg convert. False if a
 * number has another unit than the parameter can have; what is no number is left to the engine.
 */
bool key_text_read(const TaborParameter *parameter, const char *value, const char *typed,
                   char *text, size_t size);

#endif
