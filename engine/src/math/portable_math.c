/* SPDX-License-Identifier: MIT */
#include "math/portable_math.h"

#include <math.h>
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

/* log f for f in [sqrt(1/2), sqrt(2)]. */
static double log_fraction(double f) {
  const double t = (f - 1.0) / (f + 1.0), t2 = t * t;
  double sum = 0.0;
  for (int k = 21; k >= 3; k -= 2) sum = (sum + 1.0 / (double)k) * t2;
  return 2.0 * t + 2.0 * t * sum;
}

double tb_log(double x) {
  if (x < 0.0) return NAN;
  if (!(x < INFINITY)) return x;
  if (x < 2.3e-308) return -INFINITY;
  int exponent;
  const double fraction = split(x, &exponent);
  return exponent * LN2_HIGH + (exponent * LN2_LOW + log_fraction(fraction));
}

/* terms[0] + terms[1] x + terms[2] x^2 + .. */
static inline double polynomial(double x, const double *terms, int count) {
  double sum = terms[count - 1];
  for (int i = count - 2; i >= 0; i--) sum = terms[i] + x * sum;
  return sum;
}

/* Taylor's series, every other term: two chains are computed side by side. */
static const double EXP_EVEN[] = {1.0 / 2,     1.0 / 24,      1.0 / 720,
                                  1.0 / 40320, 1.0 / 3628800, 1.0 / 479001600};
static const double EXP_ODD[] = {1.0 / 6,      1.0 / 120,      1.0 / 5040,
                                 1.0 / 362880, 1.0 / 39916800, 1.0 / 6227020800};
static const double SINE_EVEN[] = {-1.0 / 6, -1.0 / 5040, -1.0 / 39916800, -1.0 / 1307674368000};
static const double SINE_ODD[] = {1.0 / 120, 1.0 / 362880, 1.0 / 6227020800, 1.0 / 355687428096000};
static const double COSINE_EVEN[] = {1.0 / 24, 1.0 / 40320, 1.0 / 479001600, 1.0 / 20922789888000};
static const double COSINE_ODD[] = {-1.0 / 720, -1.0 / 3628800, -1.0 / 87178291200};

/* exp(x) - 1 for |x| <= ln 2 / 2. */
static double exp_small(double x) {
  const double s = x * x;
  return x + s * (polynomial(s, EXP_EVEN, 6) + x * polynomial(s, EXP_ODD, 6));
}

/* sin x and cos x for |x| <= pi/4. */
static double sine_small(double x) {
  const double s = x * x, q = s * s;
  return x + x * s * (polynomial(q, SINE_EVEN, 4) + s * polynomial(q, SINE_ODD, 4));
}

static double cosine_small(double x) {
  const double s = x * x, q = s * s;
  return 1.0 + (-0.5 * s + q * (polynomial(q, COSINE_EVEN, 4) + s * polynomial(q, COSINE_ODD, 3)));
}

static double nearest_whole(double x) { return (double)(int64_t)(x + (x < 0.0 ? -0.5 : 0.5)); }

/* 2^exponent, a normal number. */
static double power_of_two(int64_t exponent) {
  return double_of((uint64_t)(exponent + 1023) << 52);
}

double tb_exp(double x) {
  if (x < -708.0) return 0.0;
  if (!(x <= 709.78)) return x + INFINITY;
  const double whole = nearest_whole(x * INVERSE_LN2);
  const double rest = (x - whole * LN2_HIGH) - whole * LN2_LOW;
  const int64_t half = (int64_t)whole / 2; /* 2^1024 is no number, but its root is */
  return (1.0 + exp_small(rest)) * power_of_two(half) * power_of_two((int64_t)whole - half);
}

double tb_sinh(double x) {
  const double square = x * x;
  if (square < 1.0) {
    double sum = 0.0;
    for (int k = 18; k >= 2; k -= 2) sum = (1.0 + sum) * square / (double)(k * (k + 1));
    return x + x * sum;
  }
  const double up = tb_exp(0.5 * fabs(x)); /* whose square may be twice the largest number */
  return copysign(0.5 * up * up - 0.5 / up / up, x);
}

double tb_cosh(double x) {
  const double up = tb_exp(0.5 * fabs(x));
  return 0.5 * up * up + 0.5 / up / up;
}

double tb_tanh(double x) { return fabs(x) > 20.0 ? copysign(1.0, x) : tb_sinh(x) / tb_cosh(x); }

double tb_cbrt(double x) {
  if (!(x > 0.0)) return x;
  const double root = tb_exp(tb_log(x) / 3.0);
  return root - (root * root * root - x) / (3.0 * root * root);
}

