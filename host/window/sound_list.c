/* SPDX-License-Identifier: MIT */
#include "window/sound_list.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "window/painting.h"

/* Places, at scale 1. */
static const Box PLACE = {420, 60, 276, 324};
static const double LINE = 36, MARGIN = 8, NAME_DOWN = 15, TEXT_DOWN = 29, CATEGORY_DOWN = 25;
static const double NAME_SIZE = 13, TEXT_SIZE = 10.5;
enum { SEEN = 9, NOTCH = 3 }; /* lines that fit; that a notch moves */

/* ---- what there is -------------------------------------------------------------------------- */

static SoundLine *add_line(SoundList *list, const char *name, const char *text) {
  if (list->count == SOUND_LIST_MOST) return NULL;
  SoundLine *const line = &list->lines[list->count++];
  *line = (SoundLine){.is_category = false};
  (void)snprintf(line->name, sizeof line->name, "%s", name);
  (void)snprintf(line->text, sizeof line->text, "%s", text);
  return line;
}

static void add_category(SoundList *list, const char *name) {
  SoundLine *const line = add_line(list, name, "");
  if (line) line->is_category = true;
}

static bool has_category(const SoundList *list, const char *name) {
  for (uint32_t i = 0; i < list->count; i++)
    if (list->lines[i].is_category && strcmp(list->lines[i].name, name) == 0) return true;
  return false;
}

static void add_built_in(SoundList *list, const InstrumentKind *kind, uint32_t number) {
  const TaborPresetInfo *const preset = kind->preset(number);
  SoundLine *const line = add_line(list, preset->name, preset->comment);
  if (!line) return;
  line->place.number = number;
  (void)snprintf(line->place.name, sizeof line->place.name, "%s", preset->name);
}

/* In the order in which categories appear among the presets. */
static void add_categories(SoundList *list, const InstrumentKind *kind) {
  const uint32_t count = kind->preset_count();
  for (uint32_t first = 0; first < count; first++) {
    const char *const category = kind->preset(first)->category;
    if (has_category(list, category)) continue;
    add_category(list, category);
    for (uint32_t i = first; i < count; i++)
      if (strcmp(kind->preset(i)->category, category) == 0) add_built_in(list, kind, i);
  }
}

static void add_file(void *context, const char *name, const char *comment) {
  SoundList *const list = context;
  SoundLine *const line = add_line(list, name, comment);
  if (!line) return;
  line->place.is_file = true;
  if (!user_preset_path(name, line->place.name)) list->count--;
}

static int compare_names(const void *a, const void *b) {
  const SoundLine *const one = a, *const other = b;
  return strcmp(one->name, other->name);
}

static void add_files(SoundList *list, const InstrumentKind *kind) {
  add_category(list, "your own");
  const uint32_t first = list->count;
  preset_files_visit(kind, add_file, list);
  qsort(list->lines + first, list->count - first, sizeof *list->lines, compare_names);
  if (list->count == first && first > 0) list->count--; /* a category of nothing */
}

void sound_list_fill(SoundList *list, const InstrumentKind *kind, const char *title) {
  list->count = list->first = 0;
  add_categories(list, kind);
  add_files(list, kind);
  for (uint32_t i = 0; i < list->count; i++)
    if (!list->lines[i].is_category && strcmp(list->lines[i].name, title) == 0)
      list->first = i < SEEN / 2 ? 0 : i - SEEN / 2;
  sound_list_scroll(list, 0);
}

void sound_list_scroll(SoundList *list, int steps) {
  const int64_t last = list->count > SEEN ? (int64_t)list->count - SEEN : 0;
  int64_t to = (int64_t)list->first - (int64_t)steps * NOTCH;
  if (to > last) to = last;
  list->first = to > 0 ? (uint32_t)to : 0;
}

/* ---- how it looks --------------------------------------------------------------------------- */

bool sound_list_has(double x, double y) { return box_has(&PLACE, x, y); }

const SoundLine *sound_list_at(const SoundList *list, double x, double y) {
  if (!sound_list_has(x, y)) return NULL;
  const uint32_t line = list->first + (uint32_t)((y - PLACE.y) / LINE);
  return line < list->count && !list->lines[line].is_category ? &list->lines[line] : NULL;
}

static void draw_sound(const SoundLine *line, cairo_t *cairo, double y, bool plays) {
  if (plays) {
    field(cairo);
    paint_box(cairo, &(Box){PLACE.x, y, PLACE.width, LINE});
  }
  ink(cairo);
  if (plays) accent(cairo);
  cairo_set_font_size(cairo, NAME_SIZE);
  paint_text(cairo, PLACE.x + MARGIN, y + NAME_DOWN, AT_LEFT, line->name);
  pale(cairo);
  cairo_set_font_size(cairo, TEXT_SIZE);
  paint_text(cairo, PLACE.x + MARGIN, y + TEXT_DOWN, AT_LEFT, line->text);
}

/* How far down the list it is. */
static void draw_scale(const SoundList *list, cairo_t *cairo) {
  if (list->count <= SEEN) return;
  const double way = PLACE.height / list->count;
  pale(cairo);
  paint_box(cairo, &(Box){PLACE.x + PLACE.width + 4, PLACE.y + way * list->first, 3, way * SEEN});
}

void sound_list_draw(const SoundList *list, cairo_t *cairo, const char *title) {
  cairo_save(cairo);
  cairo_rectangle(cairo, PLACE.x, PLACE.y, PLACE.width, PLACE.height);
  cairo_clip(cairo);
  for (uint32_t i = list->first; i < list->count && i < list->first + SEEN; i++) {
    const SoundLine *const line = &list->lines[i];
    const double y = PLACE.y + LINE * (i - list->first);
    if (line->is_category) {
      accent(cairo);
      cairo_set_font_size(cairo, TEXT_SIZE);
      paint_text(cairo, PLACE.x, y + CATEGORY_DOWN, AT_LEFT, line->name);
    } else {
      draw_sound(line, cairo, y, strcmp(line->name, title) == 0);
    }
  }
  cairo_restore(cairo);
  draw_scale(list, cairo);
  cairo_set_font_size(cairo, NAME_SIZE);
}
