/* SPDX-License-Identifier: MIT */
/* From two steps to a frame: pass band, stop band and delay, the poles of the elliptic low-pass
 * that SciPy designs, and a drum that sounds at the same time as at twice the rate. */
#include "state/halve_rate.h"

#include <complex.h>

#include "model/mics.h"
#include "physics.h"

static const double PI = 3.14159265358979323846;

enum { LENGTH = 4000 };            /* frames after which an impulse has decayed below rounding */
static const double EDGE = 0.4535; /* of the pass band, of the output's rate */

/* Impulses in the first and in the second step of a frame, at the output. */
static double of_first[LENGTH], of_second[LENGTH];

static int set_up(void **state) {
  (void)state;
  double memory[TB_HALVE_MEMORY] = {0.0}, other[TB_HALVE_MEMORY] = {0.0};
  for (int i = 0; i < LENGTH; i++) {
    of_first[i] = tb_halve_rate(memory, i == 0 ? 1.0 : 0.0, 0.0);
    of_second[i] = tb_halve_rate(other, 0.0, i == 0 ? 1.0 : 0.0);
  }
  return 0;
}

/* Gain of the steps' frequency f, in parts of the output's rate, up to 1: where it is heard, it is
 * at f or folded. */
static double complex gain_at(double f) {
  double complex sum = 0.0;
  for (int i = 0; i < LENGTH;
       i++) { /* the second step's time is the frame's, the first one's half a frame ago */
    sum += (of_second[i] + of_first[i] * cexp(-I * PI * f)) * cexp(-2.0 * I * PI * f * i);
  }
  return sum;
}

static double decibels(double complex gain) { return 20.0 * log10(cabs(gain) + 1e-300); }

static void what_is_heard_passes_and_what_would_fold_onto_it_does_not(void **state) {
  (void)state;
  double least = 0.0, most = -1e9;
  for (int i = 0; i <= 400; i++) {
    const double f = EDGE * i / 400.0;
    least = fmin(least, decibels(gain_at(f)));
    most = fmax(most, decibels(gain_at(1.0 - f)));
  }
  print_message("pass band down to %.1e dB, stop band up to %.1f dB\n", least, most);
  assert_true(least > -1e-6 && most < -104.0);
  assert_true(fabs(decibels(gain_at(0.5)) + 3.0103) < 1e-3); /* the two mirror each other */
}

static double delay_at(double f) {
  const double d = 1e-4;
  return -carg(gain_at(f + d) / gain_at(f - d)) / (4.0 * PI * d);
}

static void the_delay_is_what_microphones_take_off(void **state) {
  (void)state;
  print_message("delay: %.3f frames, %.3f at a quarter of the rate, %.3f at 20 kHz of 48 kHz\n",
                delay_at(0.001), delay_at(0.25), delay_at(20.0 / 48.0));
  assert_true(fabs(2.0 * delay_at(0.001) - TB_HALVE_STEPS) < 0.5);
  assert_true(delay_at(0.25) < 2.6 && delay_at(20.0 / 48.0) < 6.0);
}

/* scipy.signal.ellip(17, 1.7e-10, 104.115, 0.4535): squares of the imaginary parts of its poles. */
static const double POLES[2 * TB_HALVE_STAGES] = {0.0373583760, 0.1393387012, 0.2813053654,
                                                  0.4362099509, 0.5844075476, 0.7170190784,
                                                  0.8345501082, 0.9442921184};

/* A pole at i sqrt(a): the response to an impulse continued by the all-passes' recursion vanishes.
 */
static void the_poles_are_the_elliptic_filters(void **state) {
  (void)state;
  for (int chain = 0; chain < 2; chain++) {
    double product[TB_HALVE_STAGES + 1] = {1.0};
    for (int j = 0; j < TB_HALVE_STAGES; j++) {
      const double a = POLES[2 * j + chain];
      for (int k = j + 1; k > 0; k--) product[k] += a * product[k - 1];
    }
    const double *h = chain ? of_first : of_second;
    for (int i = TB_HALVE_STAGES + 1; i < 40; i++) {
      double rest = 0.0;
      for (int k = 0; k <= TB_HALVE_STAGES; k++) rest += product[k] * h[i - k];
      assert_true(fabs(rest) < 1e-8);
    }
  }
}

static double peak_time(double rate, double *peak) {
  const TaborDrumDef def = physics_preset("frame-drum");
  TaborModel *model = physics_model(&def, rate, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  TaborModelInfo info;
  TaborEvent strike = physics_strike(&def);
  float sample = 0.0f, *outputs[TABOR_MAX_MICS] = {&sample};
  int at = 0;
  tabor_model_info(model, &info);
  assert_true(info.sample_rate == rate && info.step_rate == 96000.0);
  *peak = 0.0;
  for (int i = 0; i < (int)(0.02 * rate); i++) {
    tabor_drum_process(drum, &strike, i == 0, outputs, 1);
    if (fabs((double)sample) <= *peak) continue;
    *peak = fabs((double)sample);
    at = i;
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return (at + 1) / rate;
}

static void a_drum_is_heard_when_it_is_at_twice_the_rate(void **state) {
  (void)state;
  double peak, same;
  const double one = peak_time(96000.0, &same), two = peak_time(48000.0, &peak);
  print_message("peak at %.6f s, at 48 kHz at %.6f s\n", one, two);
  assert_true(fabs(two - one) < 1.0 / 48000.0);
  assert_true(fabs(peak / same - 1.0) < 0.02); /* the highest sample of a peak */
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(what_is_heard_passes_and_what_would_fold_onto_it_does_not),
    cmocka_unit_test(the_delay_is_what_microphones_take_off),
    cmocka_unit_test(the_poles_are_the_elliptic_filters),
    cmocka_unit_test(a_drum_is_heard_when_it_is_at_twice_the_rate),
  };
  return cmocka_run_group_tests(tests, set_up, NULL);
}
