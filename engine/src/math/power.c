/* SPDX-License-Identifier: MIT */
#include "math/power.h"

#include <string.h>

static const double LN2_HIGH = 6.93147180369123816490e-01; /* 32 bits: whole multiples are exact */
static const double LN2_LOW = 1.90821492927058770002e-10;
static const double INVERSE_LN2 = 1.44269504088896338700;

static uint64_t bits_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

static double double_of(uint64_t bits) {
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

/* x = 2^exponent * fraction, fraction in [sqrt(1/2), sqrt(2)); x a normal number. */
static double split(double x, int *exponent) {
  const uint64_t bits = bits_of(x);
  *exponent = (int)(bits >> 52) - 1023;
  double fraction = double_of((bits & 0xFFFFFFFFFFFFFull) | 0x3FF0000000000000ull);
  if (fraction > 1.41421356237309515) {
    fraction *= 0.5;
    *exponent += 1;
  }
  return fraction;
}

static double log_fraction(double f) {
  const double t = (f - 1.0) / (f + 1.0), t2 = t * t;
  double sum = 0.0;
  for (int k = 21; k >= 3; k -= 2) sum = (sum + 1.0 / (double)k) * t2;
  return 2.0 * t * (1.0 + sum);
}

/* exp(x) for |x| <= ln 2 / 2. */
static double exp_small(double x) {
  double sum = 1.0;
  for (int k = 14; k >= 1; k--) sum = 1.0 + sum * x / (double)k;
  return sum;
}

double tb_power(double x, double a) {
  if (!(x > 1e-290)) return a > 0.0 ? 0.0 : 1.0;
  int exponent;
  const double fraction = split(x, &exponent);
  const double e = (double)exponent;
  /* a log x = whole ln 2 + rest */
  const double log_x = e * LN2_HIGH + (e * LN2_LOW + log_fraction(fraction));
  const double scaled = a * log_x * INVERSE_LN2;
  const double whole = (double)(int64_t)(scaled + (scaled < 0.0 ? -0.5 : 0.5));
  const double rest = (a * (e * LN2_HIGH) - whole * LN2_HIGH) +
                      (a * (e * LN2_LOW + log_fraction(fraction)) - whole * LN2_LOW);
  if (whole < -1000.0) return 0.0;
  if (whole > 1000.0) return 1e300;
  return exp_small(rest) * double_of((uint64_t)((int64_t)whole + 1023) << 52);
}

void tb_sin_cos_degrees(double angle, double *sine, double *cosine) {
  const double turns = angle / 90.0;
  const int64_t quarter = (int64_t)(turns + (turns < 0.0 ? -0.5 : 0.5));
  const double x = (angle - 90.0 * (double)quarter) * 0.017453292519943295;
  const double x2 = x * x;
  double s = 1.0, c = 1.0;
  for (int k = 18; k >= 2; k -= 2) {
    s = 1.0 - s * x2 / (double)(k * (k + 1));
    c = 1.0 - c * x2 / (double)(k * (k - 1));
  }
  s *= x;
  switch (((quarter % 4) + 4) % 4) {
  case 0:
    *sine = s;
    *cosine = c;
    break;
  case 1:
    *sine = c;
    *cosine = -s;
    break;
  case 2:
    *sine = -s;
    *cosine = -c;
    break;
  default:
    *sine = -c;
    *cosine = s;
    break;
  }
}

/* atan t in radians for 0 <= t <= 1: atan t = atan c + atan((t - c)/(1 + t c)), c = 1/2, leaves |x| <= 1/2. */
static double arc_tangent(double t) {
  const double x = (t - 0.5) / (1.0 + 0.5 * t), x2 = x * x;
  double sum = 0.0;
  for (int k = 45; k >= 1; k -= 2) sum = 1.0 / (double)k - x2 * sum;
  return 0.46364760900080611621 + x * sum;
}

double tb_arc_degrees(double y, double x) {
  const double up = y < 0.0 ? -y : y, across = x < 0.0 ? -x : x;
  if (up == 0.0 && across == 0.0) return 0.0;
  const bool steep = up > across;
  const double first = 57.295779513082320877 * arc_tangent(steep ? across / up : up / across);
  const double quarter = steep ? 90.0 - first : first;
  const double half = x < 0.0 ? 180.0 - quarter : quarter;
  return y < 0.0 ? -half : half;
}
