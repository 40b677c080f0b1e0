/* SPDX-License-Identifier: MIT */
#include "kit/kit_fields.h"

#include <string.h>

#include "definition/def_text.h"

#define KIT(field) #field, offsetof(TaborKitDef, field)
#define DRUM(field) #field, offsetof(TaborKitDrumDef, field)
#define NOTE(field) #field, offsetof(TaborKitNoteDef, field)

const TbKitField tb_kit_fields[] = {
  {KIT(coupling), -60.0, 24.0, 0.0, "dB", "how loud drums hear each other, beside physics, or off"},
  {KIT(overheads), -120.0, 24.0, 0.0, "dB", "the overheads in the mix"},
  {KIT(full_scale), 1e-3, 1e5, 20.0, "Pa", "pressure at the overheads that gives 1.0"},
  {KIT(overhead_spacing), 0.1, 5.0, 1.0, "m", "between the overheads"},
  {KIT(overhead_x), -5.0, 5.0, 0.0, "m", "their middle, to the player's right"},
  {KIT(overhead_y), -5.0, 5.0, 0.0, "m", "away from the player"},
  {KIT(overhead_height), 0.3, 5.0, 1.6, "m", "above the floor"},
};

const TbKitField tb_kit_drum_fields[] = {
  {DRUM(x), -5.0, 5.0, 0.0, "m", "its place, to the player's right"},
  {DRUM(y), -5.0, 5.0, 0.0, "m", "away from the player"},
  {DRUM(height), 0.05, 3.0, 0.7, "m", "of the batter head above the floor"},
  {DRUM(tilt), 0.0, 180.0, 0.0, "deg", "of its axis; 0 looks up, 90 to the side"},
  {DRUM(facing), -360.0, 360.0, 270.0, "deg", "where a tilted head looks; 270 to the player"},
  {DRUM(gain), -120.0, 24.0, 0.0, "dB", "its close microphone in the mix"},
  {DRUM(pan), -1.0, 1.0, 0.0, "", "of it, left to right"},
  {DRUM(wake), 0.0, 1000.0, 1.0, "Pa", "sound of others that wakes it if it has wires"},
};

const TbKitField tb_kit_note_gain = {NOTE(gain), -120.0, 24.0, 0.0, "dB", "of the sound file"};

const uint32_t tb_kit_field_count = sizeof tb_kit_fields / sizeof *tb_kit_fields;
const uint32_t tb_kit_drum_field_count = sizeof tb_kit_drum_fields / sizeof *tb_kit_drum_fields;

const TbKitField *tb_kit_field_find(const TbKitField *fields, uint32_t count, const char *key) {
  for (uint32_t i = 0; i < count; i++) {
    if (strcmp(fields[i].key, key) == 0) return &fields[i];
  }
  return NULL;
}

double *tb_kit_field_at(const TbKitField *field, void *fields) {
  return (double *)(void *)((char *)fields + field->offset);
}

double tb_kit_field_value(const TbKitField *field, const void *fields) {
  double value;
  memcpy(&value, (const char *)fields + field->offset, sizeof value);
  return value;
}

const char *tb_kit_stroke_word(uint32_t stroke) {
  static const char *const WORDS[TB_KIT_STROKES] = {
    NULL,   "head", "rimshot", "cross-stick", "rim",  "buzz", "sweep",
    "bell", "bow",  "edge",    "closed",      "open", "pedal"};
  return stroke < TB_KIT_STROKES ? WORDS[stroke] : NULL;
}

int tb_kit_note_parse(const char *text, const char **rest) {
  static const char prefix[] = "note.";
  char digits[4] = "";
  uint32_t note;
  if (!tb_begins(text, prefix)) return -1;
  const char *const start = text + sizeof prefix - 1;
  const size_t length = strspn(start, "0123456789");
  if (length == 0 || length >= sizeof digits) return -1;
  memcpy(digits, start, length);
  *rest = start + length;
  return tb_whole_parse(digits, &note) == TB_PARSE_OK && note < TABOR_KIT_NOTES ? (int)note : -1;
}
