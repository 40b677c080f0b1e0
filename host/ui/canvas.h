/* SPDX-License-Identifier: MIT */
/**
 * @file canvas.h
 * A character screen. Each frame is drawn in full, but only changed cells are sent to the terminal.
 *
 * Cells are one column wide. Wide or combining characters are shown as '?', and without UTF-8 all
 * non-ASCII characters are. Styles work on light and dark backgrounds: they change weight and
 * colour of the text, and the background only by reversing.
 */
#ifndef TABOR_HOST_CANVAS_H
#define TABOR_HOST_CANVAS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CANVAS_COLUMNS 240 /**< most columns drawn; the rest of a larger terminal stays empty */
#define CANVAS_ROWS 60
#define CANVAS_BYTES (CANVAS_COLUMNS * CANVAS_ROWS * 32) /**< largest size of an update */

typedef enum Style {
  STYLE_PLAIN,
  STYLE_STRONG,
  STYLE_FAINT,
  STYLE_GOOD,    /**< green */
  STYLE_BAD,     /**< red */
  STYLE_REVERSE, /**< a cursor, a title */
  STYLE_ALARM    /**< red, reversed: a lit warning */
} Style;

typedef struct Cell {
  uint32_t point; /**< code point */
  uint8_t style;  /**< a Style */
} Cell;

typedef struct Canvas {
  int columns, rows;
  bool utf8, colour; /**< abilities of the terminal */
  bool is_unknown;   /**< the terminal's contents are unknown */
  Cell drawn[CANVAS_ROWS][CANVAS_COLUMNS], shown[CANVAS_ROWS][CANVAS_COLUMNS];
} Canvas;

/** Starts an empty picture of this size. Before the first call, the canvas is {0} but for utf8 and
 * colour. */
void canvas_begin(Canvas *canvas, int columns, int rows);
/** Writes UTF-8 from this cell on, as far as there is room; returns the column after the text. */
int canvas_text(Canvas *canvas, int row, int column, Style style, const char *text);
/** Formats like printf(), up to CANVAS_COLUMNS bytes, and writes like canvas_text(). */
#ifdef __GNUC__
__attribute__((format(printf, 5, 6)))
#endif
int canvas_print(Canvas *canvas, int row, int column, Style style, const char *format, ...);
/** Draws a bar of @p width columns, filled to @p share, 0 to 1; finer than a column with UTF-8. */
void canvas_bar(Canvas *canvas, int row, int column, int width, double share, Style style);
/** Draws one character. */
void canvas_put(Canvas *canvas, int row, int column, Style style, uint32_t point);

/** Writes the bytes that update the terminal to @p bytes, of size CANVAS_BYTES; returns their
 * number. */
size_t canvas_update(Canvas *canvas, char *bytes);
/** Marks the contents of the terminal as unknown: the next update redraws everything. */
void canvas_forget(Canvas *canvas);

#endif
