/* SPDX-License-Identifier: MIT */
/**
 * @file definition_glue.c
 * What JavaScript asks of the definition of a drum (instrument_definition()).
 */
#include <stdlib.h>

#include "glue.h"

/* A number, such as "shell.radius"; 0 if the drum has no such part. */
EXPORT("definition_number")
double web_definition_number(const TaborDrumDef *def, const char *key) {
  char text[TABOR_TEXT_SIZE] = "";
  (void)tabor_drum_def_get(def, key, text, sizeof text, NULL);
  return strtod(text, NULL);
}

/* What a tuner reads at a lug of a head, a TaborHead [Hz]; 0 if the drum has no such head. */
EXPORT("definition_pitch") double web_definition_pitch(const TaborDrumDef *def, uint32_t head) {
  double pitch = 0;
  return tabor_drum_def_pitch(def, head, &pitch, NULL) == TABOR_OK ? pitch : 0;
}

/* The lowest, 0, or highest, 1, pitch that a head can have [Hz], by the tensions that are allowed;
 * 0 if the drum has no such head. */
EXPORT("definition_pitch_limit")
double web_definition_pitch_limit(const TaborDrumDef *def, uint32_t head, uint32_t which) {
  const char *const key = head == TABOR_HEAD_BATTER ? "batter.tension" : "resonant.tension";
  const TaborParameter *const tension = tabor_parameter_find(key);
  TaborDrumDef *const stretched = malloc(sizeof *stretched);
  if (!stretched) return 0;
  *stretched = *def;
  TaborHeadDef *const skin = head == TABOR_HEAD_BATTER ? &stretched->batter : &stretched->resonant;
  skin->pitch = 0;
  skin->tension = which == 0 ? tension->minimum : tension->maximum;
  const double pitch = web_definition_pitch(stretched, head);
  free(stretched);
  return pitch;
}

/* NULL past the last. */
EXPORT("definition_striker")
const char *web_definition_striker(const TaborDrumDef *def, uint32_t index) {
  return index < def->striker_count ? def->striker[index].name : NULL;
}

EXPORT("definition_own_striker") uint32_t web_definition_own_striker(const TaborDrumDef *def) {
  const int striker = tabor_drum_def_find_striker(def, def->strike.striker);
  return striker < 0 ? 0 : (uint32_t)striker;
}
