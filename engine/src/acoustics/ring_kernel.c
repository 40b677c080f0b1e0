/* SPDX-License-Identifier: MIT */
#include "acoustics/ring_kernel.h"

#include <math.h>

#include "math/portable_math.h"
#include "math/toroidal.h"

static const double PI = 3.14159265358979323846;

/* F_m for m <= orders and E_m for m < orders. */
static void inverse_powers(TbCircle point, TbCircle source, uint32_t orders, double *f, double *e) {
  const double across = point.r - source.r, along = point.z - source.z;
  const double product = point.r * source.r;
  const double gap = fmax(1e-24, (across * across + along * along) / (2.0 * product));
  double q[TB_RING_ORDERS + 1];
  tb_toroidal(gap, orders + 1, q);
  const double chi = 1.0 + gap, root = sqrt(product);
  /* Q'_{m-1/2} = (m - 1/2) (chi Q_{m-1/2} - Q_{m-3/2})/(chi^2 - 1) */
  const double scale = -2.0 / (product * root * gap * (gap + 2.0));
  for (uint32_t m = 0; m < orders; m++) {
    e[m] = scale * ((double)m - 0.5) * (chi * q[m] - q[m ? m - 1 : 1]);
  }
  for (uint32_t m = 0; m <= orders; m++) f[m] = 2.0 * q[m] / root;
}

void tb_ring_still(TbCircle point, TbCircle source, bool radial, uint32_t orders, double *still,
                   double *slow) {
  double f[TB_RING_ORDERS + 1], e[TB_RING_ORDERS];
  inverse_powers(point, source, orders, f, e);
  const double height = source.z - point.z;
  if (!radial) {
    const double size = -source.r * height / (4.0 * PI);
    for (uint32_t m = 0; m < orders; m++) {
      still[m] = size * e[m];
      slow[m] = 0.5 * size * f[m];
    }
    return;
  }
  const double squares = point.r * point.r + source.r * source.r + height * height;
  const double inside = (source.r - point.r) * (source.r + point.r) - height * height;
  for (uint32_t m = 0; m < orders; m++) {
    const double h = squares * f[m] - point.r * source.r * (f[m + 1] + f[m ? m - 1 : 1]);
    still[m] = -(f[m] + inside * e[m]) / (8.0 * PI);
    slow[m] = -(h + inside * f[m]) / (16.0 * PI);
  }
}

void tb_ring_rest(double a, double *re, double *im) {
  const double square = a * a;
  if (square < 0.25) { /* the series, where the differences would cancel */
    *re = a * (-1.0 / 8.0 + square * (1.0 / 144.0 + square * (-1.0 / 5760.0 + square / 403200.0)));
    *im = -1.0 / 3.0 + square * (1.0 / 30.0 + square * (-1.0 / 840.0 + square / 45360.0));
    return;
  }
  double sine, cosine;
  tb_sin_cos(a, &sine, &cosine);
  const double inverse = 1.0 / (square * a);
  *re = (cosine + a * sine - 1.0 - 0.5 * square) * inverse;
  *im = (a * cosine - sine) * inverse;
}
