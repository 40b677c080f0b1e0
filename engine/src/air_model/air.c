/* SPDX-License-Identifier: MIT */
#include "air_model/air.h"

#include <math.h>

#include "air_model/wavenumber_quadrature.h"
#include "math/bessel.h"

static const double PI = 3.14159265358979323846;

bool tb_air_order_prepare(TbAirOrder *order, TbArena *arena, uint32_t m, const double *zeros,
                          uint32_t count) {
  *order = (TbAirOrder){.m = m, .count = count, .zeros = zeros};
  const double top = zeros[count - 1];
  order->terms = (uint32_t)fmax(0.0, 0.5 * (top - (double)m)) + 13u;
  order->slopes = tb_arena_doubles(arena, count);
  order->expansion = tb_arena_doubles(arena, (size_t)count * order->terms);
  const uint32_t orders = m + 2u * order->terms;
  double *half = tb_arena_doubles(arena, 8 * (size_t)orders);
  if (arena->failed) return false;
  for (uint32_t i = 0; i < count; i += 8) {
    double x[8];
    for (uint32_t l = 0; l < 8; l++) x[l] = zeros[i + l < count ? i + l : i];
    tb_bessel_half8(x, orders, half);
    for (uint32_t l = 0; l < 8 && i + l < count; l++) {
      order->slopes[i + l] = tb_bessel_j(m + 1, x[l]);
      for (uint32_t n = 0; n < order->terms; n++) {
        order->expansion[(i + l) * order->terms + n] =
          half[8 * (m + 2 * n + 1) + l] / (x[l] * sqrt(x[l]));
      }
    }
  }
  return true;
}

/* W_i at every node, [count][nodes]; NULL if memory ran out. */
static double *transforms(const TbAirOrder *order, TbArena *scratch,
                          const TbWavenumberNodes *nodes) {
  double *w = tb_arena_doubles(scratch, (size_t)order->count * nodes->count);
  for (uint32_t i = 0; w && i < order->count; i++) {
    for (uint32_t q = 0; q < nodes->count; q++) {
      w[(size_t)i * nodes->count + q] =
        tb_air_hankel(order->m, order->zeros[i], order->slopes[i], nodes->kappa[q], nodes->j[q]);
    }
  }
  return w;
}

/* Int_0^inf W_i W_j dkappa. W falls like kappa^-5/2; beyond the last node J_m^2 counts as its mean
 * 1/(pi kappa), which leaves an error below 1e-8 of the diagonal. */
bool tb_air_mass_baffled(const TbAirOrder *order, TbArena *scratch, double *mass) {
  const uint32_t n = order->count;
  const double top = fmax(200.0, 6.0 * order->zeros[n - 1]);
  const TbAirTurns turns = {.high = 2.0, .top = top, .panel = 4.0 * PI};
  TbWavenumberNodes nodes;
  if (!tb_wavenumber_nodes_prepare(&nodes, scratch, order, 0.0, turns)) return false;
  double *w = transforms(order, scratch, &nodes);
  if (!w) return false;
  for (uint32_t a = 0; a < n; a++) {
    for (uint32_t b = a; b < n; b++) {
      const double *wa = w + (size_t)a * nodes.count, *wb = w + (size_t)b * nodes.count;
      double sum = order->zeros[a] * order->slopes[a] * order->zeros[b] * order->slopes[b] /
                   (4.0 * PI * top * top * top * top);
      for (uint32_t q = 0; q < nodes.count; q++) sum += nodes.weights[q] * wa[q] * wb[q];
      mass[a * n + b] = mass[b * n + a] = sum;
    }
  }
  return true;
}

void tb_air_mass_open(const TbAirOrder *order, double *mass) {
  const uint32_t n = order->count;
  for (uint32_t a = 0; a < n; a++) {
    for (uint32_t b = a; b < n; b++) {
      const double *ea = order->expansion + a * order->terms;
      const double *eb = order->expansion + b * order->terms;
      double sum = 0.0;
      for (uint32_t t = 0; t < order->terms; t++) {
        sum += 4.0 * ((double)order->m + 2.0 * t + 1.5) * ea[t] * eb[t];
      }
      mass[a * n + b] = mass[b * n + a] = sum;
    }
  }
}

bool tb_air_resistance_baffled(const TbAirOrder *order, TbArena *scratch, double x,
                               double *resistance) {
  const uint32_t n = order->count;
  const TbAirTurns turns = {.low = 2.0 * x, .panel = 4.0 * PI};
  TbWavenumberNodes nodes;
  if (!tb_wavenumber_nodes_prepare(&nodes, scratch, order, x, turns)) return false;
  const double *w = transforms(order, scratch, &nodes);
  if (!w) return false;
  for (uint32_t a = 0; a < n; a++) {
    for (uint32_t b = a; b < n; b++) {
      double sum = 0.0;
      for (uint32_t q = 0; q < nodes.below; q++) {
        sum += nodes.weights[q] * nodes.kappa[q] * w[a * nodes.count + q] * w[b * nodes.count + q];
      }
      resistance[a * n + b] = resistance[b * n + a] = sum;
    }
  }
  return true;
}
