/* SPDX-License-Identifier: MIT */
/**
 * @file canvas.h
 * A screen of characters that is drawn in full every time and shown by what has changed.
 *
 * Cells are one column wide: characters that may be wider, or join others, are shown as '?', and so is
 * everything but ASCII where the terminal has no UTF-8. Styles work on light and on dark ground: they
 * change weight and colour of the letters, never the ground's colour but by reversing.
 */
#ifndef TABOR_HOST_CANVAS_H
#define TABOR_HOST_CANVAS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CANVAS_COLUMNS 240 /**< most that are drawn; a larger terminal stays empty there */
#define CANVAS_ROWS 60
#define CANVAS_BYTES (CANVAS_COLUMNS * CANVAS_ROWS * 32) /**< of an update at most */

typedef enum Style {
  STYLE_PLAIN,
  STYLE_STRONG,
  STYLE_FAINT,
  STYLE_GOOD,    /**< green */
  STYLE_BAD,     /**< red */
  STYLE_REVERSE, /**< a cursor, a title */
  STYLE_ALARM    /**< red, reversed: a light that is on */
} Style;

typedef struct Cell {
  uint32_t point; /**< code point */
  uint8_t style;  /**< a Style */
} Cell;

typedef struct Canvas {
  int columns, rows;
  bool utf8, colour; /**< what the terminal has */
  bool is_unknown;   /**< what it shows now */
  Cell drawn[CANVAS_ROWS][CANVAS_COLUMNS], shown[CANVAS_ROWS][CANVAS_COLUMNS];
} Canvas;

/** Begins a picture of this size, empty. The first time the canvas is {0} but for utf8 and colour. */
void canvas_begin(Canvas *canvas, int columns, int rows);
/** Writes UTF-8 from there on, as far as there is room; returns the column behind it. */
int canvas_text(Canvas *canvas, int row, int column, Style style, const char *text);
/** The same as printf() does it; up to CANVAS_COLUMNS bytes. */
#ifdef __GNUC__
__attribute__((format(printf, 5, 6)))
#endif
int canvas_print(Canvas *canvas, int row, int column, Style style, const char *format, ...);
/** A bar of @p width columns, of which @p share, 0 to 1, is full; finer than a column with UTF-8. */
void canvas_bar(Canvas *canvas, int row, int column, int width, double share, Style style);
/** Puts one character there. */
void canvas_put(Canvas *canvas, int row, int column, Style style, uint32_t point);

/** Writes what a terminal needs to show the picture to @p bytes, CANVAS_BYTES; returns how many there are. */
size_t canvas_update(Canvas *canvas, char *bytes);
/** What the terminal shows is not known any more: the next update is all of it. */
void canvas_forget(Canvas *canvas);

#endif
