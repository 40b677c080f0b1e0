/* SPDX-License-Identifier: MIT */
/* Modes of drums with air inside, in the air outside: against an independent boundary-element code,
 * and a timpano's published frequencies. */
#include <jansson.h>

#include "physics.h"

static double number(const json_t *object, const char *key) {
  const json_t *value = json_object_get(object, key);
  assert_non_null(value);
  return json_number_value(value);
}

static void set_head(TaborHeadDef *head, const json_t *from) {
  head->tension = number(from, "tension_N_per_m");
  head->surface_density = number(from, "surface_density_kg_per_m2");
  head->bending_stiffness = number(from, "bending_stiffness_N_m");
}

static TaborDrumDef drum_of(const json_t *drum) {
  TaborDrumDef def = physics_membrane();
  def.shell.radius = number(drum, "radius_m");
  def.shell.depth = number(drum, "depth_m");
  def.two_headed = 1;
  set_head(&def.batter, json_object_get(drum, "both heads"));
  def.resonant = def.batter;
  def.air.density = number(drum, "air_density");
  def.air.sound_speed = number(drum, "sound_speed");
  return def;
}

/* The mode of order m whose frequency is nearest. */
static TaborModeInfo nearest_mode(const TaborModel *model, uint32_t m, double frequency) {
  TaborModeInfo nearest = {.frequency = 0.0}, mode;
  for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
    if (mode.m == m && fabs(mode.frequency - frequency) < fabs(nearest.frequency - frequency)) {
      nearest = mode;
    }
  }
  return nearest;
}

/* Frequencies within 0.5 %; radiative decays within 1.15 times or 0.1 1/s, whichever is more. */
static void two_heads_radiate_as_boundary_elements_say(void **state) {
  (void)state;
  json_t *root = json_load_file(TABOR_TEST_DATA "/reference/two_head_radiation.json", 0, NULL);
  assert_non_null(root);
  const TaborDrumDef def = drum_of(json_object_get(root, "drum"));
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  size_t i;
  json_t *wanted;
  json_array_foreach(json_object_get(root, "modes"), i, wanted) {
    const double frequency = number(wanted, "frequency");
    const double decay = number(wanted, "radiation_decay_per_s");
    const TaborModeInfo mode = nearest_mode(model, (uint32_t)number(wanted, "m"), frequency);
    print_message("(%u,%u) %7.2f Hz, %+.3f %%; decays by %7.4f 1/s, %.3f times\n", mode.m, mode.n,
                  mode.frequency, 100.0 * (mode.frequency / frequency - 1.0), mode.radiation_rate,
                  mode.radiation_rate / decay);
    assert_true(fabs(mode.frequency / frequency - 1.0) < 5e-3);
    const double ratio = fmax(mode.radiation_rate / decay, decay / mode.radiation_rate);
    assert_true(ratio < 1.15 || fabs(mode.radiation_rate - decay) < 0.1);
  }
  tabor_model_release(model);
  json_decref(root);
}

/* The preset has the published kettle and head; its tension puts (1,1) near the published 150 Hz.
 */
static void a_timpano_has_its_published_frequencies(void **state) {
  (void)state;
  static const struct {
    uint32_t m;
    double frequency;
  } published[] = {{0, 127.0}, {1, 150.0}, {2, 227.0}, {0, 252.0}, {3, 298.0}};
  const TaborDrumDef def = physics_preset("timpani-26");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  for (int i = 0; i < 5; i++) {
    const TaborModeInfo mode = nearest_mode(model, published[i].m, published[i].frequency);
    print_message("(%u,%u) %.1f Hz, published %.0f\n", mode.m, mode.n, mode.frequency,
                  published[i].frequency);
    assert_true(fabs(mode.frequency / published[i].frequency - 1.0) < 0.02);
  }
  tabor_model_release(model);
}

static double decay_near(double surface_density, uint32_t m, double frequency) {
  TaborDrumDef def = physics_preset("tom-12");
  def.shell.surface_density = surface_density;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  const double rate = nearest_mode(model, m, frequency).decay_rate;
  tabor_model_release(model);
  return rate;
}

