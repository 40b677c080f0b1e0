/* SPDX-License-Identifier: MIT */
/**
 * @file state.h
 * The state of a CLAP plugin, as text:
 *
 *     tabor-state 1                            tabor-kit-state 1
 *                                              name standard
 *     batter_tension 453b8000 453b8000         quality 3f800000
 *     ...                                      ...
 *     definition                               kit-file
 *     shell.radius = 0.1778                    [kit]
 *     ...                                      ...
 *
 * A knob has its symbol, its value and, if the drum is noted with it, the value for which the
 * definition is made: if they differ, the knob has been turned since. Both are the bits of a
 * single-precision number in hexadecimal digits, which no locale changes. A built-in kit has its
 * name, since a later version may change its number; the text of a kit is that of the user's own
 * one, if there is one. Knobs of later versions are skipped.
 */
#ifndef TABOR_CLAP_STATE_H
#define TABOR_CLAP_STATE_H

#include <clap/clap.h>

extern const clap_plugin_state_t state_extension;
/** A state that is loaded as a preset leaves the player's own knobs (Knob.is_of_player). */
extern const clap_plugin_state_context_t state_context_extension;

#endif
