/* SPDX-License-Identifier: MIT */
#include "model/resting.h"

#include <math.h>

static const double HEARD = 1e-6; /* of full scale: -120 dB */
static const double FELT = 1e-11; /* [J] */

/* h of resting.h over the square of full scale, of a mode with the weights `ahead` and `behind` and
 * t^2 = `turn`. */
static double heard_at(const TaborDrumDef *def, uint32_t mic, double ahead, double behind,
                       double turn) {
  const double difference = ahead - behind, gain = fmax(def->mic[mic].gain, 1.0);
  const double scale = gain / def->full_scale;
  return scale * scale * (difference * difference + ahead * behind * turn);
}

static double square(double x) { return x * x; }

/* h of `n` modes, by the weights ahead[mic][n] and behind[mic][n]. */
static double *list_heard(TaborModel *model, uint32_t n, const double *stiffness,
                          double *const *ahead, double *const *behind) {
  double *heard = tb_arena_doubles(&model->arena, n);
  for (uint32_t i = 0; heard && i < n; i++) {
    const double turn = stiffness[i] * square(model->time_step);
    for (uint32_t mic = 0; mic < model->def.mic_count; mic++) {
      const double here = heard_at(&model->def, mic, ahead[mic][i], behind[mic][i], turn);
      heard[i] = fmax(heard[i], here);
    }
  }
  return heard;
}

static bool prepare_heard(TaborModel *model) {
  const TbModes *modes = &model->modes;
  const TbHighBand *high = &model->high;
  TbResting *resting = &model->resting;
  double *ahead[TABOR_MAX_MICS], *behind[TABOR_MAX_MICS];
  for (uint32_t mic = 0; mic < model->def.mic_count; mic++) {
    ahead[mic] = model->mics[mic].ahead;
    behind[mic] = model->mics[mic].behind;
  }
  resting->heard = list_heard(model, modes->padded, modes->stiffness, ahead, behind);
  resting->heard_high =
    list_heard(model, high->padded, high->stiffness, high->ringing.ahead, high->ringing.behind);
  if (!resting->heard || !resting->heard_high) return false;
  for (uint32_t i = 0; i < modes->padded; i++) resting->sounds |= resting->heard[i] > 0.0;
  return true;
}

/* ---- modes at rest --------------------------------------------------------------------------- */

static double most_energy(const TaborModel *model, uint32_t mode) {
  const double count = (double)model->modes.count, felt = FELT / count;
  const double heard = model->resting.heard[mode];
  if (model->modes.row[mode] == TB_NO_MODE || heard == 0.0) return felt;
  const double omega = model->body.modes[model->modes.row[mode]].omega;
  const double turn = model->modes.stiffness[mode] * square(model->time_step);
  return fmin(felt, 0.5 * square(omega * HEARD) / (count * turn * heard));
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

/* Modes that are moved not by strikers alone: by wires, by uneven lugs, by a plate's large
 * deflections, by the sound of other drums. */
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
  const TbParts *parts = &model->stretch.parts;
  for (uint32_t i = 0; i < parts->count && model->plate.tables.pairs > 0; i++) {
    if (parts->mixed[i] > 0) raise_floor(model, parts->from[i] + parts->mixed[i] - 1u);
  }
  for (uint32_t i = 0; i < modes->low.count; i++) {
    if (modes->low.end[i] > modes->low.from[i]) raise_floor(model, modes->low.end[i] - 1u);
  }
}

TaborStatus tb_resting_prepare(TaborModel *model) {
  const uint32_t blocks = model->modes.padded / 8u;
  double *most = tb_arena_doubles(&model->arena, blocks);
  if (!most || !prepare_heard(model)) return TABOR_ERROR_MEMORY;
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
