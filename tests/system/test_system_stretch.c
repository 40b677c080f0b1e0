/* SPDX-License-Identifier: MIT */
/* Heads that stretch: the frequency rises with amplitude as Duffing's oscillator has it, energy
 * stays.
 *
 * usage: test_system_stretch [brief]: one mode at one amplitude. */
#include "physics.h"

#include "drum/drum.h"
#include "heads/stretch.h"
#include "model/stretch_gain.h"

static const double PI = 3.14159265358979323846;
static const double RATE = 192000.0;
static bool brief;

/* Twice as many modes, all of which mix. */
static const TbStretchExtent WHOLE = {192.0, {0.0, INFINITY}};

static TaborDrumDef one_head(double stretch) {
  TaborDrumDef def = physics_preset("frame-drum");
  def.quality.losses = 0;
  def.air.gravity = 0.0;
  def.batter.stretch_stiffness = stretch;
  def.quality.two_way_bandwidth = 2000.0;
  return def;
}

/* Frequency [rad/s] at which mode `index` alone swings with this amplitude, from its zero
 * crossings. */
static double swing(const TaborModel *model, TaborDrum *drum, uint32_t index, double amplitude) {
  TbView view = tb_view(drum->state, model);
  view.now.q[index] = view.last.q[index] = amplitude;
  view.state->asleep = 0;
  double first = 0.0, last = 0.0, before = amplitude;
  uint32_t crossings = 0;
  for (uint32_t n = 1; n < 40000; n++) {
    tabor_drum_process(drum, NULL, 0, NULL, 1);
    view = tb_view(drum->state, model);
    const double q = view.now.q[index];
    if (before > 0.0 && q <= 0.0) {
      last = (double)n - q / (q - before);
      if (crossings++ == 0) first = last;
    }
    before = q;
  }
  return 2.0 * PI * (double)(crossings - 1) / ((last - first) / RATE);
}

/* q'' + w^2 q + beta q^3 = 0, beta = S G^2/(2A): w_nl/w = 1 + 3e/8 - 21 e^2/256, e = beta a^2/w^2
 * (Lindstedt and Poincare). */
static void one_mode_swings_like_duffings_oscillator(void **state) {
  (void)state;
  const TaborDrumDef def = one_head(1e6);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  for (uint32_t i = 0; i < model->modes.padded; i += 7) {
    if (model->modes.row[i] == TB_NO_MODE || model->modes.row[i] > 9) continue;
    const TbBodyMode *mode = &model->body.modes[model->modes.row[i]];
    const double gain = model->stretch.gain[0][i];
    const double beta = model->stretch.factor[0] * gain * gain;
    for (double e = 0.02; e < 0.3; e *= 2.0) {
      const double amplitude = sqrt(e) * mode->omega / sqrt(beta);
      TaborDrum *drum = physics_drum(model);
      const double ratio = swing(model, drum, i, amplitude) / mode->omega;
      tabor_drum_destroy(drum);
      const double expected = 1.0 + 3.0 * e / 8.0 - 21.0 * e * e / 256.0;
      print_message("(%u,%u) e %.2f: %.5f, expected %.5f\n", mode->m, mode->n, e, ratio, expected);
      assert_true(fabs(ratio - expected) < 2e-4 + 0.1 * e * e * e);
      if (brief) break;
    }
    if (brief) break;
  }
  tabor_model_release(model);
}

/* G of a lone Bessel function in vacuo: Int |grad w|^2 dA = K^2 Int w^2 dA = K^2/rho at unit mass.
 */
static void the_gain_of_a_mode_is_its_wavenumber_squared(void **state) {
  (void)state;
  TaborDrumDef def = one_head(1e6);
  def.air.density = 0.0;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    if (model->modes.row[i] == TB_NO_MODE) continue;
    const TbBodyMode *mode = &model->body.modes[model->modes.row[i]];
    if (mode->omega > 12.0 * model->body.modes[0].omega) continue; /* does not count */
    const double k = model->body.orders[mode->m].zeros[mode->n - 1] / def.shell.radius;
    assert_true(fabs(model->stretch.gain[0][i] * def.batter.surface_density / (k * k) - 1.0) <
                1e-9);
  }
  tabor_model_release(model);
}

/* q^T G q is Int |grad w|^2 dA, here by quadrature over the head, of a motion of a few modes of a
 * pair of heads. */
