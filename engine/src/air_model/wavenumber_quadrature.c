/* SPDX-License-Identifier: MIT */
#include "air_model/wavenumber_quadrature.h"

#include <math.h>

#include "math/bessel.h"
#include "math/portable_math.h"
#include "math/quadrature.h"

static const double PI = 3.14159265358979323846;

static uint32_t panels_for(double turns, double panel) { return 1u + (uint32_t)(turns / panel); }

bool tb_wavenumber_nodes_prepare(TbWavenumberNodes *nodes, TbArena *scratch,
                                 const TbAirOrder *order, double x, TbAirTurns turns) {
  const uint32_t low = x > 0.0 ? panels_for(turns.low, turns.panel) : 0u;
  const uint32_t high = turns.top > 0.0 ? panels_for(turns.top * turns.high, turns.panel) + 2u : 0u;
  *nodes = (TbWavenumberNodes){.x = x, .below = low * TB_PANEL, .count = (low + high) * TB_PANEL};
  if (high) nodes->panel = turns.top / (double)high;
  double **arrays[] = {&nodes->kappa, &nodes->root, &nodes->weights, &nodes->j};
  for (int i = 0; i < 4; i++) *arrays[i] = tb_arena_doubles(scratch, nodes->count);
  if (scratch->failed) return false;

  if (low) tb_quadrature(0.0, 0.5 * PI, low, nodes->j, nodes->weights);
  tb_sin_cos_array(nodes->below, nodes->j, nodes->kappa, nodes->root);
  for (uint32_t q = 0; q < nodes->below; q++) {
    nodes->kappa[q] *= x;
    nodes->root[q] *= x;
    nodes->weights[q] *= x;
  }
  if (high) {
    tb_quadrature(0.0, turns.top, high, nodes->kappa + nodes->below, nodes->weights + nodes->below);
  }
  for (uint32_t q = nodes->below; q < nodes->count; q++) {
    const double t = nodes->kappa[q];
    nodes->root[q] = t;
    nodes->kappa[q] = sqrt(x * x + t * t);
  }
  tb_bessel_table_values(order->table, order->m, nodes->count, 1.0, nodes->kappa, nodes->j);
  return true;
}

/* So near to a zero the quotient is taken from the series of J_m about it. */
static const double NEAR_ZERO = 3e-3;

/* With d = kappa - z, J'' and J''' from Bessel's equation:
 * J = slope (-d + d^2/(2 z) + (1 - (m^2 + 2)/z^2) d^3/6). */
static double hankel_near(uint32_t m, double z, double slope, double kappa) {
  const double d = kappa - z, bend = 1.0 - ((double)m * m + 2.0) / (z * z);
  return z * slope * slope * (1.0 - d / (2.0 * z) - bend * d * d / 6.0) / (kappa + z);
}

double tb_air_hankel(uint32_t m, double z, double slope, double kappa, double j) {
  if (fabs(kappa - z) < NEAR_ZERO) return hankel_near(m, z, slope, kappa);
  return z * slope * j / ((z - kappa) * (z + kappa));
}

void tb_air_transform(const TbAirOrder *order, const TbWavenumberNodes *nodes, const double *v,
                      double *w) {
  const uint32_t count = nodes->count;
  const double *restrict kappa = nodes->kappa;
  double largest = 0.0;
  for (uint32_t i = 0; i < order->count; i++) largest = fmax(largest, fabs(v[i]));
  for (uint32_t q = 0; q < count; q++) w[q] = 0.0;
  for (uint32_t i = 0; i < order->count; i++) {
    const double z = order->zeros[i], size = v[i] * z * order->slopes[i];
    if (fabs(v[i]) < 1e-13 * largest) continue;
    for (uint32_t q = 0; q < count; q++) {
      const double below = z - kappa[q];
      const double gap = fabs(below) < NEAR_ZERO ? 1.0 : below;
      w[q] += fabs(below) < NEAR_ZERO ? 0.0 : size / (gap * (z + kappa[q]));
    }
  }
  for (uint32_t q = 0; q < count; q++) w[q] *= nodes->j[q];
  for (uint32_t i = 0; i < order->count; i++) {
    const double z = order->zeros[i];
    for (uint32_t q = 0; q < count; q++) {
      if (fabs(z - kappa[q]) >= NEAR_ZERO) continue;
      w[q] += v[i] * hankel_near(order->m, z, order->slopes[i], kappa[q]);
    }
  }
}

bool tb_air_half_orders(uint32_t m, uint32_t terms, TbArena *scratch,
                        const TbWavenumberNodes *nodes, double *rows) {
  double *half = tb_arena_doubles(scratch, 8 * (size_t)(m + 2 * terms));
  if (!half) return false;
  for (uint32_t q = 0; q < nodes->count; q += 8) {
    double top = 0.0;
    for (uint32_t l = 0; l < 8; l++) top = fmax(top, nodes->kappa[q + l]);
    const uint32_t reach = tb_bessel_reach(top);
    uint32_t here = reach > m ? (reach - m) / 2 + 1 : 0; /* beyond, they are nothing */
    if (here > terms) here = terms;
    if (here) tb_bessel_half8(nodes->kappa + q, m + 2 * here, half);
    for (uint32_t l = 0; l < 8; l++) {
      double *row = rows + (size_t)(q + l) * terms;
      for (uint32_t n = 0; n < here; n++) row[n] = half[8 * (m + 2 * n + 1) + l];
      for (uint32_t n = here; n < terms; n++) row[n] = 0.0;
    }
  }
  return true;
}

void tb_air_jump_transform(const TbWavenumberNodes *nodes, uint32_t terms, const double *rows,
                           const double *a, double *p) {
  for (uint32_t q = 0; q < nodes->count; q++) {
    const double factor = 1.0 / (nodes->kappa[q] * sqrt(nodes->kappa[q]));
    const double *row = rows + (size_t)q * terms;
    double re = 0.0, im = 0.0;
    for (uint32_t n = 0; n < terms; n++) {
      re += a[2 * n] * row[n];
      im += a[2 * n + 1] * row[n];
    }
    p[2 * q] = factor * re;
    p[2 * q + 1] = factor * im;
  }
}
