/* SPDX-License-Identifier: MIT */
#include "kit/kit_fields.h"

#include <string.h>

#define KIT(field) #field, offsetof(TaborKitDef, field)
#define DRUM(field) #field, offsetof(TaborKitDrumDef, field)

const TbKitField tb_kit_fields[] = {
  {KIT(coupling), -60.0, 24.0, 0.0, "dB"},    {KIT(overheads), -120.0, 24.0, 0.0, "dB"},
  {KIT(full_scale), 1e-3, 1e5, 20.0, "Pa"},   {KIT(overhead_spacing), 0.1, 5.0, 1.0, "m"},
  {KIT(overhead_x), -5.0, 5.0, 0.0, "m"},     {KIT(overhead_y), -5.0, 5.0, 0.0, "m"},
  {KIT(overhead_height), 0.3, 5.0, 1.6, "m"},
};

const TbKitField tb_kit_drum_fields[] = {
  {DRUM(x), -5.0, 5.0, 0.0, "m"},
  {DRUM(y), -5.0, 5.0, 0.0, "m"},
  {DRUM(height), 0.05, 3.0, 0.7, "m"},
  {DRUM(tilt), 0.0, 180.0, 0.0, "deg"},
  {DRUM(facing), -360.0, 360.0, 270.0, "deg"},
  {DRUM(gain), -120.0, 24.0, 0.0, "dB"},
  {DRUM(pan), -1.0, 1.0, 0.0, ""},
  {DRUM(wake), 0.0, 1000.0, 1.0, "Pa"},
};

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

const char *tb_kit_stroke_word(uint32_t stroke) {
  static const char *const WORDS[TB_KIT_STROKES] = {NULL,  "head", "rimshot", "cross-stick",
                                                    "rim", "buzz", "sweep"};
  return stroke < TB_KIT_STROKES ? WORDS[stroke] : NULL;
}
