/* SPDX-License-Identifier: MIT */
/**
 * @file definition_text.h
 * Definitions of drums and kits as texts in memory: for files, logs and sessions.
 *
 * SET-UP: all functions.
 */
#ifndef TABOR_HOST_DEFINITION_TEXT_H
#define TABOR_HOST_DEFINITION_TEXT_H

#include <tabor/kit.h>

/**
 * Returns the text of tabor_drum_def_write(), which the caller frees; NULL with the reason in @p
 * error, which may be NULL. @p by says in a first line who wrote it, such as "'tabor show'";
 * without it, NULL, there is no such line.
 */
char *definition_write(const TaborDrumDef *def, TaborTextForm form, const char *by,
                       TaborError *error);
/** The same of a kit, by tabor_kit_def_write(). */
char *definition_write_kit(const TaborKitDef *def, TaborTextForm form, const char *by,
                           TaborError *error);
/**
 * Reads what a plugin saved: @p text of @p size bytes, with a terminator or without. Keys that this
 * version does not know are skipped; missing ones have their defaults. Any other error returns
 * false with the reason in @p error and leaves @p def unchanged. Before 0.2.0 plugins saved full
 * keys without sections.
 */
bool definition_read(const char *text, size_t size, TaborDrumDef *def, TaborError *error);

#endif
