/* SPDX-License-Identifier: MIT */
/* Kit definitions as text: the list of keys, and the value of each. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "definition/def_key.h"
#include "definition/def_text.h"
#include "definition/error.h"
#include "kit/kit_def.h"
#include "kit/kit_fields.h"

#define KEY_SIZE (4 * TABOR_NAME_SIZE)
#define ROOM_SECTION "room."
#define DRUM_SECTION "drum."

/* ---- keys ------------------------------------------------------------------------------------ */

/* A walk over the keys of a kit; `section` is the one that it is in. */
typedef struct KeyWalk {
  TbKeyVisit *visit;
  void *context;
  char section[sizeof DRUM_SECTION + TABOR_NAME_SIZE];
} KeyWalk;

/* A TbKeyVisit: a key of the section. */
static bool visit_key(void *context, const char *key) {
  const KeyWalk *const walk = context;
  char full[KEY_SIZE];
  (void)snprintf(full, sizeof full, "%s.%.*s", walk->section, TB_DEF_KEY_SIZE, key);
  return walk->visit(walk->context, full);
}

static bool visit_list(KeyWalk *walk, const char *const *keys) {
  while (*keys && visit_key(walk, *keys)) keys++;
  return *keys == NULL;
}

static bool visit_fields(KeyWalk *walk, const TbKitField *fields, uint32_t count) {
  uint32_t i = 0;
  while (i < count && visit_key(walk, fields[i].key)) i++;
  return i == count;
}

static bool visit_strokes(KeyWalk *walk) {
  uint32_t i = 1;
  while (i < TB_KIT_STROKES && visit_key(walk, tb_kit_stroke_word(i))) i++;
  return i == TB_KIT_STROKES;
}

/* A TbKeyVisit: of a drum that carries the room. */
static bool visit_room_key(void *context, const char *key) {
  const KeyWalk *const walk = context;
  const bool is_room = tb_begins(key, ROOM_SECTION);
  return !is_room || walk->visit(walk->context, key);
}

static bool visit_kit(KeyWalk *walk, const TaborKitDef *def) {
  static const char *const texts[] = {"name", "comment", "license", NULL};
  TaborDrumDef carrier;
  tb_kit_carry_room(def, &carrier);
  (void)snprintf(walk->section, sizeof walk->section, "kit");
  return visit_list(walk, texts) && visit_fields(walk, tb_kit_fields, tb_kit_field_count) &&
         tb_def_walk_keys(&carrier, visit_room_key, walk);
}

static bool visit_drum(KeyWalk *walk, const TaborKitDrumDef *drum) {
  static const char *const first[] = {"preset", NULL}, *const last[] = {"choke", "mic", NULL};
  (void)snprintf(walk->section, sizeof walk->section, DRUM_SECTION "%.*s", TABOR_NAME_LENGTH,
                 drum->name);
  return visit_list(walk, first) &&
         visit_fields(walk, tb_kit_drum_fields, tb_kit_drum_field_count) &&
         visit_list(walk, last) && visit_strokes(walk) &&
         tb_def_walk_keys(&drum->def, visit_key, walk);
}

static bool visit_note(KeyWalk *walk, const TaborKitDef *def, uint32_t note) {
  static const char *const keys[] = {"sample", "gain", "choke", NULL};
  if (!def->note[note].sample[0]) return true;
  (void)snprintf(walk->section, sizeof walk->section, "note.%lu", (unsigned long)note);
  return visit_list(walk, keys);
}

bool tb_kit_walk_keys(const TaborKitDef *def, TbKeyVisit *visit, void *context) {
  KeyWalk walk = {.visit = visit, .context = context};
  bool goes_on = visit_kit(&walk, def);
  for (uint32_t i = 0; goes_on && i < def->drum_count && i < TABOR_KIT_DRUMS; i++) {
    goes_on = visit_drum(&walk, &def->drum[i]);
  }
  for (uint32_t note = 0; goes_on && note < TABOR_KIT_NOTES; note++) {
    goes_on = visit_note(&walk, def, note);
  }
  return goes_on;
}

bool tabor_kit_def_key(const TaborKitDef *def, uint32_t index, char *key, size_t size) {
  if (!key || tb_kit_check_struct(def, NULL) != TABOR_OK) return false;
  TbKeySearch search = {.left = index, .key = key, .size = size};
  (void)tb_kit_walk_keys(def, tb_count_key, &search);
  return search.fits;
}

/* ---- values ---------------------------------------------------------------------------------- */

/* The value that is asked for, and where it goes. */
typedef struct Value {
  const char *key;
  char *text;
  size_t size;
  TaborError *error;
} Value;

static TaborStatus refuse_key(const Value *value) {
  return tb_error_set(value->error, TABOR_ERROR_KEY, value->key, NULL, NAN, NAN,
                      "the kit has no key '%s'", value->key);
}

static TaborStatus give(const Value *value, const char *text) {
  if (strlen(text) >= value->size) {
    return tb_error_set(value->error, TABOR_ERROR_ARGUMENT, value->key, NULL, NAN, NAN,
                        "%s: the value does not fit into %zu bytes", value->key, value->size);
  }
  memcpy(value->text, text, strlen(text) + 1);
  return tb_error_clear(value->error);
}

/* A text of a definition, which may lack its terminator. */
static TaborStatus give_text(const Value *value, const char *text, size_t size) {
  if (tb_text_is_valid(text, size)) return give(value, text);
  return tb_error_set(value->error, TABOR_ERROR_VALUE, value->key, NULL, NAN, NAN,
                      "%s: not a line of printable text", value->key);
}

