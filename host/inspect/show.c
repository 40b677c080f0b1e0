/* SPDX-License-Identifier: MIT */
/**
 * @file show.c
 * `tabor show`: prints a drum's parameters as a preset file, or a kit as a kit file, which reads
 * back to the same.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/command.h"
#include "base/json_output.h"
#include "drums/definition_text.h"
#include "drums/drum_args.h"
#include "kit/kit_args.h"

static Outcome print_text(char *text, const TaborError *error) {
  if (!text) return report_engine_error(error);
  (void)fputs(text, stdout);
  free(text);
  return OUTCOME_OK;
}

/* ---- as JSON ---- */

static json_t *value_json(const TaborParameter *parameter, const char *value) {
  const TaborParameterType type = parameter->type;
  if (type != TABOR_TYPE_NUMBER && type != TABOR_TYPE_WHOLE) return json_text(value);
  return json_loads(value, JSON_DECODE_ANY | JSON_DECODE_INT_AS_REAL, NULL);
}

/* The words of a choice, in their order; null of anything else. */
static json_t *choices_json(const TaborParameter *parameter) {
  const char *word = parameter->choices;
  if (!word) return json_null();
  json_t *list = json_array();
  for (size_t length; *word; word += length + (word[length] == '|')) {
    length = strcspn(word, "|");
    list = json_with_item(list, json_stringn(word, length));
  }
  return list;
}

static json_t *entry_json(const char *key, const char *value) {
  const TaborParameter *const parameter = tabor_parameter_find(key);
  return json_pack("{s:s, s:o, s:s, s:o, s:o, s:o, s:b, s:s}", "key", key, "value",
                   value_json(parameter, value), "unit", parameter->unit, "minimum",
                   json_number(parameter->minimum), "maximum", json_number(parameter->maximum),
                   "choices", choices_json(parameter), "live", (int)parameter->live, "text",
                   parameter->text);
}

static Outcome print_json(const TaborDrumDef *def) {
  json_t *list = json_array();
  char key[2 * TABOR_NAME_SIZE], value[TABOR_TEXT_SIZE];
  TaborError error;
  for (uint32_t i = 0; tabor_drum_def_key(def, i, key, sizeof key); i++) {
    if (tabor_drum_def_get(def, key, value, sizeof value, &error) != TABOR_OK) {
      json_decref(list);
      return report_engine_error(&error);
    }
    list = json_with_item(list, entry_json(key, value));
  }
  return json_print(json_pack("{s:o, s:o}", "name", json_text(def->name), "parameters", list));
}

static Outcome show_kit(const Arguments *arguments) {
  static const char *const excluded[] = {"json"};
  TaborKitDef def;
  TaborError error;
  Outcome outcome = kit_refuse_options(arguments, excluded, 1, "a kit is shown as its file");
  if (outcome == OUTCOME_OK) outcome = kit_load(arguments, &def);
  if (outcome != OUTCOME_OK) return outcome;
  return print_text(definition_write_kit(&def, TABOR_TEXT_EDIT, "'tabor show'", &error), &error);
}

static Outcome run(const Arguments *arguments) {
  if (arguments_has(arguments, "kit")) return show_kit(arguments);
  TaborDrumDef def;
  TaborError error;
  const Outcome outcome = drum_load(arguments, &def);
  if (outcome != OUTCOME_OK) return outcome;
  if (arguments_has(arguments, "json")) return print_json(&def);
  return print_text(definition_write(&def, TABOR_TEXT_EDIT, "'tabor show'", &error), &error);
}

static const Option options[] = {OPTION_SET, OPTION_KIT, {0}};

const Command show_command = {
  .name = "show",
  .operand = "[PRESET]",
  .summary = "Print a drum's parameters as a preset file, or a kit",
  .notes = PRESET_NOTES,
  .options = options,
  .run = run,
};