/* Of air that sloshes from side to side a wall twice as heavy lets a quarter through; of air that
 * is squeezed all round, whose pressure the wall bears as a hoop, it lets next to nothing through.
 */
static void a_heavy_wall_keeps_sound_in(void **state) {
  (void)state;
  double taken[2][2];
  for (uint32_t m = 0; m < 2; m++) {
    const double frequency = m ? 650.0 : 250.0, rigid = decay_near(1000.0, m, frequency);
    for (int i = 0; i < 2; i++) taken[m][i] = decay_near(i ? 4.0 : 2.0, m, frequency) - rigid;
    print_message("order %u: the wall takes %.4f 1/s, %.4f if twice as heavy\n", m, taken[m][0],
                  taken[m][1]);
  }
  assert_true(taken[1][0] > 0.1 && fabs(taken[1][0] / taken[1][1] - 4.0) < 0.2);
  assert_true(taken[0][0] >= 0.0 && taken[0][0] < 0.01);
}

static double decay_lined(double absorption, uint32_t m, double frequency) {
  TaborDrumDef def = physics_preset("tom-12");
  def.shell.surface_density = 1000.0;
  def.shell.absorption = absorption;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  const double rate = nearest_mode(model, m, frequency).decay_rate;
  tabor_model_release(model);
  return rate;
}

/* A lining of the admittance of a wall that lets sound through takes as much, in proportion to its
 * absorption. */
static void a_lining_takes_what_its_admittance_says(void **state) {
  (void)state;
  const double bare = decay_lined(0.0, 1, 650.0);
  const double little = decay_lined(0.1, 1, 650.0) - bare, much = decay_lined(0.4, 1, 650.0) - bare;
  TaborDrumDef def = physics_preset("tom-12");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  const double frequency = nearest_mode(model, 1, 650.0).frequency;
  tabor_model_release(model);
  const double reactance = 2.0 * 3.14159265358979 * frequency * 4.2 / (1.205 * 343.0);
  const double wall = decay_near(4.2, 1, 650.0) - decay_near(1000.0, 1, 650.0);
  const double expected = wall * (1.0 + reactance * reactance) * 0.1 / 8.0 /
                          (1.0 + 400.0 * 400.0 / (frequency * frequency));
  print_message("a lining of 0.1 takes %.3f 1/s, by its admittance %.3f\n", little, expected);
  assert_true(fabs(much / little - 4.0) < 1e-6);
  assert_true(fabs(little / expected - 1.0) < 1e-3);
}

/* Without air, modes of both heads have the loss factors sigma_k/c of these. */
static void in_vacuo_each_head_has_its_loss_factor(void **state) {
  (void)state;
  TaborDrumDef def = physics_membrane();
  def.two_headed = 1;
  def.resonant = def.batter;
  def.resonant.tension = 2345.0;
  def.batter.damping_k = 0.3;
  def.resonant.damping_k = 0.1;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  uint32_t rows[2] = {0};
  TaborModeInfo mode;
  for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
    assert_true(mode.part == TABOR_PART_BATTER || mode.part == TABOR_PART_RESONANT);
    const uint32_t h = mode.part == TABOR_PART_RESONANT;
    const TaborHeadDef *head = h ? &def.resonant : &def.batter;
    const double factor = head->damping_k / sqrt(head->tension / head->surface_density);
    const double seen = 2.0 * mode.decay_rate / (2.0 * 3.14159265358979323846 * mode.frequency);
    assert_true(fabs(seen / factor - 1.0) < 1e-9);
    rows[h]++;
  }
  assert_true(rows[0] > 100 && rows[1] > 100);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(two_heads_radiate_as_boundary_elements_say),
    cmocka_unit_test(a_timpano_has_its_published_frequencies),
    cmocka_unit_test(a_heavy_wall_keeps_sound_in),
    cmocka_unit_test(a_lining_takes_what_its_admittance_says),
    cmocka_unit_test(in_vacuo_each_head_has_its_loss_factor),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
