/* SPDX-License-Identifier: MIT */
#include "window/painting.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#ifdef _WIN32
#  define FACE "Segoe UI"
#else
#  define FACE "sans-serif"
#endif

static const Box BUTTONS[BUTTON_COUNT] = {
  [BUTTON_BEFORE] = {420, 20, 28, 28},   [BUTTON_NEXT] = {668, 20, 28, 28},
  [BUTTON_COMPARE] = {420, 396, 60, 26}, [BUTTON_UNDO] = {484, 396, 28, 26},
  [BUTTON_REDO] = {516, 396, 28, 26},    [BUTTON_PAGE] = {548, 396, 88, 26},
  [BUTTON_SOUNDS] = {450, 20, 216, 28}};
static const double TITLE_SIZE = 16, TITLE_GAP = 8;
static const double TITLE[2] = {550, 40};         /* its middle */
static const double MARK_SIZE = 9, MARK_EDGE = 7; /* of a triangle, from a button's right end */
static const double PI = 3.14159265358979323846;
static const Box METER = {640, 396, 56, 10};
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
void alarm(cairo_t *cairo) { cairo_set_source_rgb(cairo, 1.00, 0.55, 0.50); }

void paint_paper(cairo_t *cairo, double scale) {
  paper(cairo);
  cairo_paint(cairo);
  cairo_scale(cairo, scale, scale);
  cairo_select_font_face(cairo, FACE, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, USUAL_TEXT);
}

void paint_text(cairo_t *cairo, double x, double y, Align align, const char *text) {
  cairo_text_extents_t size;
  cairo_text_extents(cairo, text, &size);
  cairo_move_to(cairo, x - 0.5 * align * size.x_advance, y);
  cairo_show_text(cairo, text);
}

static bool fits(cairo_t *cairo, const char *text, double room) {
  cairo_text_extents_t size;
  cairo_text_extents(cairo, text, &size);
  return size.x_advance <= room;
}

static bool is_inside_letter(char byte) { return ((unsigned char)byte & 0xC0u) == 0x80u; }

void paint_text_in(cairo_t *cairo, double x, double y, double room, const char *text) {
  char cut[512];
  size_t length = strlen(text);
  (void)snprintf(cut, sizeof cut, "%s", text);
  while (length > 0 && !fits(cairo, cut, room)) {
    do length--;
    while (length > 0 && is_inside_letter(text[length]));
    (void)snprintf(cut, sizeof cut, "%.*s...", (int)length, text);
  }
  paint_text(cairo, x, y, AT_LEFT, cut);
}

/* Takes as many words of @p text as fit, at least one; returns what is left. */
static const char *take_line(cairo_t *cairo, const char *text, double room, char *line,
                             size_t size) {
  size_t taken = strcspn(text, " ");
  for (size_t end = taken; text[taken]; taken = end) {
    end = taken + 1 + strcspn(text + taken + 1, " ");
    (void)snprintf(line, size, "%.*s", (int)end, text);
    if (!fits(cairo, line, room)) break;
  }
  (void)snprintf(line, size, "%.*s", (int)taken, text);
  return text + taken + (text[taken] == ' ');
}

void paint_lines(cairo_t *cairo, double x, double y, double room, uint32_t most, const char *text) {
  char line[512];
  for (uint32_t i = 0; i < most && *text; i++) {
    text = take_line(cairo, text, room, line, sizeof line);
    paint_text(cairo, x, y + (SMALL_TEXT + 3) * i, AT_MIDDLE, line);
  }
}

void paint_box(cairo_t *cairo, const Box *box) {
  cairo_rectangle(cairo, box->x, box->y, box->width, box->height);
  cairo_fill(cairo);
}

void paint_focus(cairo_t *cairo, const Box *box) {
  accent(cairo);
  cairo_set_line_width(cairo, 1.5);
  cairo_rectangle(cairo, box->x, box->y, box->width, box->height);
  cairo_stroke(cairo);
}

void paint_switch(cairo_t *cairo, const Box *box, const char *letter, bool is_lit) {
  field(cairo);
  if (is_lit) accent(cairo);
  paint_box(cairo, box);
  ink(cairo);
  if (is_lit) paper(cairo);
  cairo_set_font_size(cairo, SMALL_TEXT);
  paint_text(cairo, box->x + 0.5 * box->width, box->y + 0.5 * box->height + 4, AT_MIDDLE, letter);
  cairo_set_font_size(cairo, USUAL_TEXT);
}

void paint_way(cairo_t *cairo, const Box *way, double position, bool is_lit) {
  const Box done = {way->x, way->y, position * way->width, way->height};
  field(cairo);
  paint_box(cairo, way);
  pale(cairo);
  if (is_lit) accent(cairo);
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
static void paint_mark(cairo_t *cairo, Button button) {
  const Box *const box = &BUTTONS[button];
  pale(cairo);
  cairo_move_to(cairo, box->x + box->width - MARK_EDGE - MARK_SIZE, box->y + 0.5 * box->height - 3);
  cairo_rel_line_to(cairo, MARK_SIZE, 0);
  cairo_rel_line_to(cairo, -0.5 * MARK_SIZE, 0.7 * MARK_SIZE);
  cairo_fill(cairo);
}

/* An arrow that turns back, to the left, or forward again. */
static void paint_turn(cairo_t *cairo, Button button, bool is_back, bool is_lit) {
  const Box *const box = &BUTTONS[button];
  paint_button(cairo, button, "", is_lit);
  cairo_save(cairo);
  cairo_translate(cairo, box->x + 0.5 * box->width, box->y + 0.5 * box->height + 2);
  cairo_scale(cairo, is_back ? 1 : -1, 1);
  pale(cairo);
  if (is_lit) ink(cairo);
  cairo_new_path(cairo);
  cairo_arc(cairo, 0, 0, 6, PI, 0.35 * PI);
  cairo_set_line_width(cairo, 2);
  cairo_stroke(cairo);
  cairo_move_to(cairo, -10.5, -1);
  cairo_line_to(cairo, -1.5, -1);
  cairo_line_to(cairo, -6, 5);
  cairo_fill(cairo);
  cairo_restore(cairo);
}

/* The page's name, smaller where it would reach the mark. */
static void paint_page(cairo_t *cairo, const char *page) {
  const Box *const box = &BUTTONS[BUTTON_PAGE];
  paint_button(cairo, BUTTON_PAGE, "", true);
  ink(cairo);
  if (!fits(cairo, page, box->width - 24)) cairo_set_font_size(cairo, SMALL_TEXT);
  paint_text_in(cairo, box->x + 6, box->y + 18, box->width - 24, page);
  cairo_set_font_size(cairo, USUAL_TEXT);
  paint_mark(cairo, BUTTON_PAGE);
}

void paint_frame(cairo_t *cairo, const Frame *frame) {
  paint_button(cairo, BUTTON_BEFORE, "<", true);
  paint_button(cairo, BUTTON_NEXT, ">", true);
  paint_button(cairo, BUTTON_SOUNDS, "", true);
  paint_button(cairo, BUTTON_COMPARE, frame->is_second ? "A / [B]" : "[A] / B", true);
  paint_turn(cairo, BUTTON_UNDO, true, frame->can_undo);
  paint_turn(cairo, BUTTON_REDO, false, frame->can_redo);
  paint_page(cairo, frame->page);
  for (uint32_t side = 0; side < 2; side++) paint_meter(cairo, side, frame->peaks[side]);
  paint_title(cairo, frame->title);
  paint_mark(cairo, BUTTON_SOUNDS);
  cairo_set_font_size(cairo, USUAL_TEXT);
}
