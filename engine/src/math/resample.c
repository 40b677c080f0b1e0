/* SPDX-License-Identifier: MIT */
#include "math/resample.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "math/portable_math.h"

#define REACH 64 /* samples of the lower rate, to each side */
/* of the table for each of them; between them h is taken as straight, which is 1e-6 off */
#define STEPS 1024u

static const double PI = 3.14159265358979323846, BETA = 10.0, EDGE = 0.95;

/* The modified Bessel function of order 0, by its series. */
static double bessel_i0(double x) {
  double sum = 1.0, term = 1.0;
  for (int k = 1; term > 1e-17 * sum; k++) {
    term *= x / (2.0 * k) * (x / (2.0 * k));
    sum += term;
  }
  return sum;
}

/* h(t)/min(1, r) for t min(1, r) = i/STEPS, i from 0 to REACH STEPS and one zero behind. */
static double *make_table(void) {
  const uint32_t count = REACH * STEPS;
  double *const table = calloc(count + 2, sizeof *table);
  if (!table) return NULL;
  const double whole = bessel_i0(BETA);
  table[0] = EDGE;
  for (uint32_t i = 1; i <= count; i++) {
    const double t = (double)i / STEPS, place = t / REACH;
    double sine, cosine;
    tb_sin_cos(PI * EDGE * t, &sine, &cosine);
    table[i] = sine / (PI * t) * bessel_i0(BETA * sqrt(1.0 - place * place)) / whole;
  }
  return table;
}

static double kernel(const double *table, double t) {
  const double place = fabs(t) * STEPS;
  if (place >= REACH * STEPS) return 0.0;
  const uint32_t i = (uint32_t)place;
  return table[i] + (place - (double)i) * (table[i + 1] - table[i]);
}

static double sample_at(const double *table, const float *sound, uint32_t frames, double place,
                        double scale) {
  const double reach = REACH / scale;
  const double first = ceil(place - reach), last = floor(place + reach);
  const int64_t from = first > 0.0 ? (int64_t)first : 0;
  const int64_t to = last < (double)frames ? (int64_t)last + 1 : (int64_t)frames;
  double sum = 0.0;
  for (int64_t k = from; k < to && k < (int64_t)frames; k++) {
    sum += (double)sound[k] * kernel(table, (place - (double)k) * scale);
  }
  return scale * sum;
}

uint32_t tb_resampled_length(uint32_t frames, double ratio) {
  const double length = ceil((double)frames * ratio);
  return length < (double)UINT32_MAX ? (uint32_t)length : UINT32_MAX;
}

bool tb_resample(const float *sound, uint32_t frames, double ratio, float *converted,
                 uint32_t length) {
  if (ratio == 1.0) {
    memcpy(converted, sound, (frames < length ? frames : length) * sizeof *converted);
    return true;
  }
  double *const table = make_table();
  if (!table) return false;
  const double scale = ratio < 1.0 ? ratio : 1.0;
  for (uint32_t i = 0; i < length; i++) {
    converted[i] = (float)sample_at(table, sound, frames, (double)i / ratio, scale);
  }
  free(table);
  return true;
}
