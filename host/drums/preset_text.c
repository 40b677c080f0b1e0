/* SPDX-License-Identifier: MIT */
#include "drums/preset_text.h"

#include <stdio.h>
#include <string.h>

#include "base/output_file.h"
#include "drums/preset_file.h"

#define LONGEST_KEY (2 * TABOR_NAME_SIZE)
#define LINE_COLUMN 36 /* where comments begin */

bool preset_entry_read(const TaborDrumDef *def, uint32_t index, PresetEntry *entry,
                       Outcome *outcome) {
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

bool preset_text_survives(const char *value) {
  const size_t length = strlen(value);
  if (length == 0) return true;
  for (const char *byte = value; *byte; byte++) {
    if ((unsigned char)*byte < 0x20 || *byte == 0x7f) return false;
  }
  return value[0] != ' ' && value[0] != ';' && value[length - 1] != ' ' && !strstr(value, " ;");
}

static void write_comment(const TaborParameter *parameter, char *comment, size_t size) {
  const bool has_unit = parameter->unit[0] != '\0';
  (void)snprintf(comment, size, "; %s%s%s%s", has_unit ? "[" : "", parameter->unit,
                 has_unit ? "] " : "", parameter->text);
}

static void write_line(const PresetEntry *entry, char *line, size_t size) {
  (void)snprintf(line, size, "%s = %s", entry->key + section_length(entry->key) + 1, entry->value);
}

/* The header of the section that the entry begins, or nothing. */
static void write_section(const PresetEntry *entry, const char *previous, char *text, size_t size) {
  const size_t length = section_length(entry->key);
  text[0] = '\0';
  if (length == section_length(previous) && memcmp(entry->key, previous, length) == 0) return;
  (void)snprintf(text, size, "\n[%.*s]\n", (int)length, entry->key);
}

static Outcome give_entry(const PresetEntry *entry, const char *previous, PresetSink *sink,
                          void *context) {
  char section[LONGEST_KEY + 4], line[LONGEST_KEY + TABOR_TEXT_SIZE], comment[512];
  char text[sizeof section + sizeof line + sizeof comment + LINE_COLUMN];
  write_section(entry, previous, section, sizeof section);
  write_line(entry, line, sizeof line);
  write_comment(entry->parameter, comment, sizeof comment);
  const size_t length = strlen(line) < LINE_COLUMN ? LINE_COLUMN : strlen(line);
  const bool apart = length + 1 + strlen(comment) > PRESET_LINE_LIMIT;
  const int size =
    apart ? snprintf(text, sizeof text, "%s%.*s\n%s\n", section, PRESET_LINE_LIMIT, comment, line)
          : snprintf(text, sizeof text, "%s%-*s %s\n", section, LINE_COLUMN, line, comment);
  return sink(context, text, (size_t)size);
}

static Outcome check_entry(const PresetEntry *entry) {
  char line[LONGEST_KEY + TABOR_TEXT_SIZE];
  write_line(entry, line, sizeof line);
  if (strlen(line) > PRESET_LINE_LIMIT) {
    return refuse("%s: a preset file's lines hold %d bytes, '%s = ' with them; this text has %zu",
                  entry->key, PRESET_LINE_LIMIT, entry->key + section_length(entry->key) + 1,
                  strlen(entry->value));
  }
  if (preset_text_survives(entry->value)) return OUTCOME_OK;
  return refuse("%s: a preset file cannot hold this text: '%.80s'", entry->key, entry->value);
}

static Outcome check_preset(const TaborDrumDef *def) {
  PresetEntry entry;
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; outcome == OUTCOME_OK && preset_entry_read(def, i, &entry, &outcome); i++) {
    outcome = check_entry(&entry);
  }
  return outcome;
}

Outcome preset_text_write(const TaborDrumDef *def, const char *by, PresetSink *sink,
                          void *context) {
  PresetEntry entry;
  char previous[LONGEST_KEY] = "", first[120];
  Outcome outcome = check_preset(def);
  if (outcome != OUTCOME_OK) return outcome;
  const int size = snprintf(first, sizeof first,
                            "; A Tabor preset, written by %s. SI units, angles in degrees.\n", by);
  outcome = sink(context, first, (size_t)size);
  for (uint32_t i = 0; outcome == OUTCOME_OK && preset_entry_read(def, i, &entry, &outcome); i++) {
    outcome = give_entry(&entry, previous, sink, context);
    memcpy(previous, entry.key, sizeof previous);
  }
  return outcome;
}

/* ---- as a file ---- */

static Outcome give_file(void *context, const char *text, size_t size) {
  return output_write(context, text, size);
}

Outcome preset_text_save(const char *path, PresetWriterFn *write, const void *what) {
  OutputFile file = OUTPUT_FILE_NONE, *const files[] = {&file};
  Outcome outcome = output_plan(&file, path, false);
  if (outcome == OUTCOME_OK) outcome = output_open(&file, false);
  if (outcome == OUTCOME_OK) outcome = write(what, give_file, &file);
  if (outcome == OUTCOME_OK) outcome = output_complete(&file);
  if (outcome == OUTCOME_OK) outcome = output_deliver(files, 1);
  output_discard(&file);
  return outcome;
}
