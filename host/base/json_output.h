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
/** Prints @p value with a line feed and releases it. Fails for NULL, the result of a failed allocation. */
Outcome json_print(json_t *value);

#endif
