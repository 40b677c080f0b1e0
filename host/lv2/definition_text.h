/* SPDX-License-Identifier: MIT */
/**
 * @file definition_text.h
 * A definition as text, in the states of the plugins: a line "key = value" for every key.
 *
 *     shell.radius = 0.1778
 *     mic.top.gain = 1
 *
 * SET-UP: all functions.
 */
#ifndef TABOR_LV2_DEFINITION_TEXT_H
#define TABOR_LV2_DEFINITION_TEXT_H

#include <tabor/tabor.h>

#define DEFINITION_TEXT_LIMIT 65536u /**< bytes, with the terminator */

/** The text, to be freed; NULL without memory. */
char *definition_write(const TaborDrumDef *def);
/**
 * Reads @p text of @p size bytes, which need not be terminated. Keys that are not known, of later versions, are
 * passed over; keys that are missing have their defaults. False, with the reason, if anything else is wrong:
 * then @p def is unchanged.
 */
bool definition_read(const char *text, size_t size, TaborDrumDef *def, TaborError *error);

#endif
