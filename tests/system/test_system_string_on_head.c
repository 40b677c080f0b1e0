/* SPDX-License-Identifier: MIT */
/* The whole engine against an independent solution of one string on one head, struck by a stick:
 * lossless, in vacuo, modes below 3 kHz, 48 string cells (tests/reference/string_on_head.json). */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "reference.h"
#include "tabor/tabor.h"

static const double PI = 3.14159265358979323846;

/* Cap 16: the reference is fully converged. */
static void define(TaborDrumDef *def) {
  tabor_drum_def_default(def);
  def->shell.radius = 0.2;
  def->batter.tension = 3000.0;
  def->batter.surface_density = 0.26;
  def->batter.bending_stiffness = def->batter.stretch_stiffness = 0.0;
  const double radius = 0.29e-3, area = PI * radius * radius;
  def->wires.count = 1;
  def->wires.side = TABOR_SIDE_ABOVE;
  def->wires.length = 0.4;
  def->wires.angle = 0.0;
  def->wires.offset = 0.0;
  def->wires.mass_per_length = 7041.0 * area;
  def->wires.tension = 2.0;
  def->wires.bending_stiffness = 2e11 * PI * pow(radius, 4.0) / 4.0;
  def->wires.strainer = 1.0;
  def->wires.rest_offset = 0.0;
  def->wires.contact_stiffness = 1e8;
  def->wires.contact_exponent = 1.5;
  def->striker[0].mass = 0.028;
  def->striker[0].bending_frequency = 0.0;
  def->striker[0].contact_stiffness = 1e7;
  def->striker[0].contact_exponent = 2.0;
  def->striker[0].contact_radius = 0.0;
  def->air.density = 0.0;
  def->air.gravity = 0.0;
  def->quality.two_way_bandwidth = 3000.0;
  def->quality.bandwidth = 3000.0; /* no other modes are missing */
  def->quality.newton_cap = 16;
  def->quality.wire_points = 48;
  def->quality.losses = 0;
}

static double column(const json_t *run, const char *name, size_t row) {
  return reference_number(json_object_get(run, name), row);
}

static void first_ten_milliseconds_agree(void **state) {
  (void)state;
  TaborDrumDef def;
  define(&def);
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.quality = TABOR_QUALITY_REFERENCE;
  options.sample_rate = 24000.0; /* and steps at 48 kHz, as the solution beside */
  TaborError error = {0};
  TaborModel *model;
  TaborDrum *drum;
  if (tabor_model_create(&def, &options, &model, &error) != TABOR_OK) fail_msg("%s", error.message);
  assert_int_equal(tabor_drum_create(model, &drum, &error), TABOR_OK);
  TaborModelInfo info;
  tabor_model_info(model, &info);
  assert_int_equal(info.contact_points, 47);
  assert_true(info.step_rate == 48000.0);

  json_t *root = reference_load("string_on_head.json");
  json_t *run = json_object_get(json_object_get(root, "runs"), "48000");
  static const char *const names[5] = {"head_m", "wire_m", "striker_m", "striker_force_n",
                                       "wire_force_n"};
  const size_t rows = 120; /* 10 ms at 12 kHz */
  double peak[5] = {0.0}, worst[5] = {0.0};
  for (size_t row = 0; row < rows; row++) {
    for (int c = 0; c < 5; c++) peak[c] = fmax(peak[c], fabs(column(run, names[c], row)));
  }
  const TaborEvent strike = {.type = TABOR_EVENT_STRIKE, .velocity = 2.0, .radius = 0.13};
  for (size_t row = 0; row < rows; row++) {
    tabor_drum_process(drum, &strike, row == 0 ? 1 : 0, NULL, 2);
    TaborProbe probe;
    tabor_drum_probe(drum, &probe);
    const double ours[5] = {probe.head, probe.wire, probe.striker, probe.striker_force,
                            probe.wire_force};
    for (int c = 0; c < 5; c++) {
      const double theirs = column(run, names[c], row);
      const double mine = isnan(ours[c]) ? 0.0 : ours[c]; /* no striker in play: no force */
      worst[c] = fmax(worst[c], fabs(mine - theirs) / peak[c]);
    }
  }
  for (int c = 0; c < 5; c++) {
    print_message("%-16s peak %.4g, worst difference %.1e of it\n", names[c], peak[c], worst[c]);
  }
  for (int c = 0; c < 5; c++) assert_true(worst[c] < 1e-6);
  json_decref(root);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(first_ten_milliseconds_agree)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
