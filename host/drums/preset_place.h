/* SPDX-License-Identifier: MIT */
/**
 * @file preset_place.h
 * The built-in presets by their names.
 */
#ifndef TABOR_HOST_PRESET_PLACE_H
#define TABOR_HOST_PRESET_PLACE_H

/** Index of the built-in preset @p name for tabor_preset(); -1 if there is none, as for a file. */
int preset_place(const char *name);

#endif
