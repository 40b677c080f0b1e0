/* SPDX-License-Identifier: MIT */
/**
 * @file presets_command.c
 * `tabor presets`: lists the built-in presets.
 */
#include <stdio.h>
#include <string.h>

#include "base/command.h"
#include "base/json_output.h"

static int longest_name(void) {
  size_t longest = 0;
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    const size_t length = strlen(tabor_preset(i)->name);
    if (length > longest) longest = length;
  }
  return (int)longest;
}

static Outcome print_table(void) {
  const int width = longest_name();
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    const TaborPresetInfo *const preset = tabor_preset(i);
    printf("%-*s  %s\n", width, preset->name, preset->comment);
  }
  return OUTCOME_OK;
}

static Outcome print_json(void) {
  json_t *list = json_array();
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    const TaborPresetInfo *const preset = tabor_preset(i);
    list =
      json_with_item(list, json_pack("{s:o, s:o, s:o}", "name", json_text(preset->name), "comment",
                                     json_text(preset->comment), "file", json_text(preset->file)));
  }
  return json_print(json_pack("{s:o}", "presets", list));
}

static Outcome run(const Arguments *arguments) {
  return arguments_has(arguments, "json") ? print_json() : print_table();
}

static const Option options[] = {{0}};

const Command presets_command = {
  .name = "presets",
  .summary = "List the built-in presets",
  .options = options,
  .run = run,
};
