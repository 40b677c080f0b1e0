/* SPDX-License-Identifier: MIT */
/**
 * @file favourites.h
 * The sounds that a user likes best, by their names: the lines of the file `favourites` in the
 * user's folder (drums/user_presets.h), which all windows share. MAIN: all functions.
 */
#ifndef TABOR_WINDOW_FAVOURITES_H
#define TABOR_WINDOW_FAVOURITES_H

#include <stdbool.h>
#include <stdint.h>
#include <tabor/tabor.h>

#define FAVOURITES_MOST 128 /**< names; further ones are forgotten */

typedef struct Favourites {
  uint32_t count;
  char names[FAVOURITES_MOST][TABOR_NAME_SIZE];
} Favourites;

/** Reads the file; without one there are none. */
void favourites_read(Favourites *favourites);
bool favourites_have(const Favourites *favourites, const char *name);
/** Adds a name, or takes it away, and writes the file. False if it cannot be written. */
bool favourites_change(Favourites *favourites, const char *name);

#endif
