/* SPDX-License-Identifier: MIT */
/* Scattering of the high band: its rate, and the walk of each mode's phase. */
#include "physics.h"

#include "drum/drum.h"
#include "high_band/scattering.h"

static const double PATCH = 0.03; /* l of scattering.h [m] */

/* ---- the rate ------------------------------------------------------------------------------- */

enum { TRIALS = 400, STEPS_A_PATCH = 10, PATCHES = 60, SMOOTH = 15 };

/* The phase that a wave gains on its way over a line of random mass, whose correlation is a
 * Gaussian of length PATCH: white noise under a Gaussian of PATCH/sqrt(2). A wave is shorter by the
 * fraction e/2 where the mass is larger by e. */
static double phase_of_a_way(uint64_t *seed, double wavenumber, double unevenness) {
  enum { COUNT = PATCHES * STEPS_A_PATCH };
  static double noise[COUNT + 2 * SMOOTH];
  double weight[2 * SMOOTH + 1], square = 0.0, sum = 0.0;
  for (int j = 0; j <= 2 * SMOOTH; j++) {
    const double s = (double)(j - SMOOTH) / STEPS_A_PATCH;
    weight[j] = exp(-2.0 * s * s);
    square += weight[j] * weight[j] / 3.0; /* of noise from -1 to 1 */
  }
  for (int i = 0; i < COUNT + 2 * SMOOTH; i++) noise[i] = physics_uniform(seed, -1.0, 1.0);
  for (int i = 0; i < COUNT; i++) {
    for (int j = 0; j <= 2 * SMOOTH; j++) sum += weight[j] * noise[i + j];
  }
  return 0.5 * wavenumber * unevenness * sum / sqrt(square) * PATCH / STEPS_A_PATCH;
}

static const double SCATTER = 0.15; /* of a variance over 400 trials it is 7 % */

static void the_rate_is_that_of_random_phases_along_a_way(void **state) {
  (void)state;
  const TaborAirDef vacuum = {.density = 0.0, .sound_speed = 343.0};
  const TaborHeadDef head = {.tension = 3000.0, .surface_density = 0.3, .unevenness = 0.04};
  const double speed = sqrt(head.tension / head.surface_density), omega = 30000.0;
  uint64_t seed = physics_seed();
  double square = 0.0;
  for (int i = 0; i < TRIALS; i++) {
    const double phase = phase_of_a_way(&seed, omega / speed, head.unevenness);
    square += phase * phase / TRIALS;
  }
  const double rate = square * speed / (PATCHES * PATCH);
  const double found = tb_scattering_rate(&head, &vacuum, omega);
  if (fabs(found / rate - 1.0) > SCATTER) fail_msg("%g 1/s, by random ways %g", found, rate);
}

static void the_rate_grows_with_the_squares_of_unevenness_and_frequency(void **state) {
  (void)state;
  const TaborAirDef vacuum = {.density = 0.0, .sound_speed = 343.0};
  TaborHeadDef head = {.tension = 3000.0, .surface_density = 0.3, .unevenness = 0.04};
  const double once = tb_scattering_rate(&head, &vacuum, 30000.0);
  assert_true(fabs(tb_scattering_rate(&head, &vacuum, 60000.0) / once - 4.0) < 1e-6);
  head.unevenness *= 3.0;
  assert_true(fabs(tb_scattering_rate(&head, &vacuum, 30000.0) / once - 9.0) < 1e-6);
  head.unevenness = 0.0;
  assert_true(tb_scattering_rate(&head, &vacuum, 30000.0) == 0.0);
}

/* ---- the walk ------------------------------------------------------------------------------- */

enum { FLYING = 4800, MOST_MODES = 4096 };

static void play(TaborDrum *drum, const TaborEvent *event, uint32_t frames) {
  static float samples[FLYING];
  float *outputs[TABOR_MAX_MICS] = {samples};
  assert_true(frames <= FLYING);
  tabor_drum_process(drum, event, event ? 1 : 0, outputs, frames);
}

/* A tom 0.1 s after a stroke: nothing touches it any more. */
static TaborDrum *struck_drum(double unevenness, uint32_t quality, uint32_t seed) {
  TaborDrumDef def = physics_preset("tom-12");
  def.batter.unevenness = def.resonant.unevenness = unevenness;
  def.batter.lug_seed = seed;
  TaborModel *model = physics_model(&def, 48000.0, quality);
  TaborDrum *drum = physics_drum(model);
  tabor_model_release(model);
  const TaborEvent event = physics_strike(&def);
  play(drum, &event, FLYING);
  return drum;
}

static double number(const TbView *view, const void *array, uint32_t i) {
  return view->model->high.precision == TB_IN_FLOAT ? (double)((const float *)array)[i]
                                                    : ((const double *)array)[i];
}

/* Motions of all modes as A and p of A cos p, by the turns that they have just now. */
typedef struct Motions {
  double size[MOST_MODES], phase[MOST_MODES];
} Motions;

static void observe(const TbView *view, Motions *motions) {
  const TbHighBand *high = &view->model->high;
  assert_in_range(high->padded, 500, MOST_MODES);
  for (uint32_t i = 0; i < high->padded; i++) {
    const double r = sqrt(high->ringing.b[i]);
    const double now = number(view, view->now.high, i), last = number(view, view->last.high, i);
    const double c = number(view, view->high.turn, i) / (2.0 * r);
    const double s = (r * last - now * c) / sqrt(1.0 - c * c);
    motions->size[i] = hypot(now, s);
    motions->phase[i] = atan2(s, now);
  }
}

static Motions before, after;

static TbView walk(TaborDrum *drum, uint32_t frames) {
  TbView view = tb_view(drum->state, drum->model);
  observe(&view, &before);
  play(drum, NULL, frames);
  view = tb_view(drum->state, drum->model);
  observe(&view, &after);
  return view;
}

