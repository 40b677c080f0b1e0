/* SPDX-License-Identifier: MIT */
#include "window/preset_steps.h"

#include <stdio.h>
#include <string.h>

#include "kit/user_sounds.h"

/* ---- files ---------------------------------------------------------------------------------- */

/* A search for the file whose name stands next to another one. */
typedef struct Search {
  const char *beside; /* a name without extension; NULL: from the end of the list */
  int steps;
  char best[TABOR_NAME_SIZE];
} Search;

/* True if `a` comes later than `b` on the way. */
static bool is_behind(const Search *search, const char *a, const char *b) {
  return search->steps > 0 ? strcmp(a, b) > 0 : strcmp(a, b) < 0;
}

static void consider(void *context, const char *name, const UserSound *sound) {
  Search *const search = context;
  (void)sound;
  if (search->beside && !is_behind(search, name, search->beside)) return;
  if (*search->best && !is_behind(search, search->best, name)) return;
  (void)snprintf(search->best, sizeof search->best, "%s", name);
}

/* False: there is none. */
static bool find_file(PresetSteps *taken, const InstrumentKind *kind, const char *beside, int steps,
                      PresetPlace *place) {
  Search search = {.beside = beside, .steps = steps};
  user_sounds_visit(kind->id == INSTRUMENT_KIT, consider, &search);
  memcpy(taken->file, search.best, sizeof taken->file);
  place->is_file = true;
  return *search.best && user_preset_path(search.best, place->name);
}

/* The file that plays, in `file`; "" if it is none that is known. */
static void file_of(const PresetSteps *taken, const char *title, char file[TABOR_NAME_SIZE]) {
  char room[USER_PRESET_PATH];
  const bool is_taken = *taken->file && strcmp(title, taken->title) == 0;
  (void)snprintf(file, TABOR_NAME_SIZE, "%s", is_taken ? taken->file : title);
  if (!user_preset_find(file, room)) *file = '\0';
}

/* ---- all ------------------------------------------------------------------------------------ */

static PresetPlace built_in(const InstrumentKind *kind, uint32_t number) {
  PresetPlace place = {.number = number};
  (void)snprintf(place.name, sizeof place.name, "%s", kind->preset(number)->name);
  return place;
}

PresetPlace preset_steps_take(PresetSteps *taken, const InstrumentKind *kind, const char *title,
                              int steps) {
  const uint32_t count = kind->preset_count();
  char file[TABOR_NAME_SIZE];
  PresetPlace place;
  uint32_t at = 0;
  while (at < count && strcmp(kind->preset(at)->name, title) != 0) at++;
  file_of(taken, title, file);
  const bool is_file = *file && (at == count || strcmp(title, taken->title) == 0);
  const bool is_known = at < count || is_file;
  *taken->file = '\0';
  if (!is_file && steps < 0 && at > 0 && at < count) return built_in(kind, at - 1);
  if (!is_file && steps > 0 && at + 1 < count) return built_in(kind, at + 1);
  if (is_known && find_file(taken, kind, is_file ? file : NULL, steps, &place)) return place;
  return built_in(kind, steps > 0 ? 0 : count - 1);
}

void preset_steps_note(PresetSteps *taken, const char *title) {
  (void)snprintf(taken->title, sizeof taken->title, "%s", title);
}

void preset_steps_choose(PresetSteps *taken, const char *file) {
  (void)snprintf(taken->file, sizeof taken->file, "%s", file);
}
