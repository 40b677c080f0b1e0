/* SPDX-License-Identifier: MIT */
#include "math/bessel.h"

#include <math.h>
#include <stdbool.h>

#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

/* Cube root from above, without libm: for the width of the transition region around order = x. */
static double cube_root_above(double x) {
  double y = 1.0;
  while (y * y * y < x) y *= 1.25;
  return y;
}

/* Beyond the turning point J_l falls like exp(-(2/3) (2/x)^(1/2) (l - x)^(3/2)) at first, then
 * faster: below 1e-17 here. */
static double beyond_turn(double x) { return x + 14.0 * cube_root_above(x) + 10.0; }

uint32_t tb_bessel_reach(double x) { return (uint32_t)beyond_turn(x); }

/* An even order from which the recurrence has forgotten its start at orders <= m to 1e-17. */
static uint32_t miller_start(uint32_t m, double x) {
  const double turn = beyond_turn(x);
  const double top = turn > (double)m + 2.0 ? turn : (double)m + 2.0;
  return 2u * ((uint32_t)(top / 2.0) + 6u);
}

static double magnitude(double x) { return x < 0.0 ? -x : x; }

/* The lane with the smallest argument grows fastest on the way down: it tells when to rescale. */
static uint32_t fastest_lane(const double x[8]) {
  uint32_t fastest = 0;
  for (uint32_t i = 1; i < 8; i++) {
    if (x[i] > 1e-30 && (x[i] < x[fastest] || x[fastest] <= 1e-30)) fastest = i;
  }
  return fastest;
}

void tb_bessel_j8(const uint32_t m[8], const double x[8], double j[8]) {
  double top = 0.0;
  uint32_t highest = 0;
  for (int i = 0; i < 8; i++) {
    top = x[i] > top ? x[i] : top;
    highest = m[i] > highest ? m[i] : highest;
  }
  const uint32_t start = miller_start(highest, top);
  const uint32_t fastest = fastest_lane(x);

  double twice_inverse[8], above[8], here[8], sum[8];
  for (int i = 0; i < 8; i++) {
    twice_inverse[i] = x[i] > 1e-30 ? 2.0 / x[i] : 0.0;
    above[i] = 0.0;
    here[i] = 1e-200;
    sum[i] = 0.0;
    j[i] = 0.0;
  }
  for (uint32_t l = start; l > 0; l--) {
    const double even = l % 2 == 0 ? 2.0 : 0.0;
    for (int i = 0; i < 8; i++) {
      sum[i] += even * here[i];
      const double next = (double)l * twice_inverse[i] * here[i] - above[i];
      above[i] = here[i];
      here[i] = next;
    }
    if (l - 1 <= highest) {
      for (int i = 0; i < 8; i++) j[i] = l - 1 == m[i] ? here[i] : j[i];
    }
    if (magnitude(here[fastest]) > 1e100) {
      for (int i = 0; i < 8; i++) {
        const double scale = magnitude(here[i]) > 1e50 ? 1e-150 : 1.0;
        above[i] *= scale;
        here[i] *= scale;
        sum[i] *= scale;
        j[i] *= scale;
      }
    }
  }
  for (int i = 0; i < 8; i++) {
    if (x[i] <= 1e-30) {
      j[i] = m[i] == 0 ? 1.0 : 0.0;
    } else {
      j[i] /= sum[i] + here[i];
    }
  }
}

void tb_bessel_pair(uint32_t m, double x, double j[2]) {
  const uint32_t start = miller_start(m + 1, x);
  const double twice_inverse = 2.0 / x;
  double above = 0.0, here = 1e-200, sum = 0.0;
  j[0] = j[1] = 0.0;
  for (uint32_t l = start; l > 0; l--) {
    if (l % 2 == 0) sum += 2.0 * here;
    const double next = (double)l * twice_inverse * here - above;
    above = here;
    here = next;
    if (l - 1 == m) {
      j[0] = here;
      j[1] = above;
    }
    if (here > 1e100 || here < -1e100) {
      above *= 1e-150;
      here *= 1e-150;
      sum *= 1e-150;
      j[0] *= 1e-150;
      j[1] *= 1e-150;
    }
  }
  j[0] /= sum + here;
  j[1] /= sum + here;
}

double tb_bessel_j(uint32_t m, double x) {
  if (x <= 1e-30) return m == 0 ? 1.0 : 0.0;
  double j[2];
  tb_bessel_pair(m, x, j);
  return j[0];
}

/* The factor that turns the recurrence's values into J_{l+1/2} = sqrt(2 x/pi) j_l: from j_0 = sin
 * x/x or j_1, whichever is larger. */
static double half_scale(double x, double here, double above) {
  double sine, cosine;
  tb_sin_cos(x, &sine, &cosine);
  const double j0 = sine / x;
  const double j1 =
    x < 0.05 ? x / 3.0 * (1.0 - x * x / 10.0 * (1.0 - x * x / 28.0)) : sine / (x * x) - cosine / x;
  return (fabs(j0) > fabs(j1) ? j0 / here : j1 / above) * sqrt(2.0 * x / PI);
}

/* Values that the recurrence over orders l + shift ends with: at order shift, one above, and for
 * whole orders the sum that is 1. */
typedef struct Ends {
  double here[8], above[8], sum[8];
} Ends;

