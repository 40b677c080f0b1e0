/* SPDX-License-Identifier: MIT */
/* Kit definitions from text: keys, sections, and whole texts. */
#define _POSIX_C_SOURCE 200809L /* strnlen */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "definition/def_key.h"
#include "definition/def_text.h"
#include "definition/error.h"
#include "kit/kit_def.h"
#include "kit/kit_fields.h"

static const char DRUM_SECTION[] = "drum.";

/* The field nearest to @p name; "" if none is near. */
static const char *nearest_field(const TbKitField *fields, uint32_t count, const char *name) {
  const char *nearest = "";
  size_t smallest = SIZE_MAX;
  for (uint32_t i = 0; i < count; i++) {
    if (tb_word_is_nearer(name, fields[i].key, &smallest)) nearest = fields[i].key;
  }
  return nearest;
}

static TaborStatus refuse_unknown(const char *what, const char *text, TaborError *error) {
  return tb_error_set(error, TABOR_ERROR_KEY, text, NULL, NAN, NAN, "a kit has no %s '%s'", what,
                      text);
}

/* A field @p name of a section, whose full key is @p key; the nearest name is that within the
 * section. */
static TaborStatus refuse_field(const TbKitField *fields, uint32_t count, const char *key,
                                const char *name, TaborError *error) {
  const char *const nearest = nearest_field(fields, count, name);
  if (!*nearest) return refuse_unknown("key", key, error);
  return tb_error_set(error, TABOR_ERROR_KEY, key, NULL, NAN, NAN,
                      "a kit has no key '%s'; did you mean '%s'?", key, nearest);
}

/* A key of a drum without the drum is a frequent mistake. */
static TaborStatus refuse_key(const char *key, TaborError *error) {
  TbKey parsed;
  if (tb_def_key_parse(key, &parsed) != TB_DEF_KEY_OK) return refuse_unknown("key", key, error);
  return tb_error_set(error, TABOR_ERROR_KEY, key, NULL, NAN, NAN,
                      "a kit has no key '%s', but its drums have: 'drum.NAME.%s'", key, key);
}

static TaborStatus read_number(const TbKitField *field, const char *key, const char *text,
                               double *number, TaborError *error) {
  if (tb_number_parse(text, number) != TB_PARSE_OK) {
    return tb_error_set(error, TABOR_ERROR_VALUE, key, text, NAN, NAN, "%s '%s': not a number", key,
                        text);
  }
  if (*number >= field->minimum && *number <= field->maximum) return TABOR_OK;
  return tb_error_set(error, TABOR_ERROR_RANGE, key, text, field->minimum, field->maximum,
                      "%s '%s': allowed are %g to %g %s", key, text, field->minimum, field->maximum,
                      field->unit);
}

static TaborStatus copy_text(char *to, size_t size, const char *key, const char *text,
                             TaborError *error) {
  if (!tb_text_is_valid(text, size)) {
    return tb_error_set(error, TABOR_ERROR_VALUE, key, text, NAN, NAN,
                        "%s: the text is longer than %zu bytes or not printable", key, size - 1);
  }
  memset(to, 0, size);
  memcpy(to, text, strlen(text));
  return tb_error_clear(error);
}

/* ---- [kit] and [room] ------------------------------------------------------------------------ */

static TaborStatus set_coupling(TaborKitDef *def, const char *key, const char *text,
                                TaborError *error) {
  if (strcmp(text, "off") == 0) {
    def->coupled = 0;
    return tb_error_clear(error);
  }
  const TbKitField *const field = tb_kit_field_find(tb_kit_fields, tb_kit_field_count, "coupling");
  double number;
  const TaborStatus status = read_number(field, key, text, &number, error);
  if (status != TABOR_OK) return status;
  def->coupled = 1;
  def->coupling = number;
  return TABOR_OK;
}

