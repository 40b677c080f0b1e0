/* SPDX-License-Identifier: MIT */
#include "model/radiated_power.h"

#include <math.h>

#include "math/portable_math.h"
#include "model/mics.h"
#include "model/model.h"

static const TbBodyMode *far_mode(const TaborModel *model, uint32_t i) {
  const uint32_t row = model->modes.row[i];
  return row != TB_NO_MODE && model->body.modes[row].has_far ? &model->body.modes[row] : NULL;
}

static uint32_t group_of(const TbBodyMode *mode, bool sine) {
  return mode->m == 0 ? 0 : 2 * mode->m - 1 + sine;
}

/* The weights of sqrt(energy) in each direction. */
static void weigh(const TaborModel *model, const TbBodyMode *mode, double *ahead, double *behind) {
  const TbPole pole = tb_pole(mode->omega, mode->decay_rate, model->time_step);
  const double radius = model->body.radius, turn = mode->omega * model->time_step;
  double shares[TB_FAR_NODES];
  tb_far_shares(&model->def.air, mode->m, shares);
  for (uint32_t i = 0; i < TB_FAR_NODES; i++) {
    const double size = -mode->omega * mode->omega * model->def.air.density * radius * radius *
                        sqrt(shares[i] * TB_FAR_STEPS * model->time_step);
    tb_pressure_weights(turn, &pole, size, mode->far + 2 * i, 0.0, &ahead[i], &behind[i]);
  }
}

TaborStatus tb_radiated_power_prepare(TaborModel *model) {
  TbRadiatedPower *power = &model->power;
  uint32_t count = 0, next = 0;
  for (uint32_t i = 0; i < model->modes.padded; i++) count += far_mode(model, i) != NULL;
  power->mode = tb_arena_take(&model->arena, count + 1u, sizeof *power->mode);
  power->loss = tb_arena_doubles(&model->arena, count + 1u);
  power->ahead = tb_arena_doubles(&model->arena, (count + 1u) * TB_FAR_NODES);
  power->behind = tb_arena_doubles(&model->arena, (count + 1u) * TB_FAR_NODES);
  if (model->arena.failed) return TABOR_ERROR_MEMORY;
  for (uint32_t group = 0; group < TB_FAR_GROUPS; group++) {
    power->group[group] = next;
    for (uint32_t i = 0; i < model->modes.padded; i++) {
      const TbBodyMode *mode = far_mode(model, i);
      if (!mode || group_of(mode, model->modes.sine[i]) != group) continue;
      const size_t at = (size_t)next * TB_FAR_NODES;
      weigh(model, mode, power->ahead + at, power->behind + at);
      power->loss[next] = TB_FAR_STEPS * model->modes.loss_air[i];
      power->mode[next++] = i;
    }
  }
  power->group[TB_FAR_GROUPS] = next;
  return TABOR_OK;
}
