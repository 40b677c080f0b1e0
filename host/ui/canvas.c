/* SPDX-License-Identifier: MIT */
#include "ui/canvas.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/keys.h"

#define WORTH_A_MOVE                                                                               \
  6 /* columns: to move the cursor over fewer takes more bytes than to write them */

/* ---- drawing ---- */

void canvas_begin(Canvas *canvas, int columns, int rows) {
  if (columns > CANVAS_COLUMNS) columns = CANVAS_COLUMNS;
  if (rows > CANVAS_ROWS) rows = CANVAS_ROWS;
  if (columns != canvas->columns || rows != canvas->rows) canvas->is_unknown = true;
  canvas->columns = columns;
  canvas->rows = rows;
  for (int row = 0; row < rows; row++) {
    for (int column = 0; column < columns; column++) canvas->drawn[row][column] = (Cell){' ', 0};
  }
}

/* Alphabets, punctuation, arrows, lines and blocks of one column; no combining ones. */
static bool is_narrow(uint32_t point) {
  static const uint32_t ranges[][2] = {{0x20, 0x7e},     {0xa1, 0xac},     {0xae, 0x2ff},
                                       {0x370, 0x482},   {0x48a, 0x52f},   {0x2010, 0x2027},
                                       {0x2030, 0x205e}, {0x20a0, 0x20bf}, {0x2190, 0x21ff},
                                       {0x2200, 0x22ff}, {0x2500, 0x25ff}};
  for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
    if (point >= ranges[i][0] && point <= ranges[i][1]) return true;
  }
  return false;
}

void canvas_put(Canvas *canvas, int row, int column, Style style, uint32_t point) {
  if (row < 0 || row >= canvas->rows || column < 0 || column >= canvas->columns) return;
  const bool can_show = is_narrow(point) && (canvas->utf8 || point < 0x80);
  canvas->drawn[row][column] = (Cell){can_show ? point : '?', (uint8_t)style};
}

int canvas_text(Canvas *canvas, int row, int column, Style style, const char *text) {
  while (*text) {
    uint32_t point = 0;
    const size_t length = utf8_read(text, &point);
    canvas_put(canvas, row, column++, style, length > 0 ? point : '?');
    text += length > 0 ? length : 1;
  }
  return column;
}

int canvas_print(Canvas *canvas, int row, int column, Style style, const char *format, ...) {
  char text[CANVAS_COLUMNS];
  va_list arguments;
  va_start(arguments, format);
  (void)vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return canvas_text(canvas, row, column, style, text);
}

void canvas_bar(Canvas *canvas, int row, int column, int width, double share, Style style) {
  const int parts = canvas->utf8 ? 8 : 1; /* of a column: blocks of eighths */
  const int full = (int)lround(fmin(fmax(share, 0), 1) * width * parts);
  for (int i = 0; i < width; i++) {
    const int part = full - i * parts;
    if (part <= 0) continue;
    const uint32_t eighths = part >= parts ? 8 : (uint32_t)part;
    canvas_put(canvas, row, column + i, style, canvas->utf8 ? 0x2590 - eighths : '#');
  }
}

/* ---- showing ---- */

/* An update being written. */
typedef struct Update {
  const Canvas *canvas;
  char *bytes;
  size_t count;
  int row, column; /* of the cursor; -1: not known */
  int style;       /* of what is written; -1: not known */
} Update;

static void add(Update *update, const char *text) {
  const size_t length = strlen(text);
  memcpy(update->bytes + update->count, text, length);
  update->count += length;
}

static void add_style(Update *update, Style style) {
  static const char *const with_colour[] = {"\033[0m",    "\033[0;1m", "\033[0;2m",   "\033[0;32m",
                                            "\033[0;31m", "\033[0;7m", "\033[0;31;7m"};
  static const char *const without[] = {"\033[0m",   "\033[0;1m", "\033[0;2m",  "\033[0m",
                                        "\033[0;1m", "\033[0;7m", "\033[0;1;7m"};
  if (update->style == (int)style) return;
  add(update, (update->canvas->colour ? with_colour : without)[style]);
  update->style = (int)style;
}

static void add_cell(Update *update, const Cell *cell) {
  add_style(update, (Style)cell->style);
  update->count += utf8_write(cell->point, update->bytes + update->count);
  update->column++;
}

static void move_to(Update *update, int row, int column) {
  const int gap = column - update->column;
  if (row == update->row && gap >= 0 && gap < WORTH_A_MOVE) {
    while (update->column < column) add_cell(update, &update->canvas->drawn[row][update->column]);
    return;
  }
  char text[32];
  (void)snprintf(text, sizeof text, "\033[%d;%dH", row + 1, column + 1);
  add(update, text);
  update->row = row;
  update->column = column;
}

static bool same_cell(const Cell *a, const Cell *b) {
  return a->point == b->point && a->style == b->style;
}

static void add_row(Update *update, int row) {
  const Canvas *const canvas = update->canvas;
  for (int column = 0; column < canvas->columns; column++) {
    const Cell *const cell = &canvas->drawn[row][column];
    if (!canvas->is_unknown && same_cell(cell, &canvas->shown[row][column])) continue;
    move_to(update, row, column);
    add_cell(update, cell);
  }
  update->row = -1; /* terminals differ in where the cursor is behind the last column */
}

size_t canvas_update(Canvas *canvas, char *bytes) {
  Update update = {.canvas = canvas, .bytes = bytes, .row = -1, .column = -1, .style = -1};
  if (canvas->is_unknown) add(&update, "\033[0m\033[2J");
  for (int row = 0; row < canvas->rows; row++) add_row(&update, row);
  if (update.style > 0) add(&update, "\033[0m");
  memcpy(canvas->shown, canvas->drawn, sizeof canvas->shown);
  canvas->is_unknown = false;
  return update.count;
}

void canvas_forget(Canvas *canvas) { canvas->is_unknown = true; }
