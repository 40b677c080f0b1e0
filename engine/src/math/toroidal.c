/* SPDX-License-Identifier: MIT */
#include "math/toroidal.h"

#include <math.h>

#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

/* The recurrence upwards multiplies rounding errors by e^{2 eta m}, cosh eta = chi. */
static const double MOST_GROWTH = 4.0;

/* Complete elliptic integrals K and E of the parameter k^2 = 1 - complement^2. */
static void elliptic(double complement, double *k, double *e) {
  double a = 1.0, b = complement, power = 0.5;
  double sum = 0.5 * (1.0 - complement * complement);
  for (int i = 0; i < 40 && a - b > 1e-15 * a; i++) {
    const double c = 0.5 * (a - b), mean = 0.5 * (a + b);
    b = sqrt(a * b);
    a = mean;
    power *= 2.0;
    sum += power * c * c;
  }
  *k = 0.5 * PI / a;
  *e = *k * (1.0 - sum);
}

static void upwards(double chi, uint32_t count, double *q) {
  for (uint32_t m = 1; m + 1 < count; m++) {
    const double order = (double)m;
    q[m + 1] = (2.0 * order * chi * q[m] - (order - 0.5) * q[m - 1]) / (order + 0.5);
  }
}

/* From far above, where any ratio will do, down to the ratios q[m]/q[m-1] that are wanted. */
static void downwards(double chi, double eta, uint32_t count, double *q) {
  const uint32_t start = count + 2u + (uint32_t)(17.0 / eta);
  double ratio = 0.0;
  for (uint32_t m = start; m >= 1; m--) {
    const double order = (double)m;
    ratio = (order - 0.5) / (2.0 * order * chi - (order + 0.5) * ratio);
    if (m < count) q[m] = ratio;
  }
  for (uint32_t m = 1; m < count; m++) q[m] *= q[m - 1];
}

void tb_toroidal(double gap, uint32_t count, double *q) {
  const double chi = 1.0 + gap;
  double k, e;
  elliptic(sqrt(gap / (gap + 2.0)), &k, &e);
  q[0] = sqrt(2.0 / (gap + 2.0)) * k;
  const double eta = tb_log(chi + sqrt(gap * (gap + 2.0)));
  if (eta * (double)count < MOST_GROWTH) {
    q[1] = chi * q[0] - sqrt(2.0 * (gap + 2.0)) * e;
    upwards(chi, count, q);
  } else {
    downwards(chi, eta, count, q);
  }
}
