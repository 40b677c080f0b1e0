/* SPDX-License-Identifier: MIT */
/* A drum whose lugs pull unevenly: its modes come apart as an independent computation says, it
 * sounds so, its energy is accounted for, and an even drum keeps every bit.
 *
 * usage: test_system_lugs [brief]: fewer of the ways that end alike. */
#include "physics.h"

#include "bodies/drum/lug_tension.h"
#include "reference.h"

static const double PI = 3.14159265358979323846;
static const double RATE = 48000.0;

static bool brief;

/* ---- frequencies ---------------------------------------------------------------------------- */

/* A frequency as the zero of a Bessel function that an even membrane would have there. */
static double as_zero(const TaborDrumDef *def, double frequency) {
  const double speed = sqrt(def->batter.tension / def->batter.surface_density);
  return 2.0 * PI * frequency * def->shell.radius / speed;
}

static void expect_case(const char *name, const json_t *one) {
  TaborDrumDef def = physics_membrane();
  const json_t *lugs = json_object_get(one, "deviations");
  def.batter.lug_count = (uint32_t)json_array_size(lugs);
  for (uint32_t j = 0; j < def.batter.lug_count; j++) def.batter.lug[j] = reference_number(lugs, j);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  const json_t *wanted = json_object_get(one, "z");
  double worst = 0.0, z[16];
  for (uint32_t row = 0; row < 16; row++) {
    TaborModeInfo mode;
    assert_true(tabor_model_mode(model, row, &mode));
    assert_int_equal(mode.multiplicity, 1);
    z[row] = as_zero(&def, mode.frequency);
    worst = fmax(worst, fabs(z[row] / reference_number(wanted, row) - 1.0));
  }
  const json_t *first = json_object_get(one, "first_order_11");
  const double split = z[2] * z[2] - z[1] * z[1], even = 3.83170597 * 3.83170597;
  const double predicted = (reference_number(first, 1) - reference_number(first, 0)) * even;
  print_message("%s: 16 modes right to %.1e; (1,1) splits by %.4f %%, to first order %.4f %%\n",
                name, worst, 50.0 * split / even, 50.0 * predicted / even);
  assert_true(worst < 5e-5); /* modes above the coupled ones would push these by half of that */
  /* A lug of 10 % or an odd number of lugs adds second order to the first. */
  if (strcmp(name, "drawn") == 0) assert_true(fabs(split / predicted - 1.0) < 0.05);
  tabor_model_release(model);
}

static void modes_come_apart_as_an_independent_computation_says(void **state) {
  (void)state;
  json_t *root = reference_load("uneven_lugs.json");
  const char *name;
  json_t *one;
  json_object_foreach(json_object_get(root, "cases"), name, one) expect_case(name, one);
  json_decref(root);
}

static void the_draw_is_that_of_the_reference(void **state) {
  (void)state;
  json_t *root = reference_load("uneven_lugs.json");
  const json_t *drawn =
    json_object_get(json_object_get(json_object_get(root, "cases"), "drawn"), "deviations");
  TaborDrumDef def = physics_membrane();
  def.batter.lug_spread = 0.05;
  double deviation[TABOR_MAX_LUGS];
  tb_lug_deviations(&def.batter, deviation);
  for (uint32_t j = 0; j < 10; j++) {
    assert_true(fabs(deviation[j] - reference_number(drawn, j)) < 1e-15);
  }
  json_decref(root);
}

/* ---- sound ---------------------------------------------------------------------------------- */

enum { SECONDS = 8, FRAMES = SECONDS * 48000 };