/* In parts of the loudest mode: single and double precision, and what drifts since a turn's sine is
 * rounded. */
static void a_mode_keeps_its_amplitude(void **state) {
  (void)state;
  static const uint32_t QUALITIES[] = {TABOR_QUALITY_LIVE, TABOR_QUALITY_STUDIO};
  static const double TOLERANCE[] = {1e-4, 1e-9};
  for (int q = 0; q < 2; q++) {
    TaborDrum *drum = struck_drum(0.08, QUALITIES[q], 1);
    const TbView view = walk(drum, 2400);
    const TbHighBand *high = &view.model->high;
    const double steps = 2400.0 * view.model->steps;
    double loudest = 0.0, worst = 0.0;
    for (uint32_t i = 0; i < high->padded; i++) {
      if (high->g[i] == 0.0) continue;
      loudest = fmax(loudest, before.size[i]);
      worst =
        fmax(worst, fabs(after.size[i] - before.size[i] * pow(high->ringing.b[i], 0.5 * steps)));
    }
    if (worst > TOLERANCE[q] * loudest)
      fail_msg("quality %u: %g of %g", QUALITIES[q], worst, loudest);
    tabor_drum_destroy(drum);
  }
}

/* Of modes that walk at the rate D, what is left of a common phase after t is e^(-D t/2). */
static const double COHERENCE =
  0.06; /* of a mean over some 500 modes, and of the intervals' ends */

static void phases_are_lost_at_the_rate(void **state) {
  (void)state;
  TaborDrum *drum = struck_drum(0.004, TABOR_QUALITY_LIVE, 1);
  const uint32_t rounds = 5;
  const uint32_t steps = rounds * drum->model->high.scatter_steps;
  const TbView view = walk(drum, steps);
  const TbHighBand *high = &view.model->high;
  double found = 0.0, expected = 0.0, count = 0.0;
  for (uint32_t i = 0; i < high->padded; i++) {
    if (before.size[i] == 0.0) continue; /* of the lower head, and padding */
    const double turn = acos(high->ringing.a[i] / (2.0 * sqrt(high->ringing.b[i])));
    found += cos(after.phase[i] - before.phase[i] - turn * steps);
    expected += exp(-0.5 * high->ringing.walk[i] * high->scatter_steps * steps / 3.0);
    count++;
  }
  if (fabs(found - expected) > COHERENCE * count) {
    fail_msg("%g left of the phase instead of %g", found / count, expected / count);
  }
  assert_in_range(100.0 * expected / count, 20, 80);
  tabor_drum_destroy(drum);
}

/* G, and at most a quarter of a sixth of an octave more. */
static void modes_walk_as_the_head_scatters(void **state) {
  (void)state;
  const double sixth = pow(2.0, 1.0 / 6.0) - 1.0;
  TaborDrum *drum = struck_drum(0.08, TABOR_QUALITY_LIVE, 1);
  const TaborModel *model = drum->model;
  const TbHighBand *high = &model->high;
  for (uint32_t i = 0; i < high->padded; i++) {
    if (high->g[i] == 0.0) continue;
    const uint32_t head = i >= high->begin[1];
    const double omega =
      acos(high->ringing.a[i] / (2.0 * sqrt(high->ringing.b[i]))) * model->step_rate;
    const double rate =
      tb_scattering_rate(head ? &model->def.resonant : &model->def.batter, &model->def.air, omega);
    const double found = high->ringing.walk[i] * high->scatter_steps * model->step_rate / 3.0;
    if (found < 0.99 * rate || found > 1.01 * rate + 0.25 * 1.13 * sixth * omega) {
      fail_msg("mode %u at %g rad/s: %g instead of %g", i, omega, found, rate);
    }
  }
  tabor_drum_destroy(drum);
}

static void an_even_head_scatters_nothing(void **state) {
  (void)state;
  TaborDrum *drum = struck_drum(0.0, TABOR_QUALITY_LIVE, 1);
  const TbView view = walk(drum, 960);
  const TbHighBand *high = &view.model->high;
  assert_memory_equal(view.high.turn, high->ringingf.a, high->padded * sizeof *high->ringingf.a);
  tabor_drum_destroy(drum);
}

/* While a stroke lasts, some 5 ms, its force meets modes that are off by some 100 Hz, where its
 * spectrum has other notches: a stroke by itself differs by 1 dB, one way or the other. */
enum { DRAWS = 8 };
static const double LEVEL = 0.5; /* [dB] of the mean of their energies */

static void scattering_neither_gives_energy_nor_takes_it(void **state) {
  (void)state;
  double energy[2] = {0.0, 0.0};
  for (uint32_t draw = 1; draw <= DRAWS; draw++) {
    for (int i = 0; i < 2; i++) {
      TaborDrum *drum = struck_drum(i ? 0.15 : 0.0, TABOR_QUALITY_LIVE, draw);
      TaborLedger ledger;
      tabor_drum_ledger(drum, &ledger);
      energy[i] += ledger.high_band;
      tabor_drum_destroy(drum);
    }
  }
  const double change = 10.0 * log10(energy[1] / energy[0]);
  if (!(fabs(change) < LEVEL)) fail_msg("%g dB", change);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_rate_is_that_of_random_phases_along_a_way),
    cmocka_unit_test(the_rate_grows_with_the_squares_of_unevenness_and_frequency),
    cmocka_unit_test(a_mode_keeps_its_amplitude),
    cmocka_unit_test(phases_are_lost_at_the_rate),
    cmocka_unit_test(modes_walk_as_the_head_scatters),
    cmocka_unit_test(an_even_head_scatters_nothing),
    cmocka_unit_test(scattering_neither_gives_energy_nor_takes_it),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