double tb_hypot(double x, double y) {
  const double a = fabs(x), b = fabs(y), most = a > b ? a : b, least = a > b ? b : a;
  if (most == 0.0) return 0.0;
  const double ratio = least / most;
  return most * sqrt(1.0 + ratio * ratio);
}

double tb_whole_power(double x, uint32_t n) {
  double product = 1.0;
  for (double factor = x; n > 0; n >>= 1, factor *= factor) {
    if (n & 1u) product *= factor;
  }
  return product;
}

double tb_power(double x, double a) {
  if (!(x > 1e-290)) return a > 0.0 ? 0.0 : 1.0;
  int exponent;
  const double fraction = split(x, &exponent);
  const double e = (double)exponent;
  /* a log x = whole ln 2 + rest */
  const double log_x = e * LN2_HIGH + (e * LN2_LOW + log_fraction(fraction));
  const double scaled = a * log_x * INVERSE_LN2;
  const double whole = nearest_whole(scaled);
  const double rest = (a * (e * LN2_HIGH) - whole * LN2_HIGH) +
                      (a * (e * LN2_LOW + log_fraction(fraction)) - whole * LN2_LOW);
  if (whole < -1000.0) return 0.0;
  if (whole > 1000.0) return 1e300;
  return (1.0 + exp_small(rest)) * power_of_two((int64_t)whole);
}

/* pi/2 in parts of 25 bits, whose products with a whole number below 2^28 are exact. */
static const double QUARTER[] = {0x1.921fb5p+0, 0x1.110b46p-26, 0x1.1a6263p-54,
                                 0x1.8a2e03707344ap-81};

/* x = quarter pi/2 + rest; returns rest. */
static double rest_of_quarters(double x, int64_t *quarter) {
  if (!(fabs(x) <= 4e8)) {
    *quarter = 0;
    return NAN;
  }
  const double whole = nearest_whole(x * 0.63661977236758134308);
  *quarter = (int64_t)whole;
  return ((x - whole * QUARTER[0]) - whole * QUARTER[1]) - whole * QUARTER[2] - whole * QUARTER[3];
}

/* sin and cos of an angle that lies `quarter` right angles beyond the one of s and c. */
static void turn_by_quarters(int64_t quarter, double s, double c, double *sine, double *cosine) {
  const double a = quarter & 1 ? c : s, b = quarter & 1 ? s : c;
  *sine = quarter & 2 ? -a : a;
  *cosine = (quarter + 1) & 2 ? -b : b;
}

double tb_sin(double x) {
  int64_t quarter;
  const double rest = rest_of_quarters(x, &quarter);
  const double size = quarter & 1 ? cosine_small(rest) : sine_small(rest);
  return quarter & 2 ? -size : size;
}

double tb_cos(double x) {
  int64_t quarter;
  const double rest = rest_of_quarters(x, &quarter);
  const double size = quarter & 1 ? sine_small(rest) : cosine_small(rest);
  return (quarter + 1) & 2 ? -size : size;
}

void tb_sin_cos(double x, double *sine, double *cosine) {
  int64_t quarter;
  const double rest = rest_of_quarters(x, &quarter);
  turn_by_quarters(quarter, sine_small(rest), cosine_small(rest), sine, cosine);
}

/* Rounds to a whole number, |x| < 2^51, in a way that loops over arrays are vectorised. */
static inline double rounded(double x) {
  const double large = 6755399441055744.0; /* 1.5 2^52: its neighbours are 1 apart */
  return (x + large) - large;
}

void tb_sin_cos_array(uint32_t count, const double *restrict x, double *restrict sine,
                      double *restrict cosine) {
  for (uint32_t i = 0; i < count; i++) {
    const double whole = rounded(x[i] * 0.63661977236758134308);
    const double quarter = whole - 4.0 * rounded(0.25 * whole); /* -2 to 2 */
    const double rest =
      ((x[i] - whole * QUARTER[0]) - whole * QUARTER[1]) - whole * QUARTER[2] - whole * QUARTER[3];
    const double s = sine_small(rest), c = cosine_small(rest);
    const bool odd = quarter * quarter == 1.0;
    const double a = odd ? c : s, b = odd ? s : c;
    sine[i] = quarter < 0.0 || quarter > 1.0 ? -a : a;
    cosine[i] = quarter * quarter > 1.0 || quarter > 0.0 ? -b : b;
  }
}

void tb_sin_cos_degrees(double angle, double *sine, double *cosine) {
  const double whole = nearest_whole(angle / 90.0);
  const double rest = (angle - 90.0 * whole) * 0.017453292519943295;
  turn_by_quarters((int64_t)whole, sine_small(rest), cosine_small(rest), sine, cosine);
}

/* atan t in radians for 0 <= t <= 1: atan t = atan c + atan((t - c)/(1 + t c)), c = 1/2, leaves |x|
 * <= 1/2. */
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
