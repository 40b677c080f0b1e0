/* SPDX-License-Identifier: MIT */
/**
 * @file key_name.h
 * The parts of a definition's keys: "drum.snare.batter.surface_density" is the surface density of
 * the section "drum.snare.batter".
 *
 * SET-UP: all functions.
 */
#ifndef TABOR_PLUGIN_KEY_NAME_H
#define TABOR_PLUGIN_KEY_NAME_H

#include <stdbool.h>
#include <stddef.h>
#include <tabor/tabor.h>

/** Row of the engine's table that a key of a drum or a kit has, which for
 * "drum.snare.batter.tension" is the one of "batter.tension"; NULL: none. */
const TaborParameter *key_parameter(const char *key);
/** Bytes of the section, without its dot; 0: there is none. */
size_t key_section(const char *key);
bool key_is_same_section(const char *a, const char *b);
/** Writes the name within the section for people, "surface density". Returns the length as
 * snprintf() does. */
int key_title(const char *key, char *text, size_t size);

#endif
