/* SPDX-License-Identifier: MIT */
#include "heads/cascade.h"

#include <math.h>

#include "math/draw.h"
#include "math/portable_math.h"

static const double LOW_POWER = 1.5, BAND_POWER = 0.6;
static const double LEAST = 1e-14;       /* e_b that passes anything on [J] */
static const double MOST_PASSED = 0.15;  /* of a band's energy at once */
static const double TURNS = 20.0;        /* turns of a mode while its energy comes in once */
static const uint64_t SEED = 0x63617363; /* of the signs */

static double energy_of_list(const TbView *view, const uint32_t *mode, uint32_t count) {
  double sum = 0.0;
  for (uint32_t i = 0; i < count; i++) sum += tb_mode_energy(view, mode[i]);
  return sum > 0.0 ? sum : 0.0;
}

static uint32_t size_of(const TbCascade *cascade, uint32_t band) {
  return cascade->first[band + 1u] - cascade->first[band];
}

/* ---- giving ---------------------------------------------------------------------------------- */

/* The power that passes between bands with the energies `here` and `above` per mode [W]. */
static double passed(double rate, double low, double here, double above) {
  if (here < LEAST || here <= above) return 0.0;
  return rate * tb_power(low, LOW_POWER) / tb_power(here, BAND_POWER) * (here - above);
}

static void scale_band(TbView *view, uint32_t band, double factor) {
  const TbCascade *cascade = &view->model->cascade;
  for (uint32_t i = cascade->first[band]; i < cascade->first[band + 1u]; i++) {
    tb_mode_scale(view, cascade->mode[i], factor);
  }
}

/* ---- taking ---------------------------------------------------------------------------------- */

/* The signs of a band's modes: bit i % 64 of the draw number i/64. */
static bool sign_of(uint64_t *bits, uint64_t draw, uint32_t i) {
  if (i % 64u == 0) *bits = tb_draw_bits(SEED, draw + i / 64u);
  return *bits >> (i % 64u) & 1u;
}

/* Sum u_i (v_i - K'_i k q_i/2). */
static double along(const TbView *view, uint32_t band, uint64_t draw) {
  const TaborModel *model = view->model;
  const TbCascade *cascade = &model->cascade;
  uint64_t bits = 0;
  double sum = 0.0;
  for (uint32_t i = 0; i < size_of(cascade, band); i++) {
    const uint32_t mode = cascade->mode[cascade->first[band] + i];
    const double velocity = (view->now.q[mode] - view->last.q[mode]) * model->step_rate;
    const double moved = view->now.q[mode] - tb_mode_held(view, mode);
    const double c = velocity - 0.5 * model->modes.stiffness[mode] * model->time_step * moved;
    sum += sign_of(&bits, draw, i) ? c : -c;
  }
  return sum;
}

static void kick(TbView *view, uint32_t band, uint64_t draw, double size) {
  const TbCascade *cascade = &view->model->cascade;
  const double step = size * view->model->time_step;
  uint64_t bits = 0;
  for (uint32_t i = 0; i < size_of(cascade, band); i++) {
    const uint32_t mode = cascade->mode[cascade->first[band] + i];
    view->last.q[mode] -= sign_of(&bits, draw, i) ? step : -step;
  }
}

/* `turns`: whether velocities turn back. */
static void take(TbView *view, uint32_t band, double energy, double share) {
  const uint32_t count = size_of(&view->model->cascade, band);
  uint64_t *draws = &view->state->plate.draws;
  const double chance = 0.5 + 0.5 * tb_draw(SEED + 1u, *draws);
  const bool turns = chance < 0.5 * TURNS * count * share;
  const double c = along(view, band, *draws), root = sqrt(c * c + 2.0 * count * energy);
  const double near = c > 0.0 ? 2.0 * energy / (c + root) : -2.0 * energy / (root - c);
  const double far = c > 0.0 ? -(c + root) / count : (root - c) / count;
  kick(view, band, *draws, turns ? far : near);
  *draws += 1u + count / 64u;
}

/* ---- all bands ------------------------------------------------------------------------------- */

bool tb_cascade_acts(const TbView *view) { return view->model->cascade.bands > 1; }

void tb_cascade_pass(TbView *view, uint32_t steps) {
  const TbCascade *cascade = &view->model->cascade;
  const double time = steps * view->model->time_step;
  const double low = energy_of_list(view, cascade->low, cascade->low_count);
  double energy[TB_CASCADE_BANDS], gained[TB_CASCADE_BANDS] = {0.0};
  for (uint32_t b = 0; b < cascade->bands; b++) {
    energy[b] = energy_of_list(view, cascade->mode + cascade->first[b], size_of(cascade, b));
  }
  for (uint32_t b = 0; b + 1u < cascade->bands; b++) {
    const double here = energy[b] / size_of(cascade, b);
    const double above = energy[b + 1u] / size_of(cascade, b + 1u);
    const double most = MOST_PASSED * energy[b];
    const double wanted = time * passed(cascade->rate[b], low, here, above);
    const double given = wanted < most ? wanted : most;
    if (!(given > 0.0)) continue;
    scale_band(view, b, sqrt(1.0 - given / energy[b]));
    gained[b + 1u] = given;
  }
  for (uint32_t b = 1; b < cascade->bands; b++) {
    if (gained[b] > 0.0) take(view, b, gained[b], gained[b] / (energy[b] + gained[b]));
  }
}
