/* SPDX-License-Identifier: MIT */
#include "bodies/plate/free_plate.h"

#include <math.h>

#include "math/bessel.h"

/* Roots of one order are some pi apart; a step finds each of them. */
static const double STEP = 0.1;

/* q - m = l I_{m+1}(l)/I_m(l), by Lentz's rule from the far end: some 2 l terms reach rounding. */
static double modified_ratio(uint32_t m, double l) {
  const uint32_t terms = 40u + (uint32_t)(2.0 * l);
  double ratio = 0.0;
  for (uint32_t n = terms; n >= 1; n--) ratio = 1.0 / (2.0 * (m + n) / l + ratio);
  return l * ratio;
}

/* Moment and shear of both functions at the edge, up to common factors. */
typedef struct Edge {
  double j, slope, q;
  double moment_j, moment_i, shear_j, shear_i;
} Edge;

static Edge edge_at(uint32_t m, double poisson_ratio, double l) {
  double j[2];
  tb_bessel_pair(m, l, j); /* J_m, J_{m+1} */
  const double m2 = (double)m * m, l2 = l * l, part = 1.0 - poisson_ratio;
  const double turned = m * j[0] - l * j[1]; /* l J' */
  const double q = m + modified_ratio(m, l);
  return (Edge){.j = j[0],
                .slope = turned / l,
                .q = q,
                .moment_j = l2 * j[0] + part * (turned - m2 * j[0]),
                .moment_i = l2 - part * (q - m2),
                .shear_j = l2 * turned + part * m2 * (turned - j[0]),
                .shear_i = l2 * q - part * m2 * (q - 1.0)};
}

static double residual(uint32_t m, double poisson_ratio, double l) {
  const Edge e = edge_at(m, poisson_ratio, l);
  return e.moment_j * e.shear_i - e.shear_j * e.moment_i;
}

static double bisect(uint32_t m, double poisson_ratio, double lo, double hi) {
  const double sign = residual(m, poisson_ratio, lo);
  for (int i = 0; i < 60; i++) {
    const double middle = 0.5 * (lo + hi);
    if (residual(m, poisson_ratio, middle) * sign > 0.0) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return 0.5 * (lo + hi);
}

static TbFreePlateMode rigid(uint32_t m) {
  return (TbFreePlateMode){.edge = 1.0, .square = 1.0 / (2.0 * m + 2.0)};
}

static TbFreePlateMode bent(uint32_t m, double poisson_ratio, double l) {
  const Edge e = edge_at(m, poisson_ratio, l);
  const double c = e.moment_j / e.moment_i, part = (double)m * m / (l * l);
  return (TbFreePlateMode){.lambda = l,
                           .j = e.j,
                           .slope = e.slope,
                           .c = c,
                           .edge = e.j + c,
                           .square = 0.5 * ((1.0 - part) * e.j * e.j + e.slope * e.slope) +
                                     0.5 * c * c * ((1.0 + part) - e.q * e.q / (l * l)) +
                                     c * (e.j * e.q - l * e.slope) / (l * l)};
}

uint32_t tb_free_plate_modes(uint32_t m, double poisson_ratio, double top, TbFreePlateMode *modes,
                             uint32_t room) {
  uint32_t count = 0;
  if (m < 2 && count < room) modes[count++] = rigid(m);
  double l = m < 2 ? 1.5 : 0.9 * m; /* below every root */
  double before = residual(m, poisson_ratio, l);
  while (l < top && count < room) {
    const double after = residual(m, poisson_ratio, l + STEP);
    const double root = before * after < 0.0 ? bisect(m, poisson_ratio, l, l + STEP) : top;
    if (root < top) modes[count++] = bent(m, poisson_ratio, root);
    before = after;
    l += STEP;
  }
  return count;
}

double tb_free_plate_amplitude(const TbFreePlateMode *mode, double zero, double z_slope) {
  const double l2 = mode->lambda * mode->lambda, z2 = zero * zero;
  if (l2 == 0.0) return 0.0;
  const double apart = zero - mode->lambda;
  /* J_m(l) = -J_m'(z) (z - l) = J_{m+1}(z) (z - l) where l is next to z */
  const double swing =
    fabs(apart) < 1e-7 * zero ? z_slope / (zero + mode->lambda) : mode->j / (z2 - l2);
  return 2.0 * l2 / (zero * z_slope) * (swing - mode->c / (z2 + l2));
}
