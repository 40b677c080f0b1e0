/* SPDX-License-Identifier: MIT */
/* The part of a drum's model in the mix of a kit. */
#include <math.h>

#include "kit/kit.h"
#include "math/portable_math.h"
#include "model/model.h"

double tb_kit_factor(double decibels) {
  if (decibels <= -120.0) return 0.0;
  return tb_exp(decibels * 0.11512925464970229); /* ln(10)/20 */
}

static bool same_name(const char *a, const char *b) {
  uint32_t i = 0;
  while (i < TABOR_NAME_SIZE - 1 && a[i] != '\0' && a[i] == b[i]) i++;
  return a[i] == b[i];
}

static uint32_t find_mic(const TaborDrumDef *def, const char *name) {
  for (uint32_t mic = 0; mic < def->mic_count; mic++) {
    if (same_name(def->mic[mic].name, name)) return mic;
  }
  return TB_NO_MIC;
}

void tb_kit_voice_bind(const TaborKit *kit, uint32_t drum) {
  const TaborKitDrumDef *const def = &kit->def.drum[drum];
  TbKitVoice *const voice = &kit->voices[drum];
  const TaborModel *const model = tabor_drum_model(voice->drum);
  voice->model = model;
  voice->left = find_mic(&model->def, TABOR_KIT_LEFT);
  voice->right = find_mic(&model->def, TABOR_KIT_RIGHT);
  voice->air = find_mic(&model->def, TABOR_KIT_AIR);
  voice->close = *def->mic ? find_mic(&model->def, def->mic) : 0;
  if (voice->close == TB_NO_MIC) voice->close = 0; /* of another preset, by a swap */
  voice->full_scale = model->def.full_scale;
  voice->wake = model->def.wires.count > 0 ? def->wake : INFINITY;
}
