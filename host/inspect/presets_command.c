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

static int longest_name(const List *list) {
  size_t longest = 0;
  for (uint32_t i = 0; i < list->count(); i++) {
    const size_t length = strlen(list->at(i)->name);
    if (length > longest) longest = length;
  }
  return (int)longest;
}

static Outcome print_table(const List *list) {
  const int width = longest_name(list);
  for (uint32_t i = 0; i < list->count(); i++) {
    printf("%-*s  %s\n", width, list->at(i)->name, list->at(i)->comment);
  }
  return OUTCOME_OK;
}

static Outcome print_json(const List *list) {
  json_t *array = json_array();
  for (uint32_t i = 0; i < list->count(); i++) {
    const TaborPresetInfo *const info = list->at(i);
    array =
      json_with_item(array, json_pack("{s:o, s:o, s:o}", "name", json_text(info->name), "comment",
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
