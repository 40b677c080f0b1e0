/* SPDX-License-Identifier: MIT */
#include "window/painting.h"

#include <math.h>
#include <stddef.h>

static const Box BUTTONS[BUTTON_COUNT] = {
  [BUTTON_BEFORE] = {420, 20, 28, 28},   [BUTTON_NEXT] = {668, 20, 28, 28},
  [BUTTON_COMPARE] = {420, 396, 66, 26}, [BUTTON_UNDO] = {492, 396, 54, 26},
  [BUTTON_PAGE] = {552, 396, 72, 26},    [BUTTON_SOUNDS] = {450, 20, 216, 28}};
static const double TITLE_SIZE = 16, TITLE_GAP = 8;
static const double TITLE[2] = {550, 40}; /* its middle */
static const double MARK[2] = {650, 31}, MARK_SIZE = 9;
static const Box METER = {632, 396, 64, 10};
static const double METER_STEP = 16;
static const double LOWEST_LEVEL = -60; /* [dB] of a meter */

bool box_has(const Box *box, double x, double y) {
  return x >= box->x && x < box->x + box->width && y >= box->y && y < box->y + box->height;
}

double painting_scale(uint32_t width, uint32_t height) {
  return fmax(0.1, fmin((double)width / WINDOW_WIDTH, (double)height / WINDOW_HEIGHT));
}

/* ---- colours and texts ---------------------------------------------------------------------- */

void paper(cairo_t *cairo) { cairo_set_source_rgb(cairo, 0.13, 0.14, 0.16); }
void field(cairo_t *cairo) { cairo_set_source_rgb(cairo, 0.22, 0.24, 0.27); }
void ink(cairo_t *cairo) { cairo_set_source_rgb(cairo, 0.90, 0.91, 0.92); }
void pale(cairo_t *cairo) { cairo_set_source_rgb(cairo, 0.66, 0.69, 0.72); }
void accent(cairo_t *cairo) { cairo_set_source_rgb(cairo, 0.95, 0.62, 0.20); }

void paint_paper(cairo_t *cairo, double scale) {
  paper(cairo);
  cairo_paint(cairo);
  cairo_scale(cairo, scale, scale);
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, 13);
}

void paint_text(cairo_t *cairo, double x, double y, Align align, const char *text) {
  cairo_text_extents_t size;
  cairo_text_extents(cairo, text, &size);
  cairo_move_to(cairo, x - 0.5 * align * size.x_advance, y);
  cairo_show_text(cairo, text);
}

void paint_box(cairo_t *cairo, const Box *box) {
  cairo_rectangle(cairo, box->x, box->y, box->width, box->height);
  cairo_fill(cairo);
}

void paint_way(cairo_t *cairo, const Box *way, double position) {
  const Box done = {way->x, way->y, position * way->width, way->height};
  field(cairo);
  paint_box(cairo, way);
  accent(cairo);
  paint_box(cairo, &done);
}

/* ---- what all windows have ------------------------------------------------------------------ */

Button button_at(double x, double y) {
  int found = 0;
  while (found < BUTTON_COUNT && !box_has(&BUTTONS[found], x, y)) found++;
  return (Button)found;
}

void paint_button(cairo_t *cairo, Button button, const char *text, bool lit) {
  const Box *const box = &BUTTONS[button];
  field(cairo);
  paint_box(cairo, box);
  if (lit) {
    ink(cairo);
  } else {
    pale(cairo);
  }
  paint_text(cairo, box->x + 0.5 * box->width, box->y + 0.5 * box->height + 5, AT_MIDDLE, text);
}

static double level_of(double peak) {
  const double level = 20 * log10(fmax(peak, 1e-9));
  return fmin(fmax(1 - level / LOWEST_LEVEL, 0), 1);
}

static void paint_meter(cairo_t *cairo, uint32_t side, double peak) {
  Box meter = METER;
  meter.y += METER_STEP * side;
  field(cairo);
  paint_box(cairo, &meter);
  meter.width *= level_of(peak);
  if (peak > 1) {
    cairo_set_source_rgb(cairo, 0.90, 0.25, 0.20);
  } else {
    cairo_set_source_rgb(cairo, 0.35, 0.75, 0.45);
  }
  paint_box(cairo, &meter);
}

/* Smaller where it would reach the buttons beside it. */
static void paint_title(cairo_t *cairo, const char *title) {
  const double room = 2 * (TITLE[0] - BUTTONS[BUTTON_SOUNDS].x - TITLE_GAP);
  cairo_text_extents_t size;
  cairo_set_font_size(cairo, TITLE_SIZE);
  cairo_text_extents(cairo, title, &size);
  if (size.x_advance > room) cairo_set_font_size(cairo, TITLE_SIZE * room / size.x_advance);
  ink(cairo);
  paint_text(cairo, TITLE[0], TITLE[1], AT_MIDDLE, title);
}

/* A triangle: a list opens there. */
static void paint_mark(cairo_t *cairo) {
  pale(cairo);
  cairo_move_to(cairo, MARK[0], MARK[1]);
  cairo_rel_line_to(cairo, MARK_SIZE, 0);
  cairo_rel_line_to(cairo, -0.5 * MARK_SIZE, 0.7 * MARK_SIZE);
  cairo_fill(cairo);
}

void paint_frame(cairo_t *cairo, const char *title, bool is_second, bool can_undo,
                 const double peaks[2]) {
  paint_button(cairo, BUTTON_BEFORE, "<", true);
  paint_button(cairo, BUTTON_NEXT, ">", true);
  paint_button(cairo, BUTTON_SOUNDS, "", true);
  paint_button(cairo, BUTTON_COMPARE, is_second ? "A / [B]" : "[A] / B", true);
  paint_button(cairo, BUTTON_UNDO, "Undo", can_undo);
  for (uint32_t side = 0; side < 2; side++) paint_meter(cairo, side, peaks[side]);
  paint_title(cairo, title);
  paint_mark(cairo);
}