/* j[l][i], l < count, up to one factor per lane. Downwards below the turning point is stable too,
 * so one direction serves all orders. */
static void descend(const double x[8], double shift, uint32_t count, double *j, Ends *ends) {
  double inverse[8], above[8], here[8], sum[8], top = 0.0;
  for (int i = 0; i < 8; i++) {
    inverse[i] = 2.0 / x[i];
    above[i] = 0.0;
    here[i] = 1e-200;
    sum[i] = 0.0;
    top = x[i] > top ? x[i] : top;
  }
  const uint32_t fastest = fastest_lane(x);
  for (uint32_t l = miller_start(count, top); l > 0; l--) {
    const double factor = (double)l + shift, even = l % 2 == 0 ? 2.0 : 0.0;
    for (int i = 0; i < 8; i++) {
      sum[i] += even * here[i];
      const double next = factor * inverse[i] * here[i] - above[i];
      above[i] = here[i];
      here[i] = next;
    }
    if (l - 1 < count) {
      for (int i = 0; i < 8; i++) j[8 * (l - 1) + (uint32_t)i] = here[i];
    }
    if (magnitude(here[fastest]) < 1e100) continue;
    for (uint32_t i = 0; i < 8; i++) {
      const double scale = magnitude(here[i]) > 1e50 ? 1e-150 : 1.0;
      above[i] *= scale;
      here[i] *= scale;
      sum[i] *= scale;
      for (uint32_t o = l - 1; o < count; o++) j[8 * o + i] *= scale;
    }
  }
  for (int i = 0; i < 8; i++) {
    ends->here[i] = here[i];
    ends->above[i] = above[i];
    ends->sum[i] = sum[i] + here[i];
  }
}

void tb_bessel_half8(const double x[8], uint32_t count, double *j) {
  Ends ends;
  descend(x, 0.5, count, j, &ends);
  double scale[8];
  for (int i = 0; i < 8; i++) scale[i] = half_scale(x[i], ends.here[i], ends.above[i]);
  for (uint32_t o = 0; o < count; o++) {
    for (uint32_t i = 0; i < 8; i++) j[8 * o + i] *= scale[i];
  }
}

void tb_bessel_whole8(const double x[8], uint32_t count, double *j) {
  Ends ends;
  descend(x, 0.0, count, j, &ends);
  for (uint32_t o = 0; o < count; o++) {
    for (uint32_t i = 0; i < 8; i++) j[8 * o + i] /= ends.sum[i];
  }
}

/* The one zero of J_m between lo and hi, where it is positive at lo or at hi: Halley's step from x,
 * which cubes the error, where it stays inside, else halving. J_m'' comes from Bessel's equation.
 */
static double refine_zero(uint32_t m, double lo, double hi, double x, bool falling) {
  const double order = (double)m;
  for (int i = 0; i < 100; i++) {
    double j[2];
    tb_bessel_pair(m, x, j);
    if ((j[0] > 0.0) == falling) {
      lo = x;
    } else {
      hi = x;
    }
    const double slope = order / x * j[0] - j[1];
    const double bend = -slope / x - (1.0 - order * order / (x * x)) * j[0];
    const double next = x - j[0] / (slope - 0.5 * j[0] * bend / slope);
    const double step = magnitude(next - x);
    if (step <= 3e-7 * x) return next; /* its cube is nothing */
    x = next > lo && next < hi ? next : 0.5 * (lo + hi);
  }
  return x;
}

/* Zeros of J_0 from McMahon's expansion, polished ([DLMF] 10.21.19). */
static uint32_t zeros_of_order_0(double top, double *zeros, uint32_t room) {
  uint32_t count = 0;
  for (uint32_t n = 1;; n++) {
    const double b = ((double)n - 0.25) * PI;
    const double guess = b + 1.0 / (8.0 * b) - 31.0 / (384.0 * b * b * b);
    const double zero = refine_zero(0, guess - 0.3, guess + 0.3, guess, n % 2 == 1);
    if (zero >= top || count == room) return count;
    zeros[count++] = zero;
  }
}

/* The first zero lies between m + 1.8557571 m^(1/3) and 1.0331503 m^(-1/3) more [QuWong1999]. u =
 * sqrt(x) J_m satisfies u'' + (1 - (m^2 - 1/4)/x^2) u = 0, so from a zero z the next is at least pi
 * away and at most pi over the root of that factor at z (Sturm); and nearly pi over its root
 * between the two. */
uint32_t tb_bessel_zeros(uint32_t m, double top, double *zeros, uint32_t room) {
  if (m == 0) return zeros_of_order_0(top, zeros, room);
  const double order = (double)m, root = tb_cbrt(order), square = order * order - 0.25;
  double lo = order + 1.8557570 * root, hi = lo + 1.0331505 / root, guess = 0.5 * (lo + hi);
  for (uint32_t count = 0;; count++) {
    if (lo >= top || count == room) return count;
    const double zero = refine_zero(m, lo, hi, guess, count % 2 == 0);
    if (zero >= top) return count;
    zeros[count] = zero;
    lo = zero + PI;
    hi = zero + PI / sqrt(1.0 - square / (zero * zero));
    const double between = 0.25 * (2.0 * zero + lo + hi);
    guess = zero + PI / sqrt(1.0 - square / (between * between));
  }
}
