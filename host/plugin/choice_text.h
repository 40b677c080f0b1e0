/* SPDX-License-Identifier: MIT */
/**
 * @file choice_text.h
 * Words of a knob's choices, which are separated by '|', for the values 0, 1, ...
 */
#ifndef TABOR_PLUGIN_CHOICE_TEXT_H
#define TABOR_PLUGIN_CHOICE_TEXT_H

#include <stdbool.h>
#include <stdint.h>

/** Number of words. */
uint32_t choice_count(const char *choices);
/** Writes word @p number of @p choices, "" past the last; returns its length. */
int choice_text(const char *choices, int number, char *text, uint32_t size);
/** Finds the value of the word @p text, in capitals or not; false if it is none. */
bool choice_find(const char *choices, const char *text, double *value);

#endif
