/* SPDX-License-Identifier: MIT */
/* Frequencies and decay times read off what the drum does, at several sample rates. */
#include "physics.h"

static const double PI = 3.14159265358979323846;

/* |Hann-windowed Fourier integral| of count samples at f. */
static double level_at(const double *x, uint32_t count, double f, double rate) {
  double re = 0.0, im = 0.0;
  for (uint32_t i = 0; i < count; i++) {
    const double window = 0.5 - 0.5 * cos(2.0 * PI * (i + 0.5) / count);
    const double phase = 2.0 * PI * f * i / rate;
    re += window * x[i] * cos(phase);
    im -= window * x[i] * sin(phase);
  }
  return sqrt(re * re + im * im);
}

/* The frequency of the highest level within `cents` around a guess, by golden section. */
static double peak_near(const double *x, uint32_t count, double guess, double cents, double rate) {
  double lo = guess * pow(2.0, -cents / 1200.0), hi = guess * pow(2.0, cents / 1200.0);
  const double golden = 0.6180339887498949;
  while (hi - lo > 1e-7 * guess) {
    const double a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
    if (level_at(x, count, a, rate) > level_at(x, count, b, rate)) {
      hi = b;
    } else {
      lo = a;
    }
  }
  return 0.5 * (lo + hi);
}

/* Height of the head's centre after a soft stroke at the centre: modes (0, n) alone. */
static double *center_after_stroke(TaborModel *model, uint32_t count, uint32_t skip) {
  TaborDrum *drum = physics_drum(model);
  double *x = malloc(count * sizeof *x);
  const TaborEvent strike = {.type = TABOR_EVENT_STRIKE, .velocity = 1.0};
  tabor_drum_process(drum, &strike, 1, NULL, skip);
  for (uint32_t i = 0; i < count; i++) {
    TaborProbe probe;
    tabor_drum_process(drum, NULL, 0, NULL, 1);
    tabor_drum_probe(drum, &probe);
    x[i] = probe.head;
  }
  tabor_drum_destroy(drum);
  return x;
}

static void the_head_rings_at_its_modes_and_decays_as_they_do(void **state) {
  (void)state;
  static const double ZEROS[3] = {2.404825557695773, 5.520078110286311, 8.653727912911013};
  static const double RATES[] = {22050.0, 44100.0, 48000.0, 96000.0};
  for (int r = 0; r < 4; r++) {
    TaborDrumDef def;
    tabor_drum_def_default(&def);
    def.shell.radius = 0.2;
    def.batter.tension = 3000.0;
    def.batter.surface_density = 0.26;
    def.batter.bending_stiffness = def.batter.stretch_stiffness = 0.0;
    def.batter.damping_0 = 6.0;
    def.batter.damping_1 = 5e-4;
    def.batter.damping_k = 0.1;
    def.air.density = 0.0;
    def.air.gravity = 0.0;
    TaborModel *model = physics_model(&def, RATES[r], TABOR_QUALITY_DRAFT);
    const uint32_t count = (uint32_t)(0.5 * RATES[r]), gap = (uint32_t)(0.2 * RATES[r]);
    double *x = center_after_stroke(model, count + gap, (uint32_t)(0.03 * RATES[r]));
    for (int n = 0; n < 3; n++) {
      const double k = ZEROS[n] / 0.2, omega = k * sqrt(3000.0 / 0.26);
      const double decay = 0.5 * (6.0 + 0.1 * k + 5e-4 * k * k);
      const double f = sqrt(omega * omega - decay * decay) / (2.0 * PI);
      const double seen = peak_near(x, count, f, 20.0, RATES[r]);
      const double cents = 1200.0 * log2(seen / f);
      const double early = level_at(x, count, f, RATES[r]);
      const double late = level_at(x + gap, count, f, RATES[r]);
      const double rate_seen = log(early / late) / (gap / RATES[r]);
      print_message("%6.0f Hz, (0,%d): %9.4f Hz, off by %+.4f cent; decay %.4f of the expected\n",
                    RATES[r], n + 1, seen, cents, rate_seen / decay);
      assert_true(fabs(cents) < 0.5);
      assert_true(fabs(rate_seen / decay - 1.0) < 0.01);
    }
    free(x);
    tabor_model_release(model);
  }
}

/* With air too, what `modes` says is what sounds. */
static void microphones_hear_the_listed_modes(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("frame-drum");
  const double rate = 48000.0;
  TaborModel *model = physics_model(&def, rate, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  enum { COUNT = 24000 };
  static float samples[COUNT];
  static double x[COUNT];
  float *outputs[TABOR_MAX_MICS] = {samples};
  const TaborEvent strike = physics_strike(&def);
  tabor_drum_process(drum, &strike, 1, NULL, 1440);
  tabor_drum_process(drum, NULL, 0, outputs, COUNT);
  for (int i = 0; i < COUNT; i++) x[i] = (double)samples[i];
  for (uint32_t row = 0; row < 3; row++) {
    TaborModeInfo mode;
    assert_true(tabor_model_mode(model, row, &mode));
    const double seen = peak_near(x, COUNT, mode.frequency, 20.0, rate);
    print_message("(%u,%u): listed %.3f Hz, heard %.3f Hz\n", mode.m, mode.n, mode.frequency, seen);
    assert_true(fabs(1200.0 * log2(seen / mode.frequency)) < 2.0); /* neighbours overlap a little */
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_head_rings_at_its_modes_and_decays_as_they_do),
    cmocka_unit_test(microphones_hear_the_listed_modes),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
