/* SPDX-License-Identifier: MIT */
/* Defaults and checks of kit definitions. */
#include "kit/kit_def.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "definition/def_text.h"
#include "definition/error.h"
#include "kit/kit_fields.h"

void tabor_kit_def_default(TaborKitDef *def) {
  if (!def) return;
  memset(def, 0, sizeof *def);
  def->struct_size = (uint32_t)sizeof *def;
  def->coupled = 1;
  for (uint32_t i = 0; i < tb_kit_field_count; i++) {
    *tb_kit_field_at(&tb_kit_fields[i], def) = tb_kit_fields[i].fallback;
  }
  TaborDrumDef plain;
  tabor_drum_def_default(&plain);
  def->room = plain.room;
}

void tb_kit_carry_room(const TaborKitDef *def, TaborDrumDef *carrier) {
  tabor_drum_def_default(carrier);
  carrier->room = def->room;
}

int tabor_kit_def_find(const TaborKitDef *def, const char *name) {
  for (uint32_t i = 0; i < def->drum_count && i < TABOR_KIT_DRUMS; i++) {
    if (strncmp(def->drum[i].name, name, TABOR_NAME_SIZE) == 0) return (int)i;
  }
  return -1;
}

/* ---- checks ---------------------------------------------------------------------------------- */

TaborStatus tb_kit_check_struct(const TaborKitDef *def, TaborError *error) {
  if (!def) return tb_error_null(error, "kit definition");
  if (def->struct_size == sizeof *def) return TABOR_OK;
  return tb_error_set(error, TABOR_ERROR_ARGUMENT, NULL, NULL, NAN, NAN,
                      "the kit definition's struct_size %u is not that of this library, %zu",
                      (unsigned)def->struct_size, sizeof *def);
}

/* `of` names the drum, or is "kit". */
static TaborStatus check_fields(const TbKitField *fields, uint32_t count, const void *values,
                                const char *of, TaborError *error) {
  for (uint32_t i = 0; i < count; i++) {
    const TbKitField *const field = &fields[i];
    const double value = tb_kit_field_value(field, values);
    if (value >= field->minimum && value <= field->maximum) continue;
    return tb_error_set(error, TABOR_ERROR_RANGE, field->key, NULL, field->minimum, field->maximum,
                        "%s: %s is %g %s; allowed: %g to %g", of, field->key, value, field->unit,
                        field->minimum, field->maximum);
  }
  return TABOR_OK;
}

static TaborStatus check_texts(const TaborKitDef *def, TaborError *error) {
  const bool valid = tb_text_is_valid(def->name, sizeof def->name) &&
                     tb_text_is_valid(def->comment, sizeof def->comment) &&
                     tb_text_is_valid(def->license, sizeof def->license);
  if (valid) return TABOR_OK;
  return tb_error_set(error, TABOR_ERROR_VALUE, "kit.name", NULL, NAN, NAN,
                      "name, comment and license of a kit are lines of printable text");
}

static TaborStatus check_name(const TaborKitDef *def, uint32_t drum, TaborError *error) {
  const char *const name = def->drum[drum].name;
  if (!tb_name_is_valid(name, TABOR_NAME_LENGTH + 1)) {
    return tb_error_set(error, TABOR_ERROR_VALUE, "drum", NULL, NAN, NAN,
                        "drum %u of the kit: a name has 1 to %d letters, digits, '-' and '_'",
                        drum + 1, TABOR_NAME_LENGTH);
  }
  if (tabor_kit_def_find(def, name) == (int)drum) return TABOR_OK;
  return tb_error_set(error, TABOR_ERROR_NAME, name, NULL, NAN, NAN, "two drums are called '%s'",
                      name);
}