static TaborStatus give_number(const Value *value, double number) {
  char text[TB_NUMBER_SIZE];
  tb_number_print(number, text);
  return give(value, text);
}

/* The field called `name`. */
static TaborStatus give_field(const Value *value, const TbKitField *fields, uint32_t count,
                              const char *name, const void *values) {
  const TbKitField *const field = tb_kit_field_find(fields, count, name);
  return field ? give_number(value, tb_kit_field_value(field, values)) : refuse_key(value);
}

static TaborStatus give_of_kit(const Value *value, const TaborKitDef *def, const char *name) {
  if (strcmp(name, "name") == 0) return give_text(value, def->name, sizeof def->name);
  if (strcmp(name, "comment") == 0) return give_text(value, def->comment, sizeof def->comment);
  if (strcmp(name, "license") == 0) return give_text(value, def->license, sizeof def->license);
  if (strcmp(name, "coupling") == 0 && !def->coupled) return give(value, "off");
  return give_field(value, tb_kit_fields, tb_kit_field_count, name, def);
}

/* A TbKeyVisit. */
static bool has_key(void *def, const char *key) {
  char text[TABOR_TEXT_SIZE];
  return tabor_drum_def_get(def, key, text, sizeof text, NULL) == TABOR_OK;
}

/* A drum may have the name of a preset and lack parts of it. */
static TaborStatus give_preset(const Value *value, const TaborDrumDef *def) {
  TaborDrumDef preset, own = *def;
  const bool is_known = tb_text_is_valid(def->name, sizeof def->name) &&
                        tabor_drum_def_preset(&preset, def->name, NULL) == TABOR_OK &&
                        tb_def_walk_keys(&preset, has_key, &own);
  return give(value, is_known ? def->name : "none");
}

static TaborStatus give_notes(const Value *value, const TaborKitDrumDef *drum, uint32_t stroke) {
  char list[TABOR_KIT_NOTES * 4 + 1] = "";
  size_t used = 0;
  for (unsigned note = 0; note < TABOR_KIT_NOTES; note++) {
    if (drum->notes[note] != stroke) continue;
    used += (size_t)snprintf(list + used, sizeof list - used, "%s%u", used ? "," : "", note);
  }
  return give(value, list);
}

static TaborStatus give_own(const Value *value, const TaborKitDrumDef *drum, const char *name) {
  TaborError own;
  const TaborStatus status = tabor_drum_def_get(&drum->def, name, value->text, value->size, &own);
  if (status == TABOR_OK) return tb_error_clear(value->error);
  return tb_error_set(value->error, status, value->key, own.value, own.minimum, own.maximum,
                      "drum.%s: %s", drum->name, own.message);
}

static TaborStatus give_of_drum(const Value *value, const TaborKitDef *def, const char *key) {
  const size_t length = strcspn(key, ".");
  char name[TABOR_NAME_SIZE] = "";
  if (key[length] == '\0' || length >= sizeof name) return refuse_key(value);
  memcpy(name, key, length);
  const int index = tabor_kit_def_find(def, name);
  if (index < 0) {
    return tb_error_set(value->error, TABOR_ERROR_NAME, value->key, NULL, NAN, NAN,
                        "%s: the kit has no drum '%s'", value->key, name);
  }
  const TaborKitDrumDef *const drum = &def->drum[index];
  const char *const rest = key + length + 1;
  if (strcmp(rest, "preset") == 0) return give_preset(value, &drum->def);
  if (strcmp(rest, "choke") == 0) return give_number(value, drum->choke);
  if (strcmp(rest, "mic") == 0) return give_text(value, drum->mic, sizeof drum->mic);
  for (uint32_t stroke = 1; stroke < TB_KIT_STROKES; stroke++) {
    if (strcmp(rest, tb_kit_stroke_word(stroke)) == 0) return give_notes(value, drum, stroke);
  }
  if (strchr(rest, '.')) return give_own(value, drum, rest);
  return give_field(value, tb_kit_drum_fields, tb_kit_drum_field_count, rest, drum);
}

static TaborStatus give_of_note(const Value *value, const TaborKitDef *def) {
  const char *rest = "";
  const int index = tb_kit_note_parse(value->key, &rest);
  if (index < 0 || *rest != '.') return refuse_key(value);
  const TaborKitNoteDef *const note = &def->note[index];
  if (strcmp(rest, ".sample") == 0) return give_text(value, note->sample, sizeof note->sample);
  if (strcmp(rest, ".choke") == 0) return give_number(value, note->choke);
  return give_field(value, &tb_kit_note_gain, 1, rest + 1, note);
}

static TaborStatus give_of_room(const Value *value, const TaborKitDef *def) {
  TaborDrumDef carrier;
  tb_kit_carry_room(def, &carrier);
  return tabor_drum_def_get(&carrier, value->key, value->text, value->size, value->error);
}

TaborStatus tabor_kit_def_get(const TaborKitDef *def, const char *key, char *text, size_t size,
                              TaborError *error) {
  const Value value = {key, text, size, error};
  const TaborStatus status = tb_kit_check_struct(def, error);
  if (text && size > 0) text[0] = '\0';
  if (status != TABOR_OK) return status;
  if (!key) return tb_error_null(error, "key");
  if (!text) return tb_error_null(error, "text");
  if (tb_begins(key, "kit.")) return give_of_kit(&value, def, key + 4);
  if (tb_begins(key, ROOM_SECTION)) return give_of_room(&value, def);
  if (tb_begins(key, "note.")) return give_of_note(&value, def);
  if (!tb_begins(key, DRUM_SECTION)) return refuse_key(&value);
  return give_of_drum(&value, def, key + strlen(DRUM_SECTION));
}