static double slope_integral(const TaborModel *model, uint32_t which, const double *q) {
  enum { RADII = 400, ANGLES = 48 };
  const double radius = model->body.radius, step = 1e-5 * radius;
  double *radial = calloc(model->body.row_count, sizeof *radial);
  double *shape = calloc(model->modes.padded, sizeof *shape), sum = 0.0;
  for (int i = 0; i < RADII; i++) {
    const double r = radius * (i + 0.5) / RADII;
    for (int a = 0; a < ANGLES; a++) {
      const double angle = 2.0 * PI * (a + 0.5) / ANGLES, turn = step / r;
      const double places[4][2] = {
        {r - step, angle}, {r + step, angle}, {r, angle - turn}, {r, angle + turn}};
      double w[4] = {0.0};
      for (int p = 0; p < 4; p++) {
        tb_modes_shape(&model->modes, &model->body, which, places[p][0], sin(places[p][1]),
                       cos(places[p][1]), NULL, radial, shape);
        for (uint32_t j = 0; j < model->modes.padded; j++) w[p] += q[j] * shape[j];
      }
      const double outward = (w[1] - w[0]) / (2.0 * step), around = (w[3] - w[2]) / (2.0 * step);
      sum += (outward * outward + around * around) * r * radius / RADII * 2.0 * PI / ANGLES;
    }
  }
  free(radial);
  free(shape);
  return sum;
}

static void the_matrix_is_the_integral_of_the_slopes(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("tom-12");
  def.quality.two_way_bandwidth = 700.0;
  def.shell.mass = 0.0; /* no edge that lifts the head */
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  assert_int_equal(tb_stretch_prepare_to(model, WHOLE), TABOR_OK);
  TaborDrum *drum = physics_drum(model);
  TbView view = tb_view(drum->state, model);
  uint64_t random = physics_seed();
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    if (model->modes.row[i] == TB_NO_MODE) continue;
    view.now.q[i] = view.next.q[i] = physics_uniform(&random, -1e-4, 1e-4);
  }
  /* stored energy: Sum_h S/(8A) (q^T G q)^2 */
  double expected = 0.0;
  for (uint32_t h = 0; h < model->stretch.count; h++) {
    const double slopes = slope_integral(model, model->stretch.head[h], view.now.q);
    expected += 0.25 * model->stretch.factor[h] * slopes * slopes;
  }
  drum->state->stretches = 1;
  const double stored = tb_stretch_energy(&view, &view.next, &view.now);
  print_message("stored %.6g J, by quadrature %.6g J\n", stored, expected);
  assert_true(fabs(stored / expected - 1.0) < 2e-3);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* The ledger closes to rounding. */
static void check_balance(const TaborDrum *drum) {
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  print_message("residual %g J of %g J\n", ledger.residual, ledger.injected);
  assert_true(fabs(ledger.residual) < 1e-11 * ledger.injected);
}

