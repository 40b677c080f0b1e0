/* SPDX-License-Identifier: MIT */
#include "bodies/plate/plate_stress.h"

#include <math.h>

#include "bodies/plate/plate_profile.h"
#include "math/eigen.h"
#include "math/quadrature.h"

/* The highest wavenumber of stress, in units of that of the modes. */
static const double STRESS_PER_MODE = 0.5;

/* Gauss's points along the radius: a product of two modes and a function of stress goes through
 * 2.5 lambda radians, of which a point resolves some 5. */
static uint32_t points_for(double lambda) {
  return 16u * (uint32_t)ceil((0.5 * lambda + 3.0) / 16.0);
}

bool tb_plate_stress_begin(const TaborDrumDef *def, double lambda, uint32_t orders, TbArena *arena,
                           TbMembrane *membrane) {
  const uint32_t points = points_for(lambda);
  membrane->r = tb_arena_doubles(arena, points);
  membrane->ring = tb_arena_doubles(arena, points);
  membrane->orders = tb_arena_take(arena, orders, sizeof *membrane->orders);
  if (arena->failed) return false;
  membrane->points = points;
  membrane->order_count = orders;
  tb_gauss_rule(points, membrane->r, membrane->ring);
  for (uint32_t i = 0; i < points; i++) {
    const double half = 0.5 * def->shell.radius;
    membrane->r[i] = half * (1.0 + membrane->r[i]);
    membrane->ring[i] *= half * membrane->r[i];
  }
  return true;
}

double tb_plate_stress_top(double lambda) { return STRESS_PER_MODE * lambda; }

/* The lambda of a function of stress with the compliance mu [m3/N]: near (mu E h)^(1/4) R. */
static double stress_lambda(const TaborDrumDef *def, double mu) {
  const double thickness =
    tb_plate_profile(&def->plate, def->shell.radius, 0.5 * def->shell.radius).thickness;
  return def->shell.radius * sqrt(sqrt(mu * def->plate.youngs_modulus * thickness));
}

/* Sum_k a_k x_k of waves' arrays. */
static void add_scaled(uint32_t points, double a, const double *x, double *sum) {
  for (uint32_t i = 0; i < points; i++) sum[i] += a * x[i];
}

static void fill_curvature(const TbMembrane *membrane, const TbPlateForms *forms,
                           const TbDiscWave *waves, const double *amplitudes,
                           TbMembraneOrder *order) {
  const uint32_t points = membrane->points;
  for (uint32_t k = 0; k < order->modes; k++) {
    double *to = order->curvature + (size_t)3 * points * k;
    for (uint32_t l = 0; l < forms->count; l++) {
      const double a = amplitudes[(size_t)k * forms->count + l];
      add_scaled(points, a, waves[l].radial, to);
      add_scaled(points, a, waves[l].azimuthal, to + points);
      add_scaled(points, a, waves[l].twist, to + 2u * points);
    }
  }
}

/* One function of stress, vector[stress_count], scaled by `unit`. */
static void fill_stress(const TbMembrane *membrane, const TbPlateForms *forms,
                        const TbDiscWave *waves, const double *vector, double unit,
                        const double *amplitudes, TbMembraneOrder *order) {
  const uint32_t n = forms->stress_count, at = order->stresses;
  double *rise = order->rise + (size_t)at * order->modes;
  for (uint32_t i = 0; i < n; i++) {
    add_scaled(membrane->points, unit * vector[i], waves[i].value,
               order->stress + (size_t)at * membrane->points);
    for (uint32_t k = 0; k < order->modes; k++) {
      for (uint32_t l = 0; l < forms->count; l++) {
        rise[k] += unit * vector[i] * forms->rise[(size_t)l * n + i] *
                   amplitudes[(size_t)k * forms->count + l];
      }
    }
  }
}

static TaborStatus fill_stresses(const TaborDrumDef *def, double lambda, const TbMembrane *membrane,
                                 const TbPlateForms *forms, const TbDiscWave *waves,
                                 const double *amplitudes, TbArena *scratch,
                                 TbMembraneOrder *order) {
  const size_t n = forms->stress_count;
  double *compliance = tb_arena_doubles(scratch, n * n + 1u);
  double *area = tb_arena_doubles(scratch, n * n + 1u);
  double *mu = tb_arena_doubles(scratch, n + 1u), *vectors = tb_arena_doubles(scratch, n * n + 1u);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  for (size_t i = 0; i < n * n; i++) {
    compliance[i] = forms->compliance[i];
    area[i] = forms->area[i];
  }
  if (!tb_eigen_symmetric(scratch, (uint32_t)n, compliance, area, mu, vectors)) {
    return scratch->failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
  }
  for (size_t j = 0; j < n && stress_lambda(def, mu[j]) < tb_plate_stress_top(lambda); j++) {
    fill_stress(membrane, forms, waves, vectors + j * n, 1.0 / sqrt(mu[j]), amplitudes, order);
    order->stresses++;
  }
  return TABOR_OK;
}

TaborStatus tb_plate_stress_order(const TaborDrumDef *def, const TbBesselTable *table,
                                  double lambda, uint32_t m, const TbPlateForms *forms,
                                  uint32_t count, const double *amplitudes, TbArena *arena,
                                  TbArena *scratch, TbMembrane *membrane) {
  const size_t n = forms->stress_count, points = membrane->points;
  TbMembraneOrder *order = &membrane->orders[m];
  order->modes = count;
  order->curvature = tb_arena_doubles(arena, 3u * points * count + 1u);
  order->stress = tb_arena_doubles(arena, n * points + 1u);
  order->rise = tb_arena_doubles(arena, n * count + 1u);
  const TbDiscWave *deflections = tb_plate_waves(def, table, m, forms->modes, forms->count,
                                                 membrane->points, membrane->r, scratch);
  const TbDiscWave *stresses = tb_plate_waves(def, table, m, forms->stresses, forms->stress_count,
                                              membrane->points, membrane->r, scratch);
  if (arena->failed || scratch->failed) return TABOR_ERROR_MEMORY;
  fill_curvature(membrane, forms, deflections, amplitudes, order);
  if (n == 0) return TABOR_OK;
  return fill_stresses(def, lambda, membrane, forms, stresses, amplitudes, scratch, order);
}