static TaborStatus check_choices(const TaborKitDrumDef *drum, TaborError *error) {
  if (drum->choke > TB_KIT_MOST_CHOKE) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "choke", NULL, 0.0, TB_KIT_MOST_CHOKE,
                        "%s: choke group %u; allowed: 0 (none) to %u", drum->name,
                        (unsigned)drum->choke, TB_KIT_MOST_CHOKE);
  }
  if (!tb_text_is_valid(drum->mic, sizeof drum->mic)) {
    return tb_error_set(error, TABOR_ERROR_VALUE, "mic", NULL, NAN, NAN,
                        "%s: the name of its close microphone is not a line of printable text",
                        drum->name);
  }
  for (uint32_t note = 0; note < TABOR_KIT_NOTES; note++) {
    if (drum->notes[note] < TB_KIT_STROKES) continue;
    return tb_error_set(error, TABOR_ERROR_VALUE, "notes", NULL, NAN, NAN,
                        "%s: note %u has no stroke that there is", drum->name, note);
  }
  return TABOR_OK;
}

/* A drum's own error, with the drum's name before it. */
static TaborStatus check_drum(const TaborKitDrumDef *drum, TaborError *error) {
  TaborError own;
  const TaborStatus status = tabor_drum_def_validate(&drum->def, &own);
  if (status == TABOR_OK) return status;
  return tb_error_set(error, status, own.key, own.value, own.minimum, own.maximum, "%s: %s",
                      drum->name, own.message);
}

static TaborStatus check_notes(const TaborKitDef *def, TaborError *error) {
  for (uint32_t note = 0; note < TABOR_KIT_NOTES; note++) {
    const TaborKitDrumDef *first = NULL;
    for (uint32_t i = 0; i < def->drum_count; i++) {
      if (def->drum[i].notes[note] == TABOR_KIT_STROKE_NONE) continue;
      if (first) {
        return tb_error_set(error, TABOR_ERROR_VALUE, "notes", NULL, NAN, NAN,
                            "note %u plays both '%s' and '%s'", note, first->name,
                            def->drum[i].name);
      }
      first = &def->drum[i];
    }
  }
  return TABOR_OK;
}

static TaborStatus check_samples(const TaborKitDef *def, TaborError *error) {
  for (uint32_t note = 0; note < TABOR_KIT_NOTES; note++) {
    const TaborKitNoteDef *const sample = &def->note[note];
    char key[TABOR_NAME_SIZE];
    (void)snprintf(key, sizeof key, "note.%lu", (unsigned long)note);
    if (!tb_text_is_valid(sample->sample, sizeof sample->sample)) {
      return tb_error_set(error, TABOR_ERROR_VALUE, key, NULL, NAN, NAN,
                          "%s: the name of its sound file is not a line of printable text", key);
    }
    if (sample->choke > TB_KIT_MOST_CHOKE) {
      return tb_error_set(error, TABOR_ERROR_RANGE, key, NULL, 0.0, TB_KIT_MOST_CHOKE,
                          "%s: choke group %u; allowed: 0 (none) to %u", key,
                          (unsigned)sample->choke, TB_KIT_MOST_CHOKE);
    }
    const TaborStatus status = check_fields(&tb_kit_note_gain, 1, sample, key, error);
    if (status != TABOR_OK) return status;
  }
  return TABOR_OK;
}

TaborStatus tabor_kit_def_validate(const TaborKitDef *def, TaborError *error) {
  TaborStatus status = tb_kit_check_struct(def, error);
  if (status != TABOR_OK) return status;
  if (def->drum_count > TABOR_KIT_DRUMS) {
    return tb_error_set(error, TABOR_ERROR_FULL, "drum", NULL, 0.0, TABOR_KIT_DRUMS,
                        "%u drums; a kit has %d at most", (unsigned)def->drum_count,
                        TABOR_KIT_DRUMS);
  }
  status = check_texts(def, error);
  if (status == TABOR_OK)
    status = check_fields(tb_kit_fields, tb_kit_field_count, def, "kit", error);
  for (uint32_t i = 0; i < def->drum_count && status == TABOR_OK; i++) {
    const TaborKitDrumDef *const drum = &def->drum[i];
    status = check_name(def, i, error);
    if (status == TABOR_OK) {
      status = check_fields(tb_kit_drum_fields, tb_kit_drum_field_count, drum, drum->name, error);
    }
    if (status == TABOR_OK) status = check_choices(drum, error);
    if (status == TABOR_OK) status = check_drum(drum, error);
  }
  if (status == TABOR_OK) status = check_notes(def, error);
  return status == TABOR_OK ? check_samples(def, error) : status;
}
