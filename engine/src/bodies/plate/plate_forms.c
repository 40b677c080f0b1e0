/* SPDX-License-Identifier: MIT */
#include "bodies/plate/plate_forms.h"

#include <math.h>

#include "bodies/plate/plate_profile.h"
#include "math/cholesky.h"
#include "math/quadrature.h"

static const double PI = 3.14159265358979323846;

/* ---- places along a radius ------------------------------------------------------------------- */

/* A panel of 16 points holds products of two modes whose lambda x grows by this much in it: half of
 * what Gauss's rule resolves to rounding. */
static const double LAMBDA_PER_PANEL = 7.0;

enum { MOST_PARTS = 3 };

/* Ends of the parts of a radius within which its profile is smooth; returns their number. */
static uint32_t parts_of(const TaborDrumDef *def, double end[MOST_PARTS + 1]) {
  const double radius = def->shell.radius, bell = def->plate.bell_radius;
  const double flange = radius - def->plate.flange_width;
  uint32_t count = 0;
  end[0] = 0.0;
  if (def->plate.bell_height != 0.0 && bell < radius) end[++count] = bell;
  if (def->plate.flange_slope != 0.0 && flange > end[count]) end[++count] = flange;
  end[++count] = radius;
  return count;
}

static uint32_t panels_of(double length, double radius, double top) {
  return 1u + (uint32_t)(top * length / (radius * LAMBDA_PER_PANEL));
}

static void fill_points(const TaborDrumDef *def, TbPlatePoints *points) {
  const TaborPlateDef *plate = &def->plate;
  const double nu = plate->poisson_ratio;
  for (uint32_t i = 0; i < points->count; i++) {
    const double r = points->r[i];
    const TbPlateProfile at = tb_plate_profile(plate, def->shell.radius, r);
    const double h = at.thickness;
    points->ring[i] *= r;
    points->bending[i] = plate->youngs_modulus * h * h * h / (12.0 * (1.0 - nu * nu));
    points->areal[i] = plate->density * h;
    points->compliance[i] = 1.0 / (plate->youngs_modulus * h);
    points->turn[i] = at.slope / r;
    points->bow[i] = at.curvature;
  }
}

bool tb_plate_points(const TaborDrumDef *def, double top, TbArena *arena, TbPlatePoints *points) {
  double end[MOST_PARTS + 1];
  const uint32_t parts = parts_of(def, end);
  uint32_t panels = 0;
  for (uint32_t p = 0; p < parts; p++) panels += panels_of(end[p + 1] - end[p], end[parts], top);
  const uint32_t count = panels * TB_PANEL;
  *points = (TbPlatePoints){.count = count};
  double **arrays[] = {&points->r,          &points->ring, &points->bending, &points->areal,
                       &points->compliance, &points->turn, &points->bow};
  for (uint32_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
    *arrays[i] = tb_arena_doubles(arena, count);
  }
  if (arena->failed) return false;
  uint32_t at = 0;
  for (uint32_t p = 0; p < parts; p++) {
    const uint32_t own = panels_of(end[p + 1] - end[p], end[parts], top);
    tb_quadrature(end[p], end[p + 1], own, points->r + at, points->ring + at);
    at += own * TB_PANEL;
  }
  fill_points(def, points);
  return true;
}

/* ---- forms ----------------------------------------------------------------------------------- */

/* Values of several modes at the points. */
typedef struct Waves {
  uint32_t count;
  TbDiscWave *of;
} Waves;

static bool find_waves(const TaborDrumDef *def, const TbPlatePoints *points, uint32_t m,
                       const TbDiscMode *modes, uint32_t count, TbArena *scratch, Waves *waves) {
  *waves = (Waves){.count = count, .of = tb_arena_take(scratch, count + 1u, sizeof *waves->of)};
  double *values = tb_arena_doubles(scratch, (size_t)4 * points->count * (count + 1u));
  if (scratch->failed) return false;
  for (uint32_t k = 0; k < count; k++) {
    double *at = values + (size_t)4 * points->count * k;
    waves->of[k] = (TbDiscWave){.value = at,
                                .radial = at + points->count,
                                .azimuthal = at + 2u * points->count,
                                .twist = at + 3u * points->count};
    tb_disc_wave(&modes[k], m, def->shell.radius, points->count, points->r, &waves->of[k]);
  }
  return true;
}

/* Int stiffness [(A + B)(A + B) - part (A B + B A - 2 C C)] r dr of two modes. */
static double curvature_product(const TbPlatePoints *points, const double *stiffness, double part,
                                const TbDiscWave *k, const TbDiscWave *l) {
  double sum = 0.0;
  for (uint32_t i = 0; i < points->count; i++) {
    const double whole = (k->radial[i] + k->azimuthal[i]) * (l->radial[i] + l->azimuthal[i]);
    const double gauss = k->radial[i] * l->azimuthal[i] + k->azimuthal[i] * l->radial[i] -
                         2.0 * k->twist[i] * l->twist[i];
    sum += points->ring[i] * stiffness[i] * (whole - part * gauss);
  }
  return sum;
}

