/* SPDX-License-Identifier: MIT */
/**
 * @file json_output.h
 * JSON on standard output.
 */
#ifndef TABOR_HOST_JSON_OUTPUT_H
#define TABOR_HOST_JSON_OUTPUT_H

#include <jansson.h>

#include "base/message.h"

/** Makes a number; null if it is not finite. */
json_t *json_number(double number);
/** Makes a text; bytes that are not UTF-8, possible in file names, become question marks. */
json_t *json_text(const char *text);
/** Puts @p value, which it takes over, into @p list or @p object, which it returns. Where memory is
 * missing for either or for the value (any of them may be NULL) it releases all of them and returns
 * NULL, so that json_print() fails and nothing is printed that lacks a part. */
json_t *json_with_item(json_t *list, json_t *value);
json_t *json_with_field(json_t *object, const char *key, json_t *value);
/** The text of an object or a list, which the caller frees; NULL if memory is missing or @p value
 * is NULL. */
char *json_write(const json_t *value);
/** The same on one line, which ends in a line feed, and with 17 digits, which give every number
 * back to the bit. */
char *json_write_line(const json_t *value);
/** Prints @p value with a line feed and releases it. Fails for NULL, the result of a failed
 * allocation. */
Outcome json_print(json_t *value);

#endif
