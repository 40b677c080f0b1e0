/* SPDX-License-Identifier: MIT */
#include "window/preset_steps.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/drum_file.h"
#include "kit/kit_file.h"
#include "platform/files.h"

/* ---- files ---------------------------------------------------------------------------------- */

/* A look through the user's folder. */
typedef struct Folder {
  char path[USER_PRESET_PATH];
  bool is_kit;
  TaborKitDef *kit; /* room */
  TaborDrumDef drum;
  void (*visit)(void *context, const char *name, const char *comment);
  void *context;
} Folder;

/* The comment of a file of the sort, or NULL. */
static const char *comment_of(Folder *folder, const char *path) {
  char message[2 * TABOR_TEXT_SIZE];
  if (kit_file_read(path, folder->kit, message, sizeof message) == PRESET_FILE_OK)
    return folder->is_kit ? folder->kit->comment : NULL;
  if (folder->is_kit) return NULL;
  return drum_file_read(path, &folder->drum, message, sizeof message) == PRESET_FILE_OK
           ? folder->drum.comment
           : NULL;
}

static void visit_file(void *context, const char *file) {
  Folder *const folder = context;
  char name[TABOR_NAME_SIZE], path[2 * USER_PRESET_PATH];
  const char *const end = strstr(file, ".ini");
  const size_t length = end ? (size_t)(end - file) : 0;
  if (length == 0 || end[4] != '\0' || length >= sizeof name) return;
  memcpy(name, file, length);
  name[length] = '\0';
  const int size = snprintf(path, sizeof path, "%s/%s", folder->path, file);
  if (size < 0 || (size_t)size >= sizeof path) return;
  const char *const comment = comment_of(folder, path);
  if (comment) folder->visit(folder->context, name, comment);
}

void preset_files_visit(const InstrumentKind *kind,
                        void (*visit)(void *context, const char *name, const char *comment),
                        void *context) {
  Folder *const folder = malloc(sizeof *folder);
  TaborKitDef *const kit = malloc(sizeof *kit);
  if (folder && kit && user_folder(folder->path)) {
    folder->is_kit = kind->id == INSTRUMENT_KIT;
    folder->kit = kit;
    folder->visit = visit;
    folder->context = context;
    folder_visit(folder->path, visit_file, folder);
  }
  free(kit);
  free(folder);
}

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

static void consider(void *context, const char *name, const char *comment) {
  Search *const search = context;
  (void)comment;
  if (search->beside && !is_behind(search, name, search->beside)) return;
  if (*search->best && !is_behind(search, search->best, name)) return;
  (void)snprintf(search->best, sizeof search->best, "%s", name);
}

/* False: there is none. */
static bool find_file(PresetSteps *taken, const InstrumentKind *kind, const char *beside, int steps,
                      PresetPlace *place) {
  Search search = {.beside = beside, .steps = steps};
  preset_files_visit(kind, consider, &search);
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
