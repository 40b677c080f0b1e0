/* SPDX-License-Identifier: MIT */
#include "math/modified_bessel.h"

#include <math.h>

/* I_l falls like exp(-l^2/(2 x)) and, beyond x, faster: by 1e-17 from order m to here. */
static uint32_t start_above(uint32_t m, double x) {
  return (uint32_t)sqrt((double)m * m + 80.0 * x) + 24u;
}

void tb_modified_bessel_pair(uint32_t m, double x, double i[2]) {
  const double twice_inverse = 2.0 / x;
  double above = 0.0, here = 1e-250, sum = 0.0;
  i[0] = i[1] = 0.0;
  for (uint32_t l = start_above(m + 1, x); l > 0; l--) {
    sum += here;
    const double next = (double)l * twice_inverse * here + above;
    above = here;
    here = next;
    if (l - 1 == m) {
      i[0] = here;
      i[1] = above;
    }
    if (here > 1e100) {
      above *= 1e-150;
      here *= 1e-150;
      sum *= 1e-150;
      i[0] *= 1e-150;
      i[1] *= 1e-150;
    }
  }
  const double whole = here + 2.0 * sum; /* exp(x) */
  i[0] /= whole;
  i[1] /= whole;
}
