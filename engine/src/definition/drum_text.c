/* SPDX-License-Identifier: MIT */
/* Definitions of drums from texts of sections and keys, and as such texts. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "definition/def_key.h"
#include "definition/def_text.h"
#include "definition/definition.h"
#include "definition/error.h"
#include "definition/preset.h"
#include "definition/text_write.h"

/* ---- reading --------------------------------------------------------------------------------- */

static bool is_of_kit(const char *section) {
  return strcmp(section, "kit") == 0 || tb_begins(section, "drum.") || tb_begins(section, "note.");
}

/* State of the reader. */
typedef struct Reading {
  TaborDrumDef def;
  bool begun; /* a key has been read */
} Reading;

/* The preset that the other lines change. */
static TaborStatus take_base(Reading *reading, const char *name, TaborError *error) {
  if (!reading->begun) return tabor_drum_def_preset(&reading->def, name, error);
  return tb_error_set(error, TABOR_ERROR_KEY, "drum.base", name, NAN, NAN,
                      "'base' is not the first key of the file");
}

static TaborStatus take_pair(Reading *reading, const TaborTextLine *line, TaborError *error) {
  const bool is_base = strcmp(line->full, "drum.base") == 0;
  const TaborStatus status = is_base
                               ? take_base(reading, line->value, error)
                               : tabor_drum_def_set(&reading->def, line->full, line->value, error);
  reading->begun = true;
  return status;
}

/* A TaborTextTake. */
static TaborStatus take_line(void *context, const TaborTextLine *line, TaborError *error) {
  Reading *const reading = context;
  const TaborStatus status = line->key
                               ? take_pair(reading, line, error)
                               : tabor_drum_def_section(&reading->def, line->section, error);
  if (status == TABOR_OK || !is_of_kit(line->section)) return status;
  return tb_error_add(error, status, "; is this file a kit, not a drum?");
}

TaborStatus tabor_drum_def_read(TaborDrumDef *def, const char *text, size_t size,
                                TaborError *error) {
  Reading reading = {.begun = false};
  if (!def) return tb_error_null(error, "definition");
  tabor_drum_def_clear(&reading.def);
  const TaborStatus status = tabor_text_read(text, size, take_line, &reading, error);
  if (status == TABOR_OK) *def = reading.def;
  return status;
}

/* A built-in preset is such a text, and a text may begin with one. */
TaborStatus tabor_drum_def_preset(TaborDrumDef *def, const char *name, TaborError *error) {
  if (!def) return tb_error_null(error, "definition");
  if (!name) return tb_error_null(error, "preset's name");
  const TbPreset *const preset = tb_preset_find(tb_presets, tb_preset_count, "preset", name, error);
  if (!preset) return TABOR_ERROR_NAME;
  return tabor_drum_def_read(def, preset->text, preset->size, error);
}

/* ---- writing --------------------------------------------------------------------------------- */

static size_t section_length(const char *key) {
  const char *const dot = strrchr(key, '.');
  return dot ? (size_t)(dot - key) : 0;
}

static bool same_section(const char *a, const char *b) {
  const size_t length = section_length(a);
  return length == section_length(b) && memcmp(a, b, length) == 0;
}

/* State of the writer. */
typedef struct DrumText {
  const TaborDrumDef *def;
  uint32_t form;
  TbTextWriter writer;
  char before[TB_DEF_KEY_SIZE]; /* the key that was written last */
} DrumText;

/* A TbKeyVisit. */
static bool write_key(void *context, const char *key) {
  DrumText *const text = context;
  TbTextWriter *const writer = &text->writer;
  char value[TABOR_TEXT_SIZE];
  const size_t section = section_length(key);
  const TaborParameter *const parameter =
    text->form == TABOR_TEXT_EDIT ? tabor_parameter_find(key) : NULL;
  if (!same_section(key, text->before)) tb_text_write_section(writer, key, section);
  memcpy(text->before, key, strlen(key) + 1);
  writer->status = tabor_drum_def_get(text->def, key, value, sizeof value, writer->error);
  tb_text_write_pair(writer, key, key + section + 1, value, parameter ? parameter->unit : NULL,
                     parameter ? parameter->text : NULL);
  return writer->status == TABOR_OK;
}

TaborStatus tabor_drum_def_write(const TaborDrumDef *def, uint32_t form, char *text, size_t size,
                                 size_t *length, TaborError *error) {
  DrumText drum = {.def = def, .form = form};
  drum.writer = tb_text_write_begin(text, size, form, error);
  if (drum.writer.status == TABOR_OK) drum.writer.status = tb_check_struct(def, error);
  if (drum.writer.status == TABOR_OK) (void)tb_def_walk_keys(def, write_key, &drum);
  return tb_text_write_end(&drum.writer, length);
}
