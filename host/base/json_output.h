/* SPDX-License-Identifier: MIT */
/**
 * @file json_output.h
 * JSON on the standard output.
 */
#ifndef TABOR_HOST_JSON_OUTPUT_H
#define TABOR_HOST_JSON_OUTPUT_H

#include <jansson.h>

#include "base/message.h"

/** A number; null if it is not finite. */
json_t *json_number(double number);
/** A text; bytes that are not UTF-8, as file names may have, become question marks. */
json_t *json_text(const char *text);
/** Prints @p value with a line feed and gives it back; NULL, left by failed allocations, fails. */
Outcome json_print(json_t *value);

#endif
