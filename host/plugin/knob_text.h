/* SPDX-License-Identifier: MIT */
/**
 * @file knob_text.h
 * Values of knobs as words and numbers that players use, by the knob's scale (KnobScale): "A3 +12
 * ct", "30 %", "Open",
 * "-3 dB". Knobs with choices have no such texts.
 *
 * SET-UP: all functions.
 */
#ifndef TABOR_PLUGIN_KNOB_TEXT_H
#define TABOR_PLUGIN_KNOB_TEXT_H

#include "plugin/knob.h"

/** Writes @p value, limited to @p range, of @p knob to @p text. Returns the length as snprintf()
 * does. */
int knob_text(const Knob *knob, const KnobRange *range, double value, char *text, size_t size);
/** The same, or the word of a knob with choices. */
int knob_label(const Knob *knob, const KnobRange *range, double value, char *text, size_t size);
/**
 * Reads such a text. Words may be in capitals or not, a unit may be missing, and the value is
 * limited to @p range. False, with @p value unchanged, if @p text is something else.
 */
bool knob_text_read(const Knob *knob, const KnobRange *range, const char *text, double *value);

#endif