/* Int factor f_k f_l r dr. */
static double value_product(const TbPlatePoints *points, const double *factor, const TbDiscWave *k,
                            const TbDiscWave *l) {
  double sum = 0.0;
  for (uint32_t i = 0; i < points->count; i++) {
    sum += points->ring[i] * factor[i] * k->value[i] * l->value[i];
  }
  return sum;
}

/* Int g (w0'' B + (w0'/r) A) r dr. */
static double rise_product(const TbPlatePoints *points, const TbDiscWave *g, const TbDiscWave *k) {
  double sum = 0.0;
  for (uint32_t i = 0; i < points->count; i++) {
    sum += points->ring[i] * g->value[i] *
           (points->bow[i] * k->azimuthal[i] + points->turn[i] * k->radial[i]);
  }
  return sum;
}

/* The upper triangle and, by symmetry, the lower one. */
static void mirror(uint32_t n, double *matrix) {
  for (uint32_t k = 0; k < n; k++) {
    for (uint32_t l = 0; l < k; l++) matrix[(size_t)k * n + l] = matrix[(size_t)l * n + k];
  }
}

/* K += a_m E^T G^-1 E. */
static TaborStatus add_membrane(const TaborDrumDef *def, const TbPlatePoints *points, uint32_t m,
                                double top, const Waves *deflections, TbArena *scratch,
                                double azimuth, double *stiffness) {
  const uint32_t n = deflections->count, room = n + 2u;
  const double part = 1.0 + def->plate.poisson_ratio;
  TbDiscMode *modes = tb_arena_take(scratch, room, sizeof *modes);
  if (!modes) return TABOR_ERROR_MEMORY;
  const uint32_t count = tb_disc_modes(TB_DISC_CLAMPED, m, 0.0, top, modes, room);
  Waves stresses;
  if (!find_waves(def, points, m, modes, count, scratch, &stresses)) return TABOR_ERROR_MEMORY;
  double *gram = tb_arena_doubles(scratch, (size_t)count * count + 1u);
  double *coupling = tb_arena_doubles(scratch, (size_t)n * count + 1u); /* [k][j] */
  double *solved = tb_arena_doubles(scratch, (size_t)n * count + 1u);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  for (uint32_t i = 0; i < count; i++) {
    for (uint32_t j = i; j < count; j++) {
      gram[(size_t)i * count + j] =
        curvature_product(points, points->compliance, part, &stresses.of[i], &stresses.of[j]);
    }
  }
  mirror(count, gram);
  for (uint32_t k = 0; k < n; k++) {
    for (uint32_t j = 0; j < count; j++) {
      const size_t at = (size_t)k * count + j;
      coupling[at] = solved[at] = rise_product(points, &stresses.of[j], &deflections->of[k]);
    }
  }
  if (!tb_solve_positive(count, gram, n, solved)) return TABOR_ERROR_NUMERICS;
  for (uint32_t k = 0; k < n; k++) {
    for (uint32_t l = k; l < n; l++) {
      double sum = 0.0;
      for (uint32_t j = 0; j < count; j++) {
        sum += coupling[(size_t)k * count + j] * solved[(size_t)l * count + j];
      }
      stiffness[(size_t)k * n + l] += azimuth * sum;
    }
  }
  return TABOR_OK;
}

TaborStatus tb_plate_forms(const TaborDrumDef *def, const TbPlatePoints *points, uint32_t m,
                           double top, const TbDiscMode *modes, uint32_t count, TbArena *scratch,
                           double *mass, double *stiffness) {
  const double azimuth = m ? PI : 2.0 * PI, part = 1.0 - def->plate.poisson_ratio;
  Waves waves;
  if (!find_waves(def, points, m, modes, count, scratch, &waves)) return TABOR_ERROR_MEMORY;
  for (uint32_t k = 0; k < count; k++) {
    for (uint32_t l = k; l < count; l++) {
      const TbDiscWave *a = &waves.of[k], *b = &waves.of[l];
      const size_t at = (size_t)k * count + l;
      mass[at] = azimuth * value_product(points, points->areal, a, b);
      stiffness[at] = azimuth * curvature_product(points, points->bending, part, a, b);
    }
  }
  if (!tb_plate_is_flat(&def->plate)) {
    const TaborStatus status =
      add_membrane(def, points, m, top, &waves, scratch, azimuth, stiffness);
    if (status != TABOR_OK) return status;
  }
  mirror(count, mass);
  mirror(count, stiffness);
  return TABOR_OK;
}
