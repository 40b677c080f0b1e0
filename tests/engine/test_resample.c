/* SPDX-License-Identifier: MIT */
/* Conversion to other sample rates, against what a sine at the new rate is. */
#include "math/resample.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

static const double PI = 3.14159265358979323846;
static const double RATES[][2] = {
  {44100, 48000}, {48000, 44100}, {96000, 48000}, {22050, 192000}, {48000, 22050}};
enum { PAIRS = sizeof RATES / sizeof *RATES, LENGTH = 4000 };

/* Largest difference between a converted sine and the sine itself, away from the ends; `level`: of
 * what it should be. */
static double error_of(double from, double to, double frequency, double level) {
  float *const in = malloc(LENGTH * sizeof *in);
  const double ratio = to / from;
  const uint32_t length = tb_resampled_length(LENGTH, ratio);
  float *const out = malloc(length * sizeof *out);
  for (int i = 0; i < LENGTH; i++) in[i] = (float)sin(2 * PI * frequency * i / from + 0.3);
  assert_true(tb_resample(in, LENGTH, ratio, out, length));
  double most = 0;
  const uint32_t edge = length / 4;
  for (uint32_t i = edge; i < length - edge; i++) {
    const double expected = level * sin(2 * PI * frequency * i / to + 0.3);
    most = fmax(most, fabs((double)out[i] - expected));
  }
  free(in);
  free(out);
  return most;
}

static void what_both_rates_hold_stays(void **state) {
  (void)state;
  for (int i = 0; i < PAIRS; i++) {
    const double half = 0.5 * fmin(RATES[i][0], RATES[i][1]);
    for (double part = 0.05; part < 0.901; part += 0.05) {
      const double error = error_of(RATES[i][0], RATES[i][1], part * half, 1);
      if (error > 1.2e-4) fail_msg("%g to %g, %g: %g", RATES[i][0], RATES[i][1], part, error);
    }
  }
}

static void what_the_new_rate_cannot_hold_goes(void **state) {
  (void)state;
  for (int i = 0; i < PAIRS; i++) {
    if (RATES[i][1] >= RATES[i][0]) continue;
    for (double part = 1.0; part < 1.8; part += 0.1) {
      const double frequency = part * 0.5 * RATES[i][1];
      if (frequency >= 0.5 * RATES[i][0]) break;
      const double error = error_of(RATES[i][0], RATES[i][1], frequency, 0);
      if (error > 1.8e-5) fail_msg("%g to %g, %g: %g", RATES[i][0], RATES[i][1], part, error);
    }
  }
}

static void the_same_rate_copies(void **state) {
  (void)state;
  const float in[4] = {1, -2, 3, 0.1f};
  float out[4];
  assert_int_equal(tb_resampled_length(4, 1.0), 4);
  assert_true(tb_resample(in, 4, 1.0, out, 4));
  for (int i = 0; i < 4; i++) assert_true(out[i] == in[i]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(what_both_rates_hold_stays),
    cmocka_unit_test(what_the_new_rate_cannot_hold_goes),
    cmocka_unit_test(the_same_rate_copies),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