static TaborStatus set_kit(TaborKitDef *def, const char *key, const char *name, const char *text,
                           TaborError *error) {
  if (strcmp(name, "name") == 0) return copy_text(def->name, sizeof def->name, key, text, error);
  if (strcmp(name, "comment") == 0) {
    return copy_text(def->comment, sizeof def->comment, key, text, error);
  }
  if (strcmp(name, "license") == 0) {
    return copy_text(def->license, sizeof def->license, key, text, error);
  }
  if (strcmp(name, "coupling") == 0) return set_coupling(def, key, text, error);
  const TbKitField *const field = tb_kit_field_find(tb_kit_fields, tb_kit_field_count, name);
  if (!field) return refuse_field(tb_kit_fields, tb_kit_field_count, key, name, error);
  double number;
  const TaborStatus status = read_number(field, key, text, &number, error);
  if (status == TABOR_OK) *tb_kit_field_at(field, def) = number;
  return status;
}

static TaborStatus set_room(TaborKitDef *def, const char *key, const char *text,
                            TaborError *error) {
  TaborDrumDef carrier;
  tb_kit_carry_room(def, &carrier);
  const TaborStatus status = tabor_drum_def_set(&carrier, key, text, error);
  if (status == TABOR_OK) def->room = carrier.room;
  return status;
}

/* ---- [drum.NAME] ----------------------------------------------------------------------------- */

static void new_drum(TaborKitDrumDef *drum, const char *name, size_t length) {
  memset(drum, 0, sizeof *drum);
  memcpy(drum->name, name, length);
  tabor_drum_def_default(&drum->def);
  for (uint32_t i = 0; i < tb_kit_drum_field_count; i++) {
    *tb_kit_field_at(&tb_kit_drum_fields[i], drum) = tb_kit_drum_fields[i].fallback;
  }
}

/* Index of the drum whose name has `length` bytes, which may be the next new one; else the error.
 */
static TaborStatus find_drum(const TaborKitDef *def, const char *key, const char *text,
                             size_t length, uint32_t *drum, TaborError *error) {
  char name[TABOR_NAME_SIZE] = "";
  if (length > TABOR_NAME_LENGTH) length = 0;
  memcpy(name, text, length);
  if (!tb_name_is_valid(name, sizeof name)) {
    return tb_error_set(error, TABOR_ERROR_KEY, key, NULL, NAN, NAN,
                        "%s: a drum's name has 1 to %d letters, digits, '-' and '_'", key,
                        TABOR_NAME_LENGTH);
  }
  const int found = tabor_kit_def_find(def, name);
  *drum = found >= 0 ? (uint32_t)found : def->drum_count;
  if (*drum < TABOR_KIT_DRUMS) return TABOR_OK;
  return tb_error_set(error, TABOR_ERROR_FULL, key, NULL, 0.0, TABOR_KIT_DRUMS,
                      "%s: a kit has %d drums at most", key, TABOR_KIT_DRUMS);
}

static TaborStatus set_preset(TaborKitDrumDef *drum, const char *key, const char *text,
                              TaborError *error) {
  TaborError own;
  if (strcmp(text, "none") == 0) {
    tabor_drum_def_clear(&drum->def);
    return tb_error_clear(error);
  }
  const TaborStatus status = tabor_drum_def_preset(&drum->def, text, &own);
  if (status == TABOR_OK) return tb_error_clear(error);
  return tb_error_set(error, status, key, text, NAN, NAN, "%s: %s", key, own.message);
}

static TaborStatus set_choke(uint32_t *choke, const char *key, const char *text,
                             TaborError *error) {
  uint32_t group;
  if (tb_whole_parse(text, &group) != TB_PARSE_OK || group > TB_KIT_MOST_CHOKE) {
    return tb_error_set(error, TABOR_ERROR_RANGE, key, text, 0.0, TB_KIT_MOST_CHOKE,
                        "%s '%s': allowed are 0 (none) to %u", key, text, TB_KIT_MOST_CHOKE);
  }
  *choke = group;
  return tb_error_clear(error);
}

/* The next number of a list like "38, 40"; its length in bytes, 0 at the end or at what is no note.
 */
