/* SPDX-License-Identifier: MIT */
/**
 * @file turtle.h
 * Writes files in Turtle, one at a time. Any failure ends the program.
 */
#ifndef TABOR_LV2_TURTLE_H
#define TABOR_LV2_TURTLE_H

/** Ends the program with a message. */
__attribute__((noreturn)) void turtle_fail(const char *what);
void turtle_open(const char *folder, const char *name);
void turtle_close(void);

/** Writes to the open file, as printf() does. */
__attribute__((format(printf, 1, 2))) void put(const char *format, ...);
/** A text in quotation marks. */
void put_text(const char *text);
/** As a decimal number: an exponent would make it one of another type. */
void put_number(double value);
/** All prefixes that descriptions of plugins and presets use. */
void put_prefixes(void);

#endif
