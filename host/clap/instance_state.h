/* SPDX-License-Identifier: MIT */
/**
 * @file instance_state.h
 * The state of a CLAP plugin, as text:
 *
 *     tabor-state 1
 *     batter_tension 453b8000 453b8000
 *     ...
 *     definition
 *     shell.radius = 0.1778
 *     ...
 *
 * A knob has its symbol, its value and the value for which the definition is made: if they differ, the knob has been
 * turned since. Both are the bits of a single-precision number in hexadecimal digits, which no locale changes. Knobs of
 * later versions are skipped.
 */
#ifndef TABOR_CLAP_INSTANCE_STATE_H
#define TABOR_CLAP_INSTANCE_STATE_H

#include "clap/instance.h"

extern const clap_plugin_state_t instance_state;

#endif
