/* SPDX-License-Identifier: MIT */
/**
 * @file definition_text.h
 * A drum definition as text, as the plugins save it: one line "key = value" per key.
 *
 *     shell.radius = 0.1778
 *     mic.top.gain = 1
 *
 * SET-UP: all functions.
 */
#ifndef TABOR_PLUGIN_DEFINITION_TEXT_H
#define TABOR_PLUGIN_DEFINITION_TEXT_H

#include <tabor/tabor.h>

#define DEFINITION_TEXT_LIMIT 65536u /**< bytes, with the terminator */

/** Returns the text, which the caller frees; NULL if memory is short. */
char *definition_write(const TaborDrumDef *def);
/**
 * Reads @p text of @p size bytes, which need not be terminated. Unknown keys, from later versions, are
 * skipped; missing keys have their defaults. Any other error returns false with the reason in @p error
 * and leaves @p def unchanged.
 */
bool definition_read(const char *text, size_t size, TaborDrumDef *def, TaborError *error);

#endif
