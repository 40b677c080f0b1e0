/* SPDX-License-Identifier: MIT */
/**
 * @file presets_command.c
 * `tabor presets`: lists the built-in presets, or kits.
 */
#include <stdio.h>
#include <string.h>

#include "base/command.h"
#include "base/json_output.h"

#include <tabor/kit.h>

/* Presets, or kits. */
typedef struct List {
  const char *key;
  uint32_t (*count)(void);
  const TaborPresetInfo *(*at)(uint32_t index);
} List;

static const List presets = {"presets", tabor_preset_count, tabor_preset};
static const List kits = {"kits", tabor_kit_count, tabor_kit};

static int longer(int width, const char *word) {
  const int length = (int)strlen(word);
  return length > width ? length : width;
}

static Outcome print_table(const List *list) {
  int name = 0, category = 0;
  for (uint32_t i = 0; i < list->count(); i++) {
    name = longer(name, list->at(i)->name);
    category = longer(category, list->at(i)->category);
  }
  for (uint32_t i = 0; i < list->count(); i++) {
    const TaborPresetInfo *const info = list->at(i);
    printf("%-*s  %-*s  %s\n", name, info->name, category, info->category, info->comment);
  }
  return OUTCOME_OK;
}

static Outcome print_json(const List *list) {
  json_t *array = json_array();
  for (uint32_t i = 0; i < list->count(); i++) {
    const TaborPresetInfo *const info = list->at(i);
    array =
      json_with_item(array, json_pack("{s:o, s:o, s:o, s:o, s:o}", "name", json_text(info->name),
                                      "category", json_text(info->category), "base",
                                      info->base ? json_text(info->base) : json_null(), "comment",
                                      json_text(info->comment), "file", json_text(info->file)));
  }
  return json_print(json_pack("{s:o}", list->key, array));
}

static Outcome run(const Arguments *arguments) {
  const List *const list = arguments_has(arguments, "kits") ? &kits : &presets;
  return arguments_has(arguments, "json") ? print_json(list) : print_table(list);
}

static const Option options[] = {{"kits", 0, NULL, "list the built-in kits instead"}, {0}};

const Command presets_command = {
  .name = "presets",
  .summary = "List the built-in presets, or kits",
  .options = options,
  .run = run,
};
