/* SPDX-License-Identifier: MIT */
#include "model/resting.h"

#include <math.h>

#include "math/portable_math.h"

static const double HEARD = 1e-6; /* of full scale: -120 dB */
static const double FELT = 1e-11; /* [J] */

/* Pressure per swing of a mode [1/(m kg^1/2)] at the microphone that hears it best, over its full scale. */
static double loudness(const TaborModel *model, uint32_t mode, double omega) {
  double most = 0.0;
  for (uint32_t i = 0; i < model->def.mic_count; i++) {
    const TbMic *mic = &model->mics[i];
    const double sum = fabs(mic->ahead[mode]) + fabs(mic->behind[mode]);
    most = fmax(most, model->def.mic[i].gain * sum);
  }
  return 2.0 * tb_sin(0.5 * omega * model->time_step) * most / model->def.full_scale;
}

static double most_energy(const TaborModel *model, uint32_t mode) {
  const double count = (double)model->modes.count, felt = FELT / count;
  if (model->modes.row[mode] == TB_NO_MODE) return felt;
  const double omega = model->head.modes[model->modes.row[mode]].omega;
  const double heard = loudness(model, mode, omega);
  const double swing = omega * HEARD / (sqrt(count) * heard);
  return heard > 0.0 ? fmin(felt, 0.5 * swing * swing) : felt;
}

static void raise_floor(TaborModel *model, uint32_t mode) {
  const TbParts *parts = &model->stretch.parts;
  for (uint32_t part = 0; part < parts->count; part++) {
    uint32_t *floor = &model->resting.floor[part];
    const uint32_t at = mode - parts->from[part];
    if (mode >= parts->from[part] && mode < parts->end[part] && at >= *floor)
      *floor = at / 8u * 8u + 8u;
  }
}

/* What is not only moved by strikers: by wires, by uneven lugs, by the sound of other drums. */
static void find_floor(TaborModel *model) {
  const TbModes *modes = &model->modes;
  const TbLugs *lugs = &model->lugs;
  for (uint32_t group = 0; group < modes->groups; group++) {
    if (modes->group[group + 1] > modes->group[group])
      raise_floor(model, modes->group[group + 1] - 1u);
  }
  for (uint32_t group = 0; lugs->count > 0 && group <= modes->groups; group++) {
    if (lugs->size[group] > 0) raise_floor(model, lugs->from[group] + lugs->size[group] - 1u);
  }
  for (uint32_t i = 0; i < modes->low.count; i++) {
    if (modes->low.end[i] > modes->low.from[i]) raise_floor(model, modes->low.end[i] - 1u);
  }
}

TaborStatus tb_resting_prepare(TaborModel *model) {
  const uint32_t blocks = model->modes.padded / 8u;
  double *most = tb_arena_doubles(&model->arena, blocks);
  if (!most) return TABOR_ERROR_MEMORY;
  for (uint32_t block = 0; block < blocks; block++) {
    most[block] = INFINITY;
    for (uint32_t i = 8u * block; i < 8u * block + 8u; i++) {
      most[block] = fmin(most[block], most_energy(model, i));
    }
  }
  model->resting.most = most;
  find_floor(model);
  return TABOR_OK;
}
