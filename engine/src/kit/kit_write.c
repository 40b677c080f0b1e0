/* SPDX-License-Identifier: MIT */
/* Kit definitions as the text of a kit file. */
#include <string.h>

#include "definition/def_text.h"
#include "definition/text_write.h"
#include "kit/kit_def.h"
#include "kit/kit_fields.h"

/* State of the writer. */
typedef struct KitText {
  const TaborKitDef *def;
  uint32_t form;
  TbTextWriter writer;
  char section[4 * TABOR_NAME_SIZE];
  TaborDrumDef base; /* what the section's drum is if nothing of it is written */
} KitText;

/* Bytes of the section in a full key: "kit", "drum.snare" of "drum.snare.batter.tension". */
static size_t section_length(const char *key) {
  const size_t first = strcspn(key, ".");
  const bool is_named = tb_begins(key, "drum.") || tb_begins(key, "note.");
  return is_named ? first + 1 + strcspn(key + first + 1, ".") : first;
}

static bool is_new_section(const KitText *text, const char *key, size_t length) {
  return strlen(text->section) != length || memcmp(text->section, key, length) != 0;
}

static void begin_section(KitText *text, const char *key, size_t length) {
  memcpy(text->section, key, length);
  text->section[length] = '\0';
  tb_text_write_section(&text->writer, key, length);
}

/* The preset of a drum stands first in its section, so that what follows differs from it. */
static const char *begin_drum(KitText *text, const char *preset) {
  if (text->form == TABOR_TEXT_EDIT &&
      tabor_drum_def_preset(&text->base, preset, NULL) == TABOR_OK) {
    return preset;
  }
  tabor_drum_def_clear(&text->base);
  return "none";
}

/* True if the drum has the value `value` of its own key `key` without being told. */
static bool is_of_base(const KitText *text, const char *key, const char *value) {
  char base[TABOR_TEXT_SIZE];
  return text->form == TABOR_TEXT_EDIT &&
         tabor_drum_def_get(&text->base, key, base, sizeof base, NULL) == TABOR_OK &&
         strcmp(base, value) == 0;
}

static const TbKitField *field_of(const char *section, const char *key) {
  if (tb_begins(section, "note.")) return tb_kit_field_find(&tb_kit_note_gain, 1, key);
  if (!tb_begins(section, "drum.")) {
    return tb_kit_field_find(tb_kit_fields, tb_kit_field_count, key);
  }
  return tb_kit_field_find(tb_kit_drum_fields, tb_kit_drum_field_count, key);
}

/* `own` is the key of a parameter within its drum, or NULL. */
static void write_pair(KitText *text, const char *full, const char *own, const char *value) {
  const char *const key = full + strlen(text->section) + 1;
  const TaborParameter *const parameter = own ? tabor_parameter_find(own) : NULL;
  const TbKitField *const field = own ? NULL : field_of(text->section, key);
  const char *unit = NULL, *what = NULL;
  if (parameter) unit = parameter->unit, what = parameter->text;
  if (field) unit = field->unit, what = field->text;
  const bool comments = text->form == TABOR_TEXT_EDIT;
  tb_text_write_pair(&text->writer, full, key, value, comments ? unit : NULL,
                     comments ? what : NULL);
}

static void write_key(KitText *text, const char *full, const char *value) {
  const size_t length = section_length(full);
  const char *const key = full + length + 1;
  const bool is_drum = tb_begins(full, "drum.");
  const bool is_room = tb_begins(full, "room.");
  if (is_new_section(text, full, length)) begin_section(text, full, length);
  if (is_drum && strcmp(key, "preset") == 0) {
    write_pair(text, full, NULL, begin_drum(text, value));
  } else if (is_drum && strchr(key, '.')) {
    if (!is_of_base(text, key, value)) write_pair(text, full, key, value);
  } else if (is_room || *value) {
    write_pair(text, full, is_room ? full : NULL, value);
  }
}

/* A TbKeyVisit. */
static bool visit_key(void *context, const char *key) {
  KitText *const text = context;
  char value[2 * TABOR_TEXT_SIZE];
  TbTextWriter *const writer = &text->writer;
  writer->status = tabor_kit_def_get(text->def, key, value, sizeof value, writer->error);
  if (writer->status == TABOR_OK) write_key(text, key, value);
  return writer->status == TABOR_OK;
}

TaborStatus tabor_kit_def_write(const TaborKitDef *def, uint32_t form, char *text, size_t size,
                                size_t *length, TaborError *error) {
  KitText kit = {.def = def, .form = form};
  kit.writer = tb_text_write_begin(text, size, form, error);
  if (kit.writer.status == TABOR_OK) kit.writer.status = tb_kit_check_struct(def, error);
  if (kit.writer.status == TABOR_OK) (void)tb_kit_walk_keys(def, visit_key, &kit);
  return tb_text_write_end(&kit.writer, length);
}
