/* SPDX-License-Identifier: MIT */
/**
 * @file show.c
 * `tabor show`: prints a drum's parameters as a preset file, which reads back to the same drum.
 */
#include <stdio.h>
#include <string.h>

#include "base/command.h"
#include "base/json_output.h"
#include "drums/drum_args.h"
#include "drums/preset_file.h"

#define LONGEST_KEY (2 * TABOR_NAME_SIZE)
#define LINE_COLUMN 36 /* where comments begin */

/* One parameter of a definition. */
typedef struct Entry {
  char key[LONGEST_KEY]; /* "striker.stick.mass" */
  char value[TABOR_TEXT_SIZE];
  const TaborParameter *parameter;
} Entry;

/* Reads entry @p index; false past the last, and on an error, which goes to *outcome. */
static bool entry_read(const TaborDrumDef *def, uint32_t index, Entry *entry, Outcome *outcome) {
  TaborError error;
  if (!tabor_drum_def_key(def, index, entry->key, sizeof entry->key)) return false;
  entry->parameter = tabor_parameter_find(entry->key);
  if (tabor_drum_def_get(def, entry->key, entry->value, sizeof entry->value, &error) != TABOR_OK) {
    *outcome = report_engine_error(&error);
    return false;
  }
  return true;
}

/* ---- as a preset file ---- */

static size_t section_length(const char *key) {
  const char *const dot = strrchr(key, '.');
  return dot ? (size_t)(dot - key) : 0;
}

/* A preset file has no way to quote, so a text that it would read differently cannot be written. */
static bool survives_preset(const char *value) {
  const size_t length = strlen(value);
  if (length == 0) return true;
  for (const char *byte = value; *byte; byte++) {
    if ((unsigned char)*byte < 0x20 || *byte == 0x7f) return false;
  }
  return value[0] != ' ' && value[0] != ';' && value[length - 1] != ' ' && !strstr(value, " ;");
}

static void print_section(const Entry *entry, const char *previous) {
  const size_t length = section_length(entry->key);
  if (length == section_length(previous) && memcmp(entry->key, previous, length) == 0) return;
  printf("\n[%.*s]\n", (int)length, entry->key);
}

static void write_comment(const TaborParameter *parameter, char *comment, size_t size) {
  const bool has_unit = parameter->unit[0] != '\0';
  (void)snprintf(comment, size, "; %s%s%s%s", has_unit ? "[" : "", parameter->unit,
                 has_unit ? "] " : "", parameter->text);
}

static void write_line(const Entry *entry, char *line, size_t size) {
  (void)snprintf(line, size, "%s = %s", entry->key + section_length(entry->key) + 1, entry->value);
}

static void print_entry(const Entry *entry) {
  char line[LONGEST_KEY + TABOR_TEXT_SIZE], comment[512];
  write_line(entry, line, sizeof line);
  write_comment(entry->parameter, comment, sizeof comment);
  const size_t length = strlen(line) < LINE_COLUMN ? LINE_COLUMN : strlen(line);
  if (length + 1 + strlen(comment) > PRESET_LINE_LIMIT) {
    printf("%.*s\n%s\n", PRESET_LINE_LIMIT, comment, line);
  } else {
    printf("%-*s %s\n", LINE_COLUMN, line, comment);
  }
}

static Outcome check_entry(const Entry *entry) {
  char line[LONGEST_KEY + TABOR_TEXT_SIZE];
  write_line(entry, line, sizeof line);
  if (strlen(line) > PRESET_LINE_LIMIT) {
    return refuse("%s: a preset file's lines hold %d bytes, '%s = ' with them; this text has %zu",
                  entry->key, PRESET_LINE_LIMIT, entry->key + section_length(entry->key) + 1,
                  strlen(entry->value));
  }
  if (survives_preset(entry->value)) return OUTCOME_OK;
  return refuse("%s: a preset file cannot hold this text: '%.80s'", entry->key, entry->value);
}

static Outcome check_preset(const TaborDrumDef *def) {
  Entry entry;
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; outcome == OUTCOME_OK && entry_read(def, i, &entry, &outcome); i++) {
    outcome = check_entry(&entry);
  }
  return outcome;
}

static Outcome print_preset(const TaborDrumDef *def) {
  Entry entry;
  char previous[LONGEST_KEY] = "";
  Outcome outcome = check_preset(def);
  if (outcome != OUTCOME_OK) return outcome;
  printf("; A Tabor preset, written by 'tabor show'. SI units, angles in degrees.\n");
  for (uint32_t i = 0; entry_read(def, i, &entry, &outcome); i++) {
    print_section(&entry, previous);
    print_entry(&entry);
    memcpy(previous, entry.key, sizeof previous);
  }
  return outcome;
}

/* ---- as JSON ---- */

static json_t *value_json(const Entry *entry) {
  const TaborParameterType type = entry->parameter->type;
  if (type != TABOR_TYPE_NUMBER && type != TABOR_TYPE_WHOLE) return json_text(entry->value);
  return json_loads(entry->value, JSON_DECODE_ANY | JSON_DECODE_INT_AS_REAL, NULL);
}

static json_t *entry_json(const Entry *entry) {
  const TaborParameter *const parameter = entry->parameter;
  return json_pack("{s:s, s:o, s:s, s:o, s:o, s:b, s:s}", "key", entry->key, "value",
                   value_json(entry), "unit", parameter->unit, "minimum",
                   json_number(parameter->minimum), "maximum", json_number(parameter->maximum),
                   "live", (int)parameter->live, "text", parameter->text);
}

static Outcome print_json(const TaborDrumDef *def) {
  json_t *list = json_array();
  Entry entry;
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; entry_read(def, i, &entry, &outcome); i++) {
    list = json_with_item(list, entry_json(&entry));
  }
  if (outcome == OUTCOME_OK) {
    return json_print(json_pack("{s:o, s:o}", "name", json_text(def->name), "parameters", list));
  }
  json_decref(list);
  return outcome;
}

static Outcome run(const Arguments *arguments) {
  TaborDrumDef def;
  const Outcome outcome = drum_load(arguments, &def);
  if (outcome != OUTCOME_OK) return outcome;
  return arguments_has(arguments, "json") ? print_json(&def) : print_preset(&def);
}

static const Option options[] = {OPTION_SET, {0}};

const Command show_command = {
  .name = "show",
  .operand = "[PRESET]",
  .summary = "Print a drum's parameters as a preset file",
  .notes = PRESET_NOTES,
  .options = options,
  .run = run,
};
