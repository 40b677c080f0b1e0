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

TbDiscWave *tb_plate_waves(const TaborDrumDef *def, const TbBesselTable *table, uint32_t m,
                           const TbDiscMode *modes, uint32_t mode_count, uint32_t count,
                           const double *r, TbArena *scratch) {
  TbDiscWave *waves = tb_arena_take(scratch, mode_count + 1u, sizeof *waves);
  double *at = tb_arena_doubles(scratch, (size_t)4 * count * (mode_count + 1u));
  if (scratch->failed) return NULL;
  for (uint32_t k = 0; k < mode_count; k++, at += (size_t)4 * count) {
    waves[k] = (TbDiscWave){at, at + count, at + 2u * count, at + 3u * count};
    tb_disc_wave(&modes[k], table, m, def->shell.radius, count, r, &waves[k]);
  }
  return waves;
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

/* Int factor f_k f_l r dr; NULL: 1. */
static double value_product(const TbPlatePoints *points, const double *factor, const TbDiscWave *k,
                            const TbDiscWave *l) {
  double sum = 0.0;
  for (uint32_t i = 0; i < points->count; i++) {
    sum += points->ring[i] * (factor ? factor[i] : 1.0) * k->value[i] * l->value[i];
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

/* One order, with all that its forms are made of. */
typedef struct Order {
  const TaborDrumDef *def;
  const TbPlatePoints *points;
  double azimuth; /* a_m */
  const TbDiscWave *deflections, *stresses;
} Order;

static void fill_deflections(const Order *o, TbPlateForms *forms) {
  const double part = 1.0 - o->def->plate.poisson_ratio;
  for (uint32_t k = 0; k < forms->count; k++) {
    for (uint32_t l = k; l < forms->count; l++) {
      const TbDiscWave *a = &o->deflections[k], *b = &o->deflections[l];
      const size_t at = (size_t)k * forms->count + l;
      forms->mass[at] = o->azimuth * value_product(o->points, o->points->areal, a, b);
      forms->stiffness[at] =
        o->azimuth * curvature_product(o->points, o->points->bending, part, a, b);
    }
  }
  mirror(forms->count, forms->mass);
}

static void fill_stresses(const Order *o, TbPlateForms *forms) {
  const double part = 1.0 + o->def->plate.poisson_ratio;
  const uint32_t n = forms->stress_count;
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t j = i; j < n; j++) {
      const TbDiscWave *a = &o->stresses[i], *b = &o->stresses[j];
      const size_t at = (size_t)i * n + j;
      forms->area[at] = o->azimuth * value_product(o->points, NULL, a, b);
      forms->compliance[at] =
        o->azimuth * curvature_product(o->points, o->points->compliance, part, a, b);
    }
  }
  mirror(n, forms->area);
  mirror(n, forms->compliance);
  for (uint32_t k = 0; k < forms->count; k++) {
    for (uint32_t j = 0; j < n; j++) {
      forms->rise[(size_t)k * n + j] =
        o->azimuth * rise_product(o->points, &o->stresses[j], &o->deflections[k]);
    }
  }
}

/* The upper triangle of K += E^T G^-1 E. */
static TaborStatus add_membrane(TbArena *scratch, TbPlateForms *forms) {
  const uint32_t count = forms->count, n = forms->stress_count;
  double *gram = tb_arena_doubles(scratch, (size_t)n * n + 1u);
  double *solved = tb_arena_doubles(scratch, (size_t)count * n + 1u);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  for (size_t i = 0; i < (size_t)n * n; i++) gram[i] = forms->compliance[i];
  for (size_t i = 0; i < (size_t)count * n; i++) solved[i] = forms->rise[i];
  if (!tb_solve_positive(n, gram, count, solved)) return TABOR_ERROR_NUMERICS;
  for (uint32_t k = 0; k < count; k++) {
    for (uint32_t l = k; l < count; l++) {
      for (uint32_t j = 0; j < n; j++) {
        forms->stiffness[(size_t)k * count + l] +=
          forms->rise[(size_t)k * n + j] * solved[(size_t)l * n + j];
      }
    }
  }
  return TABOR_OK;
}

static bool take_room(TbArena *scratch, TbPlateForms *forms) {
  const size_t count = forms->count, stresses = forms->stress_count;
  forms->mass = tb_arena_doubles(scratch, count * count + 1u);
  forms->stiffness = tb_arena_doubles(scratch, count * count + 1u);
  forms->compliance = tb_arena_doubles(scratch, stresses * stresses + 1u);
  forms->area = tb_arena_doubles(scratch, stresses * stresses + 1u);
  forms->rise = tb_arena_doubles(scratch, count * stresses + 1u);
  return !scratch->failed;
}

TaborStatus tb_plate_forms(const TaborDrumDef *def, const TbPlatePoints *points,
                           const TbBesselTable *table, uint32_t m, double top, double stress_top,
                           uint32_t room, TbArena *scratch, TbPlateForms *forms) {
  forms->modes = tb_arena_take(scratch, room, sizeof *forms->modes);
  forms->stresses = tb_arena_take(scratch, room, sizeof *forms->stresses);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  const double nu = def->plate.poisson_ratio;
  forms->count = tb_disc_modes(TB_DISC_FREE, m, nu, top, forms->modes, room);
  forms->stress_count = tb_disc_modes(TB_DISC_CLAMPED, m, nu, stress_top, forms->stresses, room);
  const Order order = {
    .def = def,
    .points = points,
    .azimuth = m ? PI : 2.0 * PI,
    .deflections =
      tb_plate_waves(def, table, m, forms->modes, forms->count, points->count, points->r, scratch),
    .stresses = tb_plate_waves(def, table, m, forms->stresses, forms->stress_count, points->count,
                               points->r, scratch)};
  if (!take_room(scratch, forms)) return TABOR_ERROR_MEMORY;
  fill_deflections(&order, forms);
  fill_stresses(&order, forms);
  const TaborStatus status =
    tb_plate_is_flat(&def->plate) ? TABOR_OK : add_membrane(scratch, forms);
  mirror(forms->count, forms->stiffness);
  return status;
}
