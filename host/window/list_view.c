/* SPDX-License-Identifier: MIT */
#include "window/list_view.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "window/painting.h"

/* Places, at scale 1. */
static const Box PLACE = {420, 60, 276, 324};
static const double LINE = 36, MARGIN = 8, NAME_DOWN = 15, TEXT_DOWN = 29, CATEGORY_DOWN = 25;
static const double STAR = 24, STAR_SIZE = 7; /* width of its place; half of its own */
enum { SEEN = 9, NOTCH = 3 };                 /* lines that fit; that a notch moves */

/* ---- lines ---------------------------------------------------------------------------------- */

void list_view_clear(ListView *list) {
  list->count = list->first = 0;
  list->cursor = LIST_NO_CURSOR;
  list->has_stars = false;
}

ListLine *list_view_add(ListView *list, const char *name, const char *text) {
  if (list->count == LIST_MOST) return NULL;
  ListLine *const line = &list->lines[list->count++];
  *line = (ListLine){.is_category = false};
  (void)snprintf(line->name, sizeof line->name, "%s", name);
  (void)snprintf(line->text, sizeof line->text, "%s", text);
  return line;
}

void list_view_add_category(ListView *list, const char *name) {
  ListLine *const line = list_view_add(list, name, "");
  if (line) line->is_category = true;
}

static bool is_entry(const ListView *list, uint32_t number, const char *name) {
  const ListLine *const line = &list->lines[number];
  return !line->is_category && strcmp(line->name, name) == 0;
}

/* count: there is none. */
static uint32_t find(const ListView *list, const char *name) {
  uint32_t found = 0;
  while (found < list->count && !is_entry(list, found, name)) found++;
  return found;
}

/* ---- what is seen --------------------------------------------------------------------------- */

static void show_from(ListView *list, int64_t first) {
  const int64_t last = list->count > SEEN ? (int64_t)list->count - SEEN : 0;
  const int64_t to = first > last ? last : first;
  list->first = to > 0 ? (uint32_t)to : 0;
}

void list_view_show(ListView *list, const char *name) {
  const uint32_t found = find(list, name);
  if (found < list->count) show_from(list, (int64_t)found - SEEN / 2);
}

void list_view_scroll(ListView *list, int steps) {
  show_from(list, (int64_t)list->first - (int64_t)steps * NOTCH);
}

/* The next entry on the way, or where it was. */
static uint32_t beside(const ListView *list, uint32_t from, int step) {
  int64_t to = from;
  do to += step;
  while (to >= 0 && to < list->count && list->lines[to].is_category);
  return to >= 0 && to < list->count ? (uint32_t)to : from;
}

void list_view_move(ListView *list, int steps, const char *name) {
  if (list->count == 0) return;
  if (list->cursor == LIST_NO_CURSOR) {
    const uint32_t found = find(list, name);
    list->cursor = found < list->count ? found : beside(list, 0, 1);
  }
  for (int i = 0; i < steps; i++) list->cursor = beside(list, list->cursor, 1);
  for (int i = 0; i > steps; i--) list->cursor = beside(list, list->cursor, -1);
  if (list->cursor < list->first || list->cursor >= list->first + SEEN)
    show_from(list, (int64_t)list->cursor - SEEN / 2);
}

const ListLine *list_view_chosen(const ListView *list) {
  return list->cursor < list->count ? &list->lines[list->cursor] : NULL;
}

/* ---- places --------------------------------------------------------------------------------- */

bool list_view_has(double x, double y) { return box_has(&PLACE, x, y); }

const ListLine *list_view_at(const ListView *list, double x, double y) {
  if (!list_view_has(x, y)) return NULL;
  const uint32_t line = list->first + (uint32_t)((y - PLACE.y) / LINE);
  return line < list->count && !list->lines[line].is_category ? &list->lines[line] : NULL;
}

bool list_view_is_star(const ListView *list, double x) {
  return list->has_stars && x >= PLACE.x + PLACE.width - STAR;
}

/* ---- how it looks --------------------------------------------------------------------------- */

static void draw_star(cairo_t *cairo, double y, bool is_full) {
  static const double PI = 3.14159265358979323846;
  cairo_new_path(cairo);
  for (int i = 0; i < 10; i++) {
    const double size = i % 2 == 0 ? STAR_SIZE : 0.42 * STAR_SIZE, angle = PI * (0.2 * i - 0.5);
    cairo_line_to(cairo, PLACE.x + PLACE.width - 0.5 * STAR + size * cos(angle),
                  y + 0.5 * LINE + size * sin(angle));
  }
  cairo_close_path(cairo);
  pale(cairo);
  if (is_full) accent(cairo);
  cairo_set_line_width(cairo, 1);
  if (is_full) cairo_fill_preserve(cairo);
  cairo_stroke(cairo);
}

static void draw_entry(const ListView *list, const ListLine *line, cairo_t *cairo, double y,
                       bool is_marked) {
  const double room = PLACE.width - 2 * MARGIN - (list->has_stars ? STAR - MARGIN : 0);
  const Box place = {PLACE.x, y, PLACE.width, LINE};
  if (is_marked) {
    field(cairo);
    paint_box(cairo, &place);
  }
  if (line == list_view_chosen(list)) paint_focus(cairo, &place);
  ink(cairo);
  if (is_marked) accent(cairo);
  paint_text_in(cairo, PLACE.x + MARGIN, y + NAME_DOWN, room, line->name);
  pale(cairo);
  cairo_set_font_size(cairo, SMALL_TEXT);
  paint_text_in(cairo, PLACE.x + MARGIN, y + TEXT_DOWN, room, line->text);
  cairo_set_font_size(cairo, USUAL_TEXT);
  if (list->has_stars && !line->is_action) draw_star(cairo, y, line->is_favourite);
}

static void draw_category(const ListLine *line, cairo_t *cairo, double y) {
  accent(cairo);
  cairo_set_font_size(cairo, SMALL_TEXT);
  paint_text(cairo, PLACE.x, y + CATEGORY_DOWN, AT_LEFT, line->name);
  cairo_set_font_size(cairo, USUAL_TEXT);
}

/* How far down the list it is. */
static void draw_scale(const ListView *list, cairo_t *cairo) {
  if (list->count <= SEEN) return;
  const double way = PLACE.height / list->count;
  pale(cairo);
  paint_box(cairo,
            &(Box){PLACE.x + PLACE.width + 4, PLACE.y + way * list->first, 3, fmax(way * SEEN, 4)});
}

void list_view_draw(const ListView *list, cairo_t *cairo, const char *marked) {
  for (uint32_t i = list->first; i < list->count && i < list->first + SEEN; i++) {
    const ListLine *const line = &list->lines[i];
    const double y = PLACE.y + LINE * (i - list->first);
    if (line->is_category) {
      draw_category(line, cairo, y);
    } else {
      draw_entry(list, line, cairo, y, strcmp(line->name, marked) == 0);
    }
  }
  draw_scale(list, cairo);
}
