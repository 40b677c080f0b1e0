/* SPDX-License-Identifier: MIT */
#include "bodies/plate/disc_modes.h"

#include <math.h>
#include <stdbool.h>

#include "math/bessel.h"
#include "math/modified_bessel.h"
#include "math/portable_math.h"

/* Roots of one order are some pi apart, and 2 at least; a step finds each of them. */
static const double STEP = 0.5;

/* q - m = l I_{m+1}(l)/I_m(l), by Lentz's rule from the far end: some 2 l terms reach rounding. */
static double modified_ratio(uint32_t m, double l) {
  const uint32_t terms = 40u + (uint32_t)(2.0 * l);
  double ratio = 0.0;
  for (uint32_t n = terms; n >= 1; n--) ratio = 1.0 / (2.0 * (m + n) / l + ratio);
  return l * ratio;
}

/* Moment and shear of both functions at the edge, up to common factors. */
typedef struct Edge {
  double j, turned, q; /* J, l J', l I'/I */
  double moment_j, moment_i, shear_j, shear_i;
} Edge;

static Edge edge_at(uint32_t m, double poisson_ratio, double l) {
  double j[2];
  tb_bessel_pair(m, l, j); /* J_m, J_{m+1} */
  const double m2 = (double)m * m, l2 = l * l, part = 1.0 - poisson_ratio;
  const double turned = m * j[0] - l * j[1];
  const double q = m + modified_ratio(m, l);
  return (Edge){.j = j[0],
                .turned = turned,
                .q = q,
                .moment_j = l2 * j[0] + part * (turned - m2 * j[0]),
                .moment_i = l2 - part * (q - m2),
                .shear_j = l2 * turned + part * m2 * (turned - j[0]),
                .shear_i = l2 * q - part * m2 * (q - 1.0)};
}

/* The modes of one order. */
typedef struct Family {
  TbDiscEdge edge;
  uint32_t m;
  double poisson_ratio;
} Family;

static double residual(const Family *f, double l) {
  const Edge e = edge_at(f->m, f->poisson_ratio, l);
  if (f->edge == TB_DISC_CLAMPED) return e.turned - e.q * e.j;
  return e.moment_j * e.shear_i - e.shear_j * e.moment_i;
}

/* The root between lo and hi, by the Illinois variant of the rule of false position: some ten steps
 * reach rounding. */
static double root_between(const Family *f, double lo, double hi) {
  double at_lo = residual(f, lo), at_hi = residual(f, hi);
  for (int i = 0; i < 60 && at_hi != 0.0; i++) {
    const double next = hi - at_hi * (hi - lo) / (at_hi - at_lo), at_next = residual(f, next);
    const bool done = fabs(next - hi) < 1e-15 * hi;
    if (at_next * at_hi < 0.0) {
      lo = hi;
      at_lo = at_hi;
    } else {
      at_lo *= 0.5;
    }
    hi = next;
    at_hi = at_next;
    if (done) break;
  }
  return hi;
}

static TbDiscMode bent(const Family *f, double l) {
  const Edge e = edge_at(f->m, f->poisson_ratio, l);
  const bool clamped = f->edge == TB_DISC_CLAMPED;
  const double c = clamped ? -e.j : e.moment_j / e.moment_i;
  return (TbDiscMode){.lambda = l, .j = e.j, .c = c, .edge = clamped ? 0.0 : e.j + c};
}

uint32_t tb_disc_modes(TbDiscEdge edge, uint32_t m, double poisson_ratio, double top,
                       TbDiscMode *modes, uint32_t room) {
  const Family f = {edge, m, poisson_ratio};
  const bool moves_rigidly = edge == TB_DISC_FREE && m < 2;
  uint32_t count = 0;
  if (moves_rigidly && count < room) modes[count++] = (TbDiscMode){.edge = 1.0};
  double l = m < 2 ? 1.5 : 0.9 * m; /* below every root */
  double before = residual(&f, l);
  while (l < top && count < room) {
    const double after = residual(&f, l + STEP);
    const double root = before * after < 0.0 ? root_between(&f, l, l + STEP) : top;
    if (root < top) modes[count++] = bent(&f, root);
    before = after;
    l += STEP;
  }
  return count;
}

double tb_disc_amplitude(const TbDiscMode *mode, double zero, double z_slope) {
  const double l2 = mode->lambda * mode->lambda, z2 = zero * zero;
  if (l2 == 0.0) return 0.0;
  const double apart = zero - mode->lambda;
  /* J_m(l) = -J_m'(z) (z - l) = J_{m+1}(z) (z - l) where l is next to z */
  const double swing =
    fabs(apart) < 1e-7 * zero ? z_slope / (zero + mode->lambda) : mode->j / (z2 - l2);
  return 2.0 * l2 / (zero * z_slope) * (swing - mode->c / (z2 + l2));
}

static void rigid_wave(uint32_t m, double radius, uint32_t count, const double *r,
                       const TbDiscWave *wave) {
  for (uint32_t i = 0; i < count; i++) {
    wave->value[i] = m == 0 ? 1.0 : r[i] / radius;
    wave->radial[i] = wave->azimuthal[i] = wave->twist[i] = 0.0;
  }
}

/* With w = J + I, both solve Bessel's equation: w_rr + w_r/r - m^2 w/r^2 = (l/R)^2 (I - J). */
void tb_disc_wave(const TbDiscMode *mode, const TbBesselTable *table, uint32_t m, double radius,
                  uint32_t count, const double *r, const TbDiscWave *wave) {
  const double l = mode->lambda, k = l / radius;
  if (l == 0.0) {
    rigid_wave(m, radius, count, r, wave);
    return;
  }
  double at_edge[2];
  tb_modified_bessel_pair(m, l, at_edge);
  for (uint32_t i = 0; i < count; i++) {
    double j[2], modified[2];
    if (table && m + 1u < table->orders) {
      j[0] = tb_bessel_table_value(table, m, k * r[i]);
      j[1] = tb_bessel_table_value(table, m + 1u, k * r[i]);
    } else {
      tb_bessel_pair(m, k * r[i], j);
    }
    tb_modified_bessel_pair(m, k * r[i], modified);
    const double scale = mode->c / at_edge[0] * tb_exp(k * r[i] - l);
    const double swing = j[0], bow = scale * modified[0];
    const double value = swing + bow;
    const double slope_over_r =
      (m * value / r[i] + k * (scale * modified[1] - j[1])) / r[i]; /* w_r/r */
    const double value_over_r2 = value / (r[i] * r[i]);
    wave->value[i] = value;
    wave->azimuthal[i] = slope_over_r - (double)m * m * value_over_r2;
    wave->twist[i] = m * (slope_over_r - value_over_r2);
    wave->radial[i] = k * k * (bow - swing) - wave->azimuthal[i];
  }
}
