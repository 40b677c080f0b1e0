/* SPDX-License-Identifier: MIT */
/**
 * @file kit_values.h
 * Values of a kit that move while it plays (TaborKitParameter), by their keys.
 */
#ifndef TABOR_HOST_KIT_VALUES_H
#define TABOR_HOST_KIT_VALUES_H

#include <tabor/kit.h>

#include "base/message.h"

#define KIT_VALUES 3            /**< one for each TaborKitParameter */
#define KIT_VALUE_NONE (-120.0) /**< [dB]: nothing at all */

/** Keys by TaborKitParameter: "kit.overheads", ...; NULL past the last. */
extern const char *const kit_value_keys[KIT_VALUES + 1];

/** The TaborKitParameter of a key; -1: it is another key. */
int kit_value_find(const char *key);
/** Reads a value [dB], or "off". */
Outcome kit_value_read(int value, const char *text, double *number);
/** Puts a value into a definition; that of sounds has no place there. */
void kit_value_define(TaborKitDef *def, int value, double number);

#endif
