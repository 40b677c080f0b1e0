/* SPDX-License-Identifier: MIT */
#include "math/quadrature.h"

#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

/* Positive nodes of the 16-point rule on (-1, 1) and their weights, [DLMF] table 3.5.4 extended. */
static const double NODE[8] = {0.09501250983763744, 0.28160355077925891, 0.45801677765722739,
                               0.61787624440264375, 0.75540440835500303, 0.86563120238783174,
                               0.94457502307323258, 0.98940093499164993};
static const double WEIGHT[8] = {0.18945061045506850, 0.18260341504492359, 0.16915651939500254,
                                 0.14959598881657673, 0.12462897125553387, 0.09515851168249278,
                                 0.06225352393864789, 0.02715245941175409};

void tb_quadrature(double from, double to, uint32_t panels, double *nodes, double *weights) {
  const double half = 0.5 * (to - from) / (double)panels;
  for (uint32_t p = 0; p < panels; p++) {
    const double middle = from + (2.0 * (double)p + 1.0) * half;
    for (uint32_t i = 0; i < 8; i++) {
      nodes[p * TB_PANEL + 7 - i] = middle - half * NODE[i];
      nodes[p * TB_PANEL + 8 + i] = middle + half * NODE[i];
      weights[p * TB_PANEL + 7 - i] = weights[p * TB_PANEL + 8 + i] = half * WEIGHT[i];
    }
  }
}

/* P_degree(x), and its slope. */
static double legendre(uint32_t degree, double x, double *slope) {
  double before = 1.0, here = x;
  for (uint32_t n = 2; n <= degree; n++) {
    const double next = ((2.0 * n - 1.0) * x * here - (n - 1.0) * before) / n;
    before = here;
    here = next;
  }
  *slope = degree * (before - x * here) / (1.0 - x * x);
  return here;
}

void tb_gauss_rule(uint32_t count, double *nodes, double *weights) {
  for (uint32_t i = 0; i < count; i++) {
    double slope, x = -tb_cos(PI * ((double)i + 0.75) / (count + 0.5));
    for (int pass = 0; pass < 6; pass++) {
      const double value = legendre(count, x, &slope);
      x -= value / slope;
    }
    legendre(count, x, &slope);
    nodes[i] = x;
    weights[i] = 2.0 / ((1.0 - x * x) * slope * slope);
  }
}
