/* SPDX-License-Identifier: MIT */
/**
 * @file canvas_row.h
 * A row of a character screen as text.
 */
#ifndef TABOR_TESTS_CANVAS_ROW_H
#define TABOR_TESTS_CANVAS_ROW_H

#include "base/keys.h"
#include "ui/canvas.h"

/** The row as it is drawn, in UTF-8, until the next call. */
static inline const char *canvas_row(const Canvas *canvas, int row) {
  static char text[4 * CANVAS_COLUMNS + 1];
  size_t length = 0;
  for (int column = 0; column < canvas->columns; column++)
    length += utf8_write(canvas->drawn[row][column].point, text + length);
  text[length] = '\0';
  return text;
}

#endif
