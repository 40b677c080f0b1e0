/* SPDX-License-Identifier: MIT */
#include "air_model/ring_kernel.h"

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

/* H_m */
static double mean_distance(TbCircle point, TbCircle source, const double *f, uint32_t m) {
  const double height = source.z - point.z;
  const double squares = point.r * point.r + source.r * source.r + height * height;
  return squares * f[m] - point.r * source.r * (f[m + 1] + f[m ? m - 1 : 1]);
}

void tb_ring_terms(TbCircle point, TbCircle source, bool radial, uint32_t orders,
                   TbRingTerms *terms) {
  double f[TB_RING_ORDERS + 1], e[TB_RING_ORDERS];
  inverse_powers(point, source, orders, f, e);
  const double height = source.z - point.z, size = source.r / (4.0 * PI);
  const double inside = (source.r - point.r) * (source.r + point.r) - height * height;
  for (uint32_t m = 0; m < orders; m++) {
    const double h = mean_distance(point, source, f, m);
    terms[m].single = size * f[m];
    terms[m].single_slow = -0.5 * size * h;
    if (radial) {
      terms[m].dipole = -(f[m] + inside * e[m]) / (8.0 * PI);
      terms[m].dipole_slow = -(h + inside * f[m]) / (16.0 * PI);
    } else {
      terms[m].dipole = -size * height * e[m];
      terms[m].dipole_slow = -0.5 * size * height * f[m];
    }
  }
}

/* The first terms of the series, for arguments at which the differences would cancel. */
static const double SMALL_SQUARE = 0.25;

static inline double small_single_re(double a, double s) {
  return a * s * (1.0 / 24.0 + s * (-1.0 / 720.0 + s / 40320.0));
}

static inline double small_single_im(double s) {
  return -1.0 + s * (1.0 / 6.0 + s * (-1.0 / 120.0 + s / 5040.0));
}

static inline double small_dipole_re(double a, double s) {
  return a * (-1.0 / 8.0 + s * (1.0 / 144.0 + s * (-1.0 / 5760.0 + s / 403200.0)));
}

static inline double small_dipole_im(double s) {
  return -1.0 / 3.0 + s * (1.0 / 30.0 + s * (-1.0 / 840.0 + s / 45360.0));
}

/* Both forms are computed everywhere, so that the loops are vectorised. */
void tb_ring_rests(uint32_t count, const double *a, TbRingRests *rests) {
  double sine[TB_RING_MOST], cosine[TB_RING_MOST];
  tb_sin_cos_array(count, a, sine, cosine);
  for (uint32_t i = 0; i < count; i++) {
    const double square = a[i] * a[i];
    const bool small = square < SMALL_SQUARE;
    const double inverse = 1.0 / (small ? 1.0 : a[i]), cube = inverse * inverse * inverse;
    const double re = (cosine[i] - 1.0 + 0.5 * square) * inverse;
    const double im = -sine[i] * inverse;
    rests->single_re[i] = small ? small_single_re(a[i], square) : re;
    rests->single_im[i] = small ? small_single_im(square) : im;
    const double dipole_re = (cosine[i] + a[i] * sine[i] - 1.0 - 0.5 * square) * cube;
    const double dipole_im = (a[i] * cosine[i] - sine[i]) * cube;
    rests->dipole_re[i] = small ? small_dipole_re(a[i], square) : dipole_re;
    rests->dipole_im[i] = small ? small_dipole_im(square) : dipole_im;
  }
}