static size_t next_note(const char **text, uint32_t *note) {
  *text += strspn(*text, " \t,");
  char digits[4] = "";
  const size_t length = strspn(*text, "0123456789");
  if (length == 0 || length >= sizeof digits) return 0;
  memcpy(digits, *text, length);
  if (tb_whole_parse(digits, note) != TB_PARSE_OK || *note >= TABOR_KIT_NOTES) return 0;
  *text += length;
  return length;
}

static TaborStatus set_notes(TaborKitDrumDef *drum, uint32_t stroke, const char *key,
                             const char *text, TaborError *error) {
  uint8_t notes[TABOR_KIT_NOTES];
  memcpy(notes, drum->notes, sizeof notes);
  for (uint32_t i = 0; i < TABOR_KIT_NOTES; i++) {
    if (notes[i] == stroke) notes[i] = TABOR_KIT_STROKE_NONE;
  }
  const char *at = text;
  uint32_t note;
  while (next_note(&at, &note) > 0) {
    if (notes[note] != TABOR_KIT_STROKE_NONE && notes[note] != stroke) {
      return tb_error_set(error, TABOR_ERROR_VALUE, key, text, NAN, NAN,
                          "%s: note %u already plays the drum as '%s'", key, note,
                          tb_kit_stroke_word(notes[note]));
    }
    notes[note] = (uint8_t)stroke;
  }
  if (at[strspn(at, " \t,")] != '\0') {
    return tb_error_set(error, TABOR_ERROR_VALUE, key, text, 0.0, TABOR_KIT_NOTES - 1,
                        "%s '%s': allowed are notes from 0 to %d, as 38, 40", key, text,
                        TABOR_KIT_NOTES - 1);
  }
  memcpy(drum->notes, notes, sizeof notes);
  return tb_error_clear(error);
}

/* A key of the drum itself; errors name it with the kit's drum. */
static TaborStatus set_own(TaborKitDrumDef *drum, const char *key, const char *name,
                           const char *text, TaborError *error) {
  TaborError own;
  const TaborStatus status = tabor_drum_def_set(&drum->def, name, text, &own);
  if (status == TABOR_OK) return tb_error_clear(error);
  return tb_error_set(error, status, key, own.value, own.minimum, own.maximum, "drum.%s: %s",
                      drum->name, own.message);
}

static TaborStatus set_drum(TaborKitDrumDef *drum, const char *key, const char *name,
                            const char *text, TaborError *error) {
  if (strcmp(name, "preset") == 0) return set_preset(drum, key, text, error);
  if (strcmp(name, "choke") == 0) return set_choke(&drum->choke, key, text, error);
  if (strcmp(name, "mic") == 0) return copy_text(drum->mic, sizeof drum->mic, key, text, error);
  for (uint32_t stroke = 1; stroke < TB_KIT_STROKES; stroke++) {
    if (strcmp(name, tb_kit_stroke_word(stroke)) == 0) {
      return set_notes(drum, stroke, key, text, error);
    }
  }
  const TbKitField *const field =
    tb_kit_field_find(tb_kit_drum_fields, tb_kit_drum_field_count, name);
  if (!field && strchr(name, '.')) return set_own(drum, key, name, text, error);
  if (!field) return refuse_field(tb_kit_drum_fields, tb_kit_drum_field_count, key, name, error);
  double number;
  const TaborStatus status = read_number(field, key, text, &number, error);
  if (status == TABOR_OK) *tb_kit_field_at(field, drum) = number;
  return status;
}

/* On a copy, so that an error leaves the kit as it was. */
static TaborStatus set_drum_key(TaborKitDef *def, const char *key, const char *text,
                                TaborError *error) {
  const char *const name = key + strlen(DRUM_SECTION);
  const char *const dot = strchr(name, '.');
  uint32_t index;
  if (!dot) return refuse_unknown("key", key, error);
  TaborStatus status = find_drum(def, key, name, (size_t)(dot - name), &index, error);
  if (status != TABOR_OK) return status;
  TaborKitDrumDef drum = def->drum[index];
  if (index == def->drum_count) new_drum(&drum, name, (size_t)(dot - name));
  status = set_drum(&drum, key, dot + 1, text, error);
  if (status != TABOR_OK) return status;
  def->drum[index] = drum;
  if (index == def->drum_count) def->drum_count++;
  return TABOR_OK;
}

