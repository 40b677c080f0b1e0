/* SPDX-License-Identifier: MIT */
/* The numbers of a kit definition: keys, ranges and defaults, for reading and for checks. */
#ifndef TB_KIT_FIELDS_H
#define TB_KIT_FIELDS_H

#include "tabor/kit.h"

typedef struct TbKitField {
  const char *key;
  size_t offset; /* of a double in TaborKitDef, TaborKitDrumDef or TaborKitNoteDef */
  double minimum, maximum, fallback;
  const char *unit, *text; /* text: description, for comments */
} TbKitField;

extern const TbKitField tb_kit_fields[];      /* of [kit] */
extern const TbKitField tb_kit_drum_fields[]; /* of [drum.NAME] */
extern const TbKitField tb_kit_note_gain;     /* of [note.N] */
extern const uint32_t tb_kit_field_count, tb_kit_drum_field_count;

#define TB_KIT_MOST_CHOKE 15u

/* The field called `key`, or NULL. */
const TbKitField *tb_kit_field_find(const TbKitField *fields, uint32_t count, const char *key);
/* Its value in a definition, or in a drum of it. */
double *tb_kit_field_at(const TbKitField *field, void *fields);
double tb_kit_field_value(const TbKitField *field, const void *fields);

/* Words of strokes by TaborKitStroke; NULL for none. */
const char *tb_kit_stroke_word(uint32_t stroke);
#define TB_KIT_STROKES 13u

/* The note of a section "note.N" or of a key in it, whose rest *rest points to; -1: it is none. */
int tb_kit_note_parse(const char *text, const char **rest);

#endif
