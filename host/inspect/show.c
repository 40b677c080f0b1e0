/* SPDX-License-Identifier: MIT */
/**
 * @file show.c
 * `tabor show`: prints a drum's parameters as a preset file, or a kit as a kit file, which reads back to the same.
 */
#include <stdio.h>
#include <string.h>

#include "base/command.h"
#include "base/json_output.h"
#include "drums/drum_args.h"
#include "drums/preset_file.h"
#include "drums/preset_text.h"
#include "kit/kit_args.h"
#include "kit/kit_text.h"

static Outcome print_text(void *context, const char *text, size_t size) {
  (void)context;
  (void)fwrite(text, 1, size, stdout);
  return OUTCOME_OK;
}

/* ---- as JSON ---- */

static json_t *value_json(const PresetEntry *entry) {
  const TaborParameterType type = entry->parameter->type;
  if (type != TABOR_TYPE_NUMBER && type != TABOR_TYPE_WHOLE) return json_text(entry->value);
  return json_loads(entry->value, JSON_DECODE_ANY | JSON_DECODE_INT_AS_REAL, NULL);
}

static json_t *entry_json(const PresetEntry *entry) {
  const TaborParameter *const parameter = entry->parameter;
  return json_pack("{s:s, s:o, s:s, s:o, s:o, s:b, s:s}", "key", entry->key, "value",
                   value_json(entry), "unit", parameter->unit, "minimum",
                   json_number(parameter->minimum), "maximum", json_number(parameter->maximum),
                   "live", (int)parameter->live, "text", parameter->text);
}

static Outcome print_json(const TaborDrumDef *def) {
  json_t *list = json_array();
  PresetEntry entry;
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; preset_entry_read(def, i, &entry, &outcome); i++) {
    list = json_with_item(list, entry_json(&entry));
  }
  if (outcome == OUTCOME_OK) {
    return json_print(json_pack("{s:o, s:o}", "name", json_text(def->name), "parameters", list));
  }
  json_decref(list);
  return outcome;
}

static Outcome show_kit(const Arguments *arguments) {
  static const char *const excluded[] = {"json"};
  TaborKitDef def;
  KitSamples samples;
  Outcome outcome = kit_refuse_options(arguments, excluded, 1, "a kit is shown as its file");
  if (outcome != OUTCOME_OK) return outcome;
  outcome = kit_load(arguments, &def, &samples);
  if (outcome == OUTCOME_OK) {
    outcome = kit_text_write(&def, &samples, KIT_TEXT_SHORT, "'tabor show'", print_text, NULL);
  }
  kit_samples_free(&samples);
  return outcome;
}

static Outcome run(const Arguments *arguments) {
  if (arguments_has(arguments, "kit")) return show_kit(arguments);
  TaborDrumDef def;
  const Outcome outcome = drum_load(arguments, &def);
  if (outcome != OUTCOME_OK) return outcome;
  return arguments_has(arguments, "json")
           ? print_json(&def)
           : preset_text_write(&def, "'tabor show'", print_text, NULL);
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