/* ---- [note.N] -------------------------------------------------------------------------------- */

static TaborStatus refuse_note(const char *key, TaborError *error) {
  return tb_error_set(error, TABOR_ERROR_KEY, key, NULL, 0.0, TABOR_KIT_NOTES - 1,
                      "'%s': allowed are note.0 to note.%d, with the keys sample, gain and choke",
                      key, TABOR_KIT_NOTES - 1);
}

static TaborStatus set_note(TaborKitDef *def, const char *key, const char *text,
                            TaborError *error) {
  const char *rest;
  double number;
  const int index = tb_kit_note_parse(key, &rest);
  if (index < 0) return refuse_note(key, error);
  TaborKitNoteDef *const note = &def->note[index];
  if (strcmp(rest, ".sample") == 0) {
    return copy_text(note->sample, sizeof note->sample, key, text, error);
  }
  if (strcmp(rest, ".choke") == 0) return set_choke(&note->choke, key, text, error);
  if (strcmp(rest, ".gain") != 0) return refuse_note(key, error);
  const TaborStatus status = read_number(&tb_kit_note_gain, key, text, &number, error);
  if (status == TABOR_OK) note->gain = number;
  return status;
}

/* ---- all of them ----------------------------------------------------------------------------- */

TaborStatus tabor_kit_def_set(TaborKitDef *def, const char *key, const char *value,
                              TaborError *error) {
  const TaborStatus status = tb_kit_check_struct(def, error);
  if (status != TABOR_OK) return status;
  if (!key) return tb_error_null(error, "key");
  if (!value) return tb_error_null(error, "text");
  if (tb_begins(key, "kit.")) return set_kit(def, key, key + strlen("kit."), value, error);
  if (tb_begins(key, "room.")) return set_room(def, key, value, error);
  if (tb_begins(key, DRUM_SECTION)) return set_drum_key(def, key, value, error);
  if (tb_begins(key, "note.")) return set_note(def, key, value, error);
  return refuse_key(key, error);
}

TaborStatus tabor_kit_def_section(TaborKitDef *def, const char *section, TaborError *error) {
  TaborStatus status = tb_kit_check_struct(def, error);
  if (status != TABOR_OK) return status;
  if (!section) return tb_error_null(error, "section");
  if (strcmp(section, "kit") == 0 || strcmp(section, "room") == 0) return tb_error_clear(error);
  if (tb_begins(section, "note.")) {
    const char *rest;
    const bool is_note = tb_kit_note_parse(section, &rest) >= 0 && *rest == '\0';
    return is_note ? tb_error_clear(error) : refuse_note(section, error);
  }
  if (!tb_begins(section, DRUM_SECTION)) return refuse_unknown("section", section, error);
  const char *const name = section + strlen(DRUM_SECTION);
  uint32_t index;
  status = find_drum(def, section, name, strlen(name), &index, error);
  if (status != TABOR_OK) return status;
  if (index == def->drum_count) new_drum(&def->drum[def->drum_count++], name, strlen(name));
  return tb_error_clear(error);
}

/* A TaborTextTake. */
static TaborStatus take_line(void *def, const TaborTextLine *line, TaborError *error) {
  if (!line->key) return tabor_kit_def_section(def, line->section, error);
  return tabor_kit_def_set(def, line->full, line->value, error);
}

TaborStatus tabor_kit_def_read(TaborKitDef *def, const char *text, size_t size, TaborError *error) {
  if (!def) return tb_error_null(error, "kit definition");
  TaborKitDef *const read = malloc(sizeof *read);
  if (!read) return tb_error_set(error, TABOR_ERROR_MEMORY, NULL, NULL, NAN, NAN, "out of memory");
  tabor_kit_def_default(read);
  const TaborStatus status = tabor_text_read(text, size, take_line, read, error);
  if (status == TABOR_OK) *def = *read;
  free(read);
  return status;
}
