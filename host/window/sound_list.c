/* SPDX-License-Identifier: MIT */
#include "window/sound_list.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kit/user_sounds.h"

static bool has_category(const ListView *list, const char *name) {
  for (uint32_t i = 0; i < list->count; i++)
    if (list->lines[i].is_category && strcmp(list->lines[i].name, name) == 0) return true;
  return false;
}

static void add_built_in(ListView *list, const InstrumentKind *kind, uint32_t number) {
  const TaborPresetInfo *const preset = kind->preset(number);
  ListLine *const line = list_view_add(list, preset->name, preset->comment);
  if (line) line->number = number;
}

/* In the order in which categories appear among the presets. */
static void add_categories(ListView *list, const InstrumentKind *kind) {
  const uint32_t count = kind->preset_count();
  for (uint32_t first = 0; first < count; first++) {
    const char *const category = kind->preset(first)->category;
    if (has_category(list, category)) continue;
    list_view_add_category(list, category);
    for (uint32_t i = first; i < count; i++)
      if (strcmp(kind->preset(i)->category, category) == 0) add_built_in(list, kind, i);
  }
}

static void add_file(void *context, const char *name, const UserSound *sound) {
  ListLine *const line = list_view_add(context, name, sound->comment);
  if (line) line->is_file = true;
}

static int compare_names(const void *a, const void *b) {
  const ListLine *const one = a, *const other = b;
  return strcmp(one->name, other->name);
}

/* A category without entries is none. */
static void end_category(ListView *list, uint32_t first) {
  if (list->count == first && first > 0) list->count--;
}

static void add_files(ListView *list, const InstrumentKind *kind) {
  list_view_add_category(list, "your own");
  const uint32_t first = list->count;
  user_sounds_visit(kind->id == INSTRUMENT_KIT, add_file, list);
  qsort(list->lines + first, list->count - first, sizeof *list->lines, compare_names);
  end_category(list, first);
}

static ListLine action(const ListLine *line, uint32_t number) {
  ListLine changed = *line;
  changed.number = number;
  changed.is_action = true;
  return changed;
}

static void add_files_lines(ListView *list) {
  ListLine *const save = list_view_add(list, "Save this sound...", "under a name of your own (W)");
  if (save) *save = action(save, SOUND_LIST_SAVE);
  ListLine *const open = list_view_add(list, "Open a file...", "by its path (O)");
  if (open) *open = action(open, SOUND_LIST_OPEN);
}

/* Before all others, where they appear as well. */
static void add_favourites(ListView *list, const Favourites *favourites, uint32_t all) {
  list_view_add_category(list, "favourites");
  const uint32_t first = list->count;
  for (uint32_t i = 0; i < all; i++) {
    ListLine *const line = &list->lines[i];
    if (line->is_category || !favourites_have(favourites, line->name)) continue;
    line->is_favourite = true;
    ListLine *const copy = list_view_add(list, line->name, line->text);
    if (copy) *copy = *line;
  }
  end_category(list, first);
}

static void put_in_front(ListView *list, uint32_t from) {
  const uint32_t moved = list->count - from;
  ListLine *const copy = malloc((moved + 1) * sizeof *copy);
  if (copy) {
    memcpy(copy, list->lines + from, moved * sizeof *copy);
    memmove(list->lines + moved, list->lines, from * sizeof *copy);
    memcpy(list->lines, copy, moved * sizeof *copy);
  }
  free(copy);
}

void sound_list_fill(ListView *list, const InstrumentKind *kind, const Favourites *favourites) {
  list_view_clear(list);
  list->has_stars = true;
  add_categories(list, kind);
  add_files(list, kind);
  const uint32_t all = list->count;
  add_files_lines(list);
  add_favourites(list, favourites, all);
  put_in_front(list, all);
}

bool sound_list_place(const ListLine *line, PresetPlace *place) {
  *place = (PresetPlace){.is_file = line->is_file, .number = line->number};
  (void)snprintf(place->name, sizeof place->name, "%s", line->name);
  return !line->is_file || user_preset_path(line->name, place->name);
}