static void sound_of(const TaborDrumDef *def, double angle, float *out) {
  TaborModel *model = physics_model(def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = {
    .type = TABOR_EVENT_STRIKE, .velocity = 0.3, .radius = 0.6 * def->shell.radius, .angle = angle};
  float *outputs[TABOR_MAX_MICS] = {out};
  tabor_drum_process(drum, &strike, 1, outputs, FRAMES);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Amplitude at a frequency, through Hann's window. */
static double amplitude(const float *x, double frequency) {
  double re = 0.0, im = 0.0;
  for (uint32_t i = 0; i < FRAMES; i += 8) { /* 6 kHz hold the drum's lowest modes */
    const double window = 0.5 - 0.5 * cos(2.0 * PI * i / FRAMES);
    const double turn = 2.0 * PI * frequency * i / RATE;
    re += window * x[i] * cos(turn);
    im += window * x[i] * sin(turn);
  }
  return hypot(re, im);
}

/* The frequency of the largest amplitude between `from` and `to`. */
static double peak(const float *x, double from, double to) {
  double best = from, most = 0.0;
  for (double step = 0.05; step > 1e-3; step *= 0.1) {
    for (double f = from; f <= to; f += step) {
      const double a = amplitude(x, f);
      if (a > most) {
        most = a;
        best = f;
      }
    }
    from = best - step;
    to = best + step;
  }
  return best;
}

/* Lug 3 of 10 stands at 90 degrees: tightened, it raises the mode that moves along it and no other.
 */
static void each_mode_of_a_pair_sounds_at_its_own_pitch_and_axis(void **state) {
  (void)state;
  static float x[FRAMES];
  TaborDrumDef def = physics_preset("frame-drum");
  def.quality.losses = 0;
  def.quality.two_way_bandwidth = 1500.0;
  def.batter.stretch_stiffness = 0.0;
  def.batter.lug_count = 10;
  def.batter.lug[2] = 0.1;
  /* the modes' own axes do not matter */
  for (double turned = brief ? 20.0 : 0.0; turned <= 20.0; turned += 20.0) {
    def.wires.angle = turned;
    for (uint32_t sine = 0; sine < 2; sine++) {
      TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
      TaborModeInfo mode;
      assert_true(tabor_model_mode(model, 1 + sine, &mode) && mode.m == 1);
      tabor_model_release(model);
      def.mic[0].angle = 90.0 * sine;
      def.mic[0].radius = 0.1;
      sound_of(&def, 90.0 * sine, x);
      const double heard = peak(x, mode.frequency - 2.0, mode.frequency + 2.0);
      print_message("struck at %.0f degrees: %.3f Hz, listed %.3f Hz\n", 90.0 * sine, heard,
                    mode.frequency);
      assert_true(fabs(heard - mode.frequency) < 0.02);
    }
  }
}

/* ---- energy and bits ------------------------------------------------------------------------ */

static TaborDrumDef uneven_snare(double spread) {
  TaborDrumDef def = physics_preset("snare-14x5.5");
  def.batter.lug_spread = spread;
  def.resonant.lug_spread = spread;
  def.resonant.lug_seed = 9;
  return def;
}

static void render(const TaborDrumDef *def, uint32_t instructions, uint32_t block, float *out,
                   uint32_t frames, TaborLedger *ledger) {
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_DRAFT;
  options.instructions = instructions;
  TaborModel *model;
  TaborError error = {0};
  if (tabor_model_create(def, &options, &model, &error) != TABOR_OK) fail_msg("%s", error.message);
  TaborDrum *drum = physics_drum(model);
  TaborEvent strike = physics_strike(def);
  strike.velocity = 5.0;
  strike.angle = 33.0;
  for (uint32_t done = 0; done < frames; done += block) {
    const uint32_t size = frames - done < block ? frames - done : block;
    float *outputs[TABOR_MAX_MICS] = {out + done};
    tabor_drum_process(drum, &strike, done == 0, outputs, size);
  }
  tabor_drum_ledger(drum, ledger);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

enum { SHORT = 9600 };

static void its_energy_is_accounted_for_at_every_cap(void **state) {
  (void)state;
  static float x[SHORT];
  for (uint32_t cap = 1; cap <= 4; cap += brief ? 3 : 1) {
    for (uint32_t losses = 0; losses < 2; losses++) {
      TaborDrumDef def = uneven_snare(0.2);
      def.quality.newton_cap = cap;
      def.quality.losses = losses;
      TaborLedger ledger;
      render(&def, TABOR_INSTRUCTIONS_AUTO, 64, x, SHORT, &ledger);
      const double bound = physics_residual(TABOR_QUALITY_DRAFT) * ledger.injected;
      print_message("cap %u, losses %u: residual %.2g of what was put in\n", cap, losses,
                    ledger.residual / ledger.injected);
      assert_true(ledger.residual >= -bound);
      if (cap == 4) assert_true(ledger.residual < bound);
    }
  }
}

static void blocks_and_instructions_do_not_matter(void **state) {
  (void)state;
  static float x[SHORT], y[SHORT];
  const TaborDrumDef def = uneven_snare(0.05);
  TaborLedger ledger;
  render(&def, TABOR_INSTRUCTIONS_AUTO, SHORT, x, SHORT, &ledger);
  for (uint32_t block = brief ? 73 : 1; block < 1000; block = 7 * block + 3) {
    render(&def, TABOR_INSTRUCTIONS_BASELINE + block % 2, block, y, SHORT, &ledger);
    assert_memory_equal(x, y, sizeof x);
  }
}

static void an_even_drum_keeps_every_bit(void **state) {
  (void)state;
  static float x[SHORT], y[SHORT];
  TaborDrumDef def = uneven_snare(0.0);
  TaborLedger ledger;
  render(&def, TABOR_INSTRUCTIONS_AUTO, 64, x, SHORT, &ledger);
  def.batter.lug_count = 6;
  def.batter.lug[5] = 0.0;
  def.resonant.lug_seed = 4;
  render(&def, TABOR_INSTRUCTIONS_AUTO, 64, y, SHORT, &ledger);
  assert_memory_equal(x, y, sizeof x);
  def.batter.lug[5] = 0.01;
  render(&def, TABOR_INSTRUCTIONS_AUTO, 64, y, SHORT, &ledger);
  assert_memory_not_equal(x, y, sizeof x);
}

/* ---- refusals ------------------------------------------------------------------------------- */

static void slack_heads_and_absent_lugs_are_refused_by_name(void **state) {
  (void)state;
  TaborDrumDef def = physics_membrane();
  TaborError error;
  TaborModel *model;
  def.batter.lug_count = 8;
  for (uint32_t j = 0; j < 8; j++) def.batter.lug[j] = -0.5; /* loose all around, and yet a drum */
  assert_int_equal(tabor_model_create(&def, NULL, &model, &error), TABOR_OK);
  tabor_model_release(model);
  static const double FOLDED[8] = {-0.5, 0.5, 0.5, 0.5, -0.5, -0.5, -0.5, -0.5};
  memcpy(def.batter.lug, FOLDED, sizeof FOLDED);
  assert_int_equal(tabor_model_create(&def, NULL, &model, &error), TABOR_ERROR_RANGE);
  assert_string_equal(error.key, "batter.lug_spread");
  assert_non_null(strstr(error.message, "batter head goes slack"));
  def = physics_membrane();
  def.batter.lug_count = 8;
  def.batter.lug[8] = 0.01;
  assert_int_equal(tabor_drum_def_validate(&def, &error), TABOR_ERROR_RANGE);
  assert_string_equal(error.key, "batter.lug_9");
}

int main(int count, char **words) {
  brief = count > 1 && strcmp(words[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(modes_come_apart_as_an_independent_computation_says),
    cmocka_unit_test(the_draw_is_that_of_the_reference),
    cmocka_unit_test(each_mode_of_a_pair_sounds_at_its_own_pitch_and_axis),
    cmocka_unit_test(its_energy_is_accounted_for_at_every_cap),
    cmocka_unit_test(blocks_and_instructions_do_not_matter),
    cmocka_unit_test(an_even_drum_keeps_every_bit),
    cmocka_unit_test(slack_heads_and_absent_lugs_are_refused_by_name),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
