/* SPDX-License-Identifier: MIT */
#include "model/cascade.h"

#include <math.h>

#include "math/portable_math.h"
#include "model/model.h"

static const double PI = 3.14159265358979323846;

/* Fitted to a cymbal of 16 inch all of whose modes up to 10 kHz were coupled, struck at 2, 4 and 8
 * m/s: third octaves then follow within 2.5 to 3.6 dB. Other plates by similarity, in units of
 * their w = sqrt(D/(rho h))/R^2 and D (h/R)^2. */
static const double RATE = 50.0;          /* [J^-0.9/s] */
static const double OWN_W = 24.6;         /* [rad/s] */
static const double OWN_ENERGY = 1.85e-4; /* [J] */
static const double ENERGY_POWER = 0.9;
static const double LOW = 1414.0;  /* [Hz] */
static const double ROLL = 2500.0; /* [Hz] */

/* Bands with fewer modes end the cascade. */
static const uint32_t FEWEST = 4;
static const double THIRD = 1.2599210498948732; /* 2^(1/3) */

/* sqrt(D/(rho h))/R^2 [rad/s] */
static double unit_of(const TaborModel *model) {
  const TaborHeadDef *sheet = &model->body.sheet[0];
  const double radius = model->body.radius;
  return sqrt(sheet->bending_stiffness / sheet->surface_density) / (radius * radius);
}

/* x^a of x > 0. */
static double power(double x, double a) { return tb_exp(a * tb_log(x)); }

/* The frequency of a mode that takes part; else -1 [Hz]. */
static double frequency_of(const TaborModel *model, uint32_t mode) {
  const uint32_t row = model->modes.row[mode];
  if (row == TB_NO_MODE || model->body.modes[row].part != TABOR_PART_PLATE) return -1.0;
  return model->body.modes[row].omega / (2.0 * PI);
}

/* Appends the modes from `from` to `to` [Hz]; returns their number. */
static uint32_t append(const TaborModel *model, double from, double to, uint32_t *mode) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    const double frequency = frequency_of(model, i);
    if (frequency >= from && frequency < to) mode[count++] = i;
  }
  return count;
}

static void list_bands(const TaborModel *model, double top, double rate, double roll,
                       TbCascade *cascade) {
  double from = top / THIRD;
  while (cascade->bands < TB_CASCADE_BANDS) {
    const uint32_t band = cascade->bands, at = cascade->first[band];
    const uint32_t count = append(model, from, from * THIRD, cascade->mode + at);
    if (count < FEWEST) break;
    const double x = from * THIRD / roll, square = x * x;
    cascade->rate[band] = rate / (1.0 + square * square);
    cascade->first[++cascade->bands] = at + count;
    from *= THIRD;
  }
}

TaborStatus tb_cascade_prepare(TaborModel *model) {
  TbCascade *cascade = &model->cascade;
  const double strength = model->def.plate.cascade;
  *cascade = (TbCascade){.bands = 0};
  if (model->plate.tables.pairs == 0 || strength == 0.0) return TABOR_OK;
  cascade->mode = tb_arena_take(&model->arena, model->modes.padded, sizeof *cascade->mode);
  cascade->low = tb_arena_take(&model->arena, model->modes.padded, sizeof *cascade->low);
  if (model->arena.failed) return TABOR_ERROR_MEMORY;
  const double w = unit_of(model) / OWN_W;
  const double rate = RATE * strength * w * power(OWN_ENERGY / model->plate.scale, ENERGY_POWER);
  cascade->low_count = append(model, 20.0, LOW * w, cascade->low);
  list_bands(model, model->body.membrane.top / (2.0 * PI), rate, ROLL * w, cascade);
  return TABOR_OK;
}