/* Struck hard, two heads, wires and all: a lossless drum keeps its energy to rounding. */
static void a_struck_drum_that_stretches_keeps_its_energy(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("tabor");
  def.quality.losses = 0;
  def.batter.tension = 1500.0;
  def.batter.stretch_stiffness = 1.2e6;
  TaborError error;
  assert_int_equal(tabor_drum_def_set(&def, "resonant.stretch_stiffness", "4e5", &error), TABOR_OK);
  def.shell.depth = 0.1;
  def.wires.head = TABOR_HEAD_RESONANT;
  def.wires.side = TABOR_SIDE_BELOW;
  def.quality.two_way_bandwidth = 2500.0;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  TaborEvent strike = physics_strike(&def);
  strike.velocity = 12.0;
  tabor_drum_process(drum, &strike, 1, NULL, 0);
  for (int block = 0; block < 100; block++) tabor_drum_process(drum, NULL, 0, NULL, 480);
  check_balance(drum);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Live stops the contact solve early and moves the forces to an exact balance: along the response
 * of the last forces, which a stretch that changes from sample to sample makes another. Hard
 * strokes one upon the other at a low rate, where it changes most. */
static void an_early_end_of_the_solve_knows_the_stretch(void **state) {
  (void)state;
  TaborDrumDef def = one_head(1e6);
  def.quality.losses = 1;
  TaborModel *model = physics_model(&def, 22050.0, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  TaborEvent strike = physics_strike(&def);
  for (int i = 0; i < 12; i++) {
    strike.velocity = 3.0 + 2.0 * i;
    strike.radius = 0.01 * i;
    tabor_drum_process(drum, &strike, 1, NULL, 380);
  }
  check_balance(drum);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* ---- enough modes ---------------------------------------------------------------------------- */

#define SOUND_RATE 48000.0
enum { SOUND = 9600, EARLY = 2400, BANDS = 14 };

/* |sum_i x_i exp(-2 pi j f i/rate)|^2 by the recurrence s_i = x_i + 2 cos(2 pi f/rate) s_(i-1) -
 * s_(i-2) [Goertzel]. */
static double line_power(const double *x, uint32_t count, double frequency) {
  const double twice = 2.0 * cos(2.0 * PI * frequency / SOUND_RATE);
  double s = 0.0, before = 0.0;
  for (uint32_t i = 0; i < count; i++) {
    const double next = x[i] + twice * s - before;
    before = s;
    s = next;
  }
  return s * s + before * before - twice * s * before;
}

/* A Hann window's part of a sound. */
static void window_sound(const float *sound, uint32_t count, double *x) {
  for (uint32_t i = 0; i < count; i++) {
    x[i] = (double)sound[i] * (0.5 - 0.5 * cos(2.0 * PI * i / count));
  }
}

/* Power of a third octave around `centre`. */
static double band_power(const double *x, uint32_t count, double centre) {
  const double low = centre * pow(2.0, -1.0 / 6.0), high = centre * pow(2.0, 1.0 / 6.0);
  const double spacing = SOUND_RATE / (2.0 * count);
  double sum = 0.0;
  for (double f = ceil(low / spacing) * spacing; f < high; f += spacing) {
    sum += line_power(x, count, f);
  }
  return sum;
}

/* Largest difference of the third octaves from 100 Hz to 2 kHz within 25 dB of the loudest [dB]. */
static double part_difference(const float *one, const float *other, uint32_t count) {
  static double x[2][SOUND];
  double own[BANDS], others[BANDS], most = 0.0, worst = 0.0;
  window_sound(one, count, x[0]);
  window_sound(other, count, x[1]);
  for (int b = 0; b < BANDS; b++) {
    const double centre = 1000.0 * pow(2.0, (b - 10) / 3.0);
    own[b] = band_power(x[0], count, centre);
    others[b] = band_power(x[1], count, centre);
    most = fmax(most, others[b]);
  }
  for (int b = 0; b < BANDS; b++) {
    if (others[b] > pow(10.0, -2.5) * most)
      worst = fmax(worst, fabs(10.0 * log10(own[b] / others[b])));
  }
  return worst;
}

/* `extent` NULL: the usual one. */
static TaborModel *model_with(const TaborDrumDef *def, uint32_t quality,
                              const TbStretchExtent *extent) {
  TaborModel *model = physics_model(def, SOUND_RATE, quality);
  if (extent) assert_int_equal(tb_stretch_prepare_to(model, *extent), TABOR_OK);
  return model;
}

static void strike_model(TaborModel *model, double velocity, double radius, float *sound) {
  float *outputs[TABOR_MAX_MICS] = {sound};
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = {.type = TABOR_EVENT_STRIKE,
                             .velocity = velocity,
                             .radius = radius * tabor_model_definition(model)->shell.radius,
                             .angle = 20.0};
  tabor_drum_process(drum, &strike, 1, outputs, SOUND);
  tabor_drum_destroy(drum);
}

/* In the first 50 ms and in the next 150 ms, of sounds of two models. */
static double difference_of(TaborModel *one, TaborModel *other, double velocity, double radius) {
  static float usual[SOUND], others[SOUND];
  strike_model(one, velocity, radius, usual);
  strike_model(other, velocity, radius, others);
  return fmax(part_difference(usual, others, EARLY),
              part_difference(usual + EARLY, others + EARLY, SOUND - EARLY));
}

/* Of the usual modes and of `extent`. */
static double difference_to(const TaborDrumDef *def, uint32_t quality, TbStretchExtent extent,
                            double velocity, double radius) {
  TaborModel *usual = model_with(def, quality, NULL), *other = model_with(def, quality, &extent);
  const double difference = difference_of(usual, other, velocity, radius);
  tabor_model_release(usual);
  tabor_model_release(other);
  return difference;
}

static void compare_whole(const char *preset) {
  static const double places[] = {0.06, 0.35, 0.7};
  const TaborDrumDef def = physics_preset(preset);
  TaborModel *usual = model_with(&def, TABOR_QUALITY_LIVE, NULL),
             *whole = model_with(&def, TABOR_QUALITY_LIVE, &WHOLE);
  for (size_t place = 0; place < (brief ? 1 : sizeof places / sizeof *places); place++) {
    for (double velocity = 2.0; velocity < 11.0; velocity += 4.0) {
      const double worst = difference_of(usual, whole, velocity, places[place]);
      print_message("%s, %g m/s at %g of the radius: %.2f dB\n", preset, velocity, places[place],
                    worst);
      assert_true(worst < 1.5);
    }
  }
  tabor_model_release(usual);
  tabor_model_release(whole);
}

/* Twice as many modes and the whole matrix change a sound by less than 1.5 dB at live; so few modes
 * as up to 24 times the lowest frequency, which the same measure must find, by more, and so does
 * the diagonal of the matrix alone. */
static void enough_modes_stretch(void **state) {
  (void)state;
  static const char *const presets[] = {"bass-drum-22", "floor-tom-16", "tom-12", "timpani-26",
                                        "snare-14x5.5-off"};
  for (size_t i = 0; i < (brief ? 1 : sizeof presets / sizeof *presets); i++) {
    compare_whole(presets[i]);
  }
  const TaborDrumDef bass = physics_preset("bass-drum-22");
  const TbStretchExtent few = {24.0, {0.02, INFINITY}}, diagonal = {96.0, {0.0, 0.0}};
  assert_true(difference_to(&bass, TABOR_QUALITY_LIVE, few, 10.0, 0.06) > 3.0);
  assert_true(difference_to(&bass, TABOR_QUALITY_LIVE, diagonal, 10.0, 0.06) > 3.0);
}

/* The same at studio by less than 0.5 dB, for what differs most. */
static void studio_stretches_more_exactly(void **state) {
  (void)state;
  static const struct {
    const char *preset;
    double velocity, radius;
  } strokes[] = {
    {"bass-drum-22", 2.0, 0.06}, {"bass-drum-22", 10.0, 0.06}, {"floor-tom-16", 10.0, 0.7}};
  for (size_t i = 0; i < (brief ? 1 : sizeof strokes / sizeof *strokes); i++) {
    const TaborDrumDef def = physics_preset(strokes[i].preset);
    const double worst =
      difference_to(&def, TABOR_QUALITY_STUDIO, WHOLE, strokes[i].velocity, strokes[i].radius);
    print_message("%s at studio: %.2f dB\n", strokes[i].preset, worst);
    assert_true(worst < 0.5);
  }
}

/* Studio has twice the modes of live, and two steps a sample. */
static void live_stretches_as_studio_does(void **state) {
  (void)state;
  static float live[SOUND], studio[SOUND];
  const TaborDrumDef def = physics_preset("bass-drum-22");
  TaborModel *const models[] = {model_with(&def, TABOR_QUALITY_LIVE, NULL),
                                model_with(&def, TABOR_QUALITY_STUDIO, NULL)};
  strike_model(models[0], 10.0, 0.06, live);
  strike_model(models[1], 10.0, 0.06, studio);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
  const double early = part_difference(live, studio, EARLY);
  const double late = part_difference(live + EARLY, studio + EARLY, SOUND - EARLY);
  print_message("live against studio: %.2f and %.2f dB\n", early, late);
  assert_true(early < 1.5 && late < 1.5);
}

/* ---- heads that have died away are linear ---------------------------------------------------- */

enum { LONG = 67200, TAIL = 19200 }; /* snares off: linear after 0.9 s, asleep after 1.5 s */

/* A drum that always stretches, or one that stops as usual. */
static TaborDrum *drum_that(bool always, const TaborDrumDef *def, TaborModel **model) {
  *model = physics_model(def, SOUND_RATE, TABOR_QUALITY_LIVE);
  if (always) (*model)->stretch.hold = UINT32_MAX;
  return physics_drum(*model);
}

static bool is_linear(const TaborDrum *drum, const TaborModel *model) {
  return drum->state->unstretched > model->stretch.hold;
}

static void check_residual(const TaborDrum *drum) {
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  print_message("residual %.2g J of %.2g J\n", ledger.residual, ledger.injected);
  assert_true(fabs(ledger.residual) < physics_residual(TABOR_QUALITY_LIVE) * ledger.injected);
}

static double power(const float *x, const float *less) {
  double sum = 0.0;
  for (int i = 0; i < TAIL; i++) {
    const double value = (double)x[i] - (less ? (double)less[i] : 0.0);
    sum += value * value;
  }
  return sum;
}

/* Where the tension's rise falls below a part e, with a rate of 2 sigma, the phase at f is late by
 * pi f e/(2 sigma) in all: 0.01 at 300 Hz for e = 1e-4, twice what is let go, and a decay by 60 dB
 * in 1.2 s. */
static void a_drum_that_has_died_away_is_linear(void **state) {
  (void)state;
  static const char *const presets[] = {"tom-12", "snare-14x5.5-off"};
  static float sound[2][LONG];
  for (size_t i = 0; i < (brief ? 1 : sizeof presets / sizeof *presets); i++) {
    const TaborDrumDef def = physics_preset(presets[i]);
    const TaborEvent strike = physics_strike(&def);
    for (int always = 0; always < 2; always++) {
      TaborModel *model;
      TaborDrum *drum = drum_that(always, &def, &model);
      float *outputs[TABOR_MAX_MICS] = {sound[always]};
      tabor_drum_process(drum, &strike, 1, outputs, LONG - TAIL);
      assert_int_equal(is_linear(drum, model), !always);
      outputs[0] += LONG - TAIL;
      tabor_drum_process(drum, NULL, 0, outputs, TAIL);
      check_residual(drum);
      tabor_drum_destroy(drum);
      tabor_model_release(model);
    }
    const float *tail = sound[0] + LONG - TAIL, *other = sound[1] + LONG - TAIL;
    const double away = sqrt(power(tail, other) / power(other, NULL));
    print_message("%s: the tail differs by a part of %.2g\n", presets[i], away);
    assert_true(away > 0.0 && away < 0.02);
  }
}

/* Sound from outside, on the lowest mode: first so faint that the drum is linear, then of this
 * pressure [Pa]. */
static void drive_linear_head(const char *preset, double pressure) {
  enum { FAINT = 24000, ALL = 48000 };
  static float air[ALL], sound[2][ALL];
  const TaborDrumDef def = physics_preset(preset);
  for (int always = 0; always < 2; always++) {
    TaborModel *model;
    TaborDrum *drum = drum_that(always, &def, &model);
    const double omega = model->body.modes[0].omega;
    for (int i = 0; i < ALL; i++) {
      air[i] = (float)((i < FAINT ? 0.01 : pressure) * sin(omega * i / SOUND_RATE));
    }
    float *outputs[TABOR_MAX_MICS] = {sound[always]};
    TaborSound outside = {.mic = 0, .pressure = air};
    tabor_drum_process_sound(drum, NULL, 0, &outside, outputs, FAINT);
    assert_int_equal(is_linear(drum, model), !always);
    outside.pressure += FAINT;
    outputs[0] += FAINT;
    tabor_drum_process_sound(drum, NULL, 0, &outside, outputs, ALL - FAINT);
    assert_false(is_linear(drum, model));
    check_residual(drum);
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
  const float *tail = sound[0] + ALL - TAIL, *other = sound[1] + ALL - TAIL;
  const double away = sqrt(power(tail, other) / power(other, NULL));
  print_message("%s, %g Pa: the sound differs by a part of %.2g\n", preset, pressure, away);
  assert_true(away > 0.0 && away < 0.02);
}

/* Loud at once, and just not loud. */
static void air_stretches_a_linear_head(void **state) {
  (void)state;
  drive_linear_head("tom-12", 200.0);
  drive_linear_head("bass-drum-22", 28.0);
}

int main(int argc, char **argv) {
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(one_mode_swings_like_duffings_oscillator),
    cmocka_unit_test(the_gain_of_a_mode_is_its_wavenumber_squared),
    cmocka_unit_test(the_matrix_is_the_integral_of_the_slopes),
    cmocka_unit_test(a_struck_drum_that_stretches_keeps_its_energy),
    cmocka_unit_test(an_early_end_of_the_solve_knows_the_stretch),
    cmocka_unit_test(enough_modes_stretch),
    cmocka_unit_test(studio_stretches_more_exactly),
    cmocka_unit_test(live_stretches_as_studio_does),
    cmocka_unit_test(a_drum_that_has_died_away_is_linear),
    cmocka_unit_test(air_stretches_a_linear_head),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
