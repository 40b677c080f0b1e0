/* SPDX-License-Identifier: MIT */
/**
 * @file presets_command.c
 * `tabor presets`: lists the presets, or kits: the built-in ones and those of the user's folder.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/command.h"
#include "base/json_output.h"
#include "drums/user_presets.h"
#include "kit/user_sounds.h"

#include <tabor/kit.h>

/* Presets, or kits. */
typedef struct List {
  const char *key;
  uint32_t (*count)(void);
  const TaborPresetInfo *(*at)(uint32_t index);
} List;

static const List presets = {"presets", tabor_preset_count, tabor_preset};
static const List kits = {"kits", tabor_kit_count, tabor_kit};

/* A line, of a built-in one or a file of the user's. */
typedef struct Row {
  char name[TABOR_NAME_SIZE], category[TABOR_NAME_SIZE], comment[TABOR_TEXT_SIZE];
  const TaborPresetInfo *info; /* NULL: a file */
} Row;

typedef struct Rows {
  Row *rows;
  size_t count;
  bool is_short; /* of memory */
} Rows;

static Row *add_row(Rows *rows, const char *name, const char *category, const char *comment) {
  Row *const grown = realloc(rows->rows, (rows->count + 1) * sizeof *grown);
  rows->is_short = rows->is_short || !grown;
  if (!grown) return NULL;
  rows->rows = grown;
  Row *const row = &grown[rows->count++];
  *row = (Row){.info = NULL};
  (void)snprintf(row->name, sizeof row->name, "%s", name);
  (void)snprintf(row->category, sizeof row->category, "%s", category);
  (void)snprintf(row->comment, sizeof row->comment, "%s", comment);
  return row;
}

static void add_file(void *context, const char *file, const UserSound *sound) {
  (void)add_row(context, file, sound->category, sound->comment);
}

static int compare_names(const void *a, const void *b) {
  const Row *const one = a, *const other = b;
  return strcmp(one->name, other->name);
}

/* The built-in ones in their order, then the user's by name. */
static Rows gather(const List *list) {
  Rows rows = {0};
  for (uint32_t i = 0; i < list->count(); i++) {
    const TaborPresetInfo *const info = list->at(i);
    Row *const row = add_row(&rows, info->name, info->category, info->comment);
    if (row) row->info = info;
  }
  const size_t first = rows.count;
  user_sounds_visit(list == &kits, add_file, &rows);
  if (rows.rows) qsort(rows.rows + first, rows.count - first, sizeof *rows.rows, compare_names);
  return rows;
}

static int longer(int width, const char *word) {
  const int length = (int)strlen(word);
  return length > width ? length : width;
}

static Outcome print_table(const Rows *rows) {
  int name = 0, category = 0;
  for (size_t i = 0; i < rows->count; i++) {
    name = longer(name, rows->rows[i].name);
    category = longer(category, rows->rows[i].category);
  }
  for (size_t i = 0; i < rows->count; i++) {
    const Row *const row = &rows->rows[i];
    printf("%-*s  %-*s  %s%s\n", name, row->name, category, row->category, row->comment,
           row->info ? "" : "  (your own)");
  }
  return OUTCOME_OK;
}

/* The file of a built-in one is that in presets/, of the user's own its path. */
static json_t *row_json(const Row *row) {
  char path[USER_PRESET_PATH] = "";
  const TaborPresetInfo *const info = row->info;
  if (!info) (void)user_preset_path(row->name, path);
  return json_pack("{s:o, s:o, s:o, s:o, s:o, s:b}", "name", json_text(row->name), "category",
                   json_text(row->category), "base",
                   info && info->base ? json_text(info->base) : json_null(), "comment",
                   json_text(row->comment), "file", json_text(info ? info->file : path), "own",
                   info == NULL);
}

static Outcome print_json(const List *list, const Rows *rows) {
  json_t *array = json_array();
  for (size_t i = 0; i < rows->count; i++) array = json_with_item(array, row_json(&rows->rows[i]));
  return json_print(json_pack("{s:o}", list->key, array));
}

static Outcome run(const Arguments *arguments) {
  const List *const list = arguments_has(arguments, "kits") ? &kits : &presets;
  const Rows rows = gather(list);
  Outcome outcome = rows.is_short ? fail_memory() : OUTCOME_OK;
  if (outcome == OUTCOME_OK)
    outcome = arguments_has(arguments, "json") ? print_json(list, &rows) : print_table(&rows);
  free(rows.rows);
  return outcome;
}

static const Option options[] = {{"kits", 0, NULL, "list kits instead"}, {0}};

const Command presets_command = {
  .name = "presets",
  .summary = "List the presets, or kits, built in and your own",
  .options = options,
  .run = run,
};
