/* SPDX-License-Identifier: MIT */
/* Friction of a hi-hat's edges, and a hand that chokes a cymbal: the rates at which they take motion,
 * the ledger, and when they rest. */
#include "step/edge_friction.h"

#include "drum/drum.h"
#include "physics.h"

static const double RATE = 48000.0;

/* Pressed together, without any other loss but the stick's. */
static TaborDrumDef pressed_def(double friction) {
  TaborDrumDef def = physics_preset("hihat-14");
  def.hihat.friction = friction;
  def.hihat.contact_loss = 0.0;
  def.hihat.opening = -4e-3;
  def.plate.large_deflections = 0.0;
  def.plate.damping_0 = def.bottom.damping_0 = def.plate.loss = def.bottom.loss = 0.0;
  def.plate.mount_damping = def.bottom.mount_damping = 0.0;
  def.batter.ring_strength = 0.0;
  def.air.density = 0.0;
  return def;
}

typedef struct Run {
  double begun, ended; /* of the modes after 20 and 120 ms [J] */
  double force;        /* of the edges at rest [N] */
  double residual;     /* of what came in */
} Run;

/* Energy of the modes that bend about where the edges hold them, a mean over 10 ms; a plate takes
 * longer to swing. */
static double mean_energy(TaborDrum *drum) {
  double sum = 0.0;
  for (uint32_t i = 0; i < 480; i++) {
    tabor_drum_process(drum, NULL, 0, NULL, 1);
    const TbView view = tb_view(drum->state, drum->model);
    for (uint32_t k = 0; k < drum->model->modes.padded; k++) {
      const uint32_t row = drum->model->modes.row[k];
      const bool bends = row != TB_NO_MODE && drum->model->body.modes[row].omega > 500.0;
      if (bends) sum += tb_mode_energy(&view, k) / 480.0;
    }
  }
  return sum;
}

static Run run(double friction, TaborQuality quality) {
  const TaborDrumDef def = pressed_def(friction);
  TaborModel *model = physics_model(&def, RATE, quality);
  TaborDrum *drum = physics_drum(model);
  TaborProbe probe;
  tabor_drum_probe(drum, &probe);
  Run run = {.force = probe.wire_force};
  const TaborEvent stroke = {
    .type = TABOR_EVENT_STRIKE, .velocity = 0.5, .radius = def.strike.radius};
  tabor_drum_process(drum, &stroke, 1, NULL, 960);
  run.begun = mean_energy(drum);
  tabor_drum_process(drum, NULL, 0, NULL, 4320);
  run.ended = mean_energy(drum);
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  run.residual = fabs(ledger.residual) / ledger.injected;
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return run;
}

/* Energy falls by e^(-2 s t), s = friction F, beside what it does without friction. */
static void motion_decays_with_the_force(void **state) {
  (void)state;
  static const double frictions[] = {0.05, 0.1, 0.2};
  const Run without = run(0.0, TABOR_QUALITY_STUDIO);
  for (uint32_t i = 0; i < 3; i++) {
    const Run with = run(frictions[i], TABOR_QUALITY_STUDIO);
    const double kept = with.ended / with.begun / (without.ended / without.begun);
    const double rate = -0.5 * log(kept) / 0.1, expected = frictions[i] * with.force;
    print_message("%.2f 1/(N s), %.1f N: %.3f 1/s, %.3f expected; residual %.2g\n", frictions[i],
                  with.force, rate, expected, with.residual);
    assert_true(fabs(rate / expected - 1.0) < 0.02);
    assert_true(with.residual < 1e-9);
  }
}

/* It acts while edges are pressed, not while they are apart, nor without losses. */
static void it_rests_without_pressure(void **state) {
  (void)state;
  for (uint32_t i = 0; i < 3; i++) {
    TaborDrumDef def = pressed_def(1.0);
    if (i == 1) def.hihat.opening = 8e-3;
    if (i == 2) def.quality.losses = 0;
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
    TaborDrum *drum = physics_drum(model);
    const TaborEvent stroke = {
      .type = TABOR_EVENT_STRIKE, .velocity = 0.5, .radius = def.strike.radius};
    tabor_drum_process(drum, &stroke, 1, NULL, 4800);
    uint32_t acted = 0;
    for (uint32_t step = 0; step < 64; step++) {
      tabor_drum_process(drum, NULL, 0, NULL, 1);
      TbView view = tb_view(drum->state, model);
      memcpy(view.next.q, view.now.q, model->modes.padded * sizeof(double));
      memcpy(view.next.eta, view.now.eta, tb_row_count(&model->rows) * sizeof(double));
      memcpy(view.next.v, view.now.v, model->wires.node_count * sizeof(double));
      acted += tb_edge_friction(&view);
    }
    assert_int_equal(acted, i == 0 ? 4 : 0);
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
}

/* A crash without other losses, struck and gripped after 20 ms with `strength`; its energy in the end
 * over that at first, 100 ms apart. */
static double choked(double strength, double *residual, double *damper) {
  TaborDrumDef def = physics_preset("crash-16");
  def.plate.damping_0 = def.plate.loss = def.plate.mount_damping = def.plate.large_deflections =
    0.0;
  def.batter.ring_strength = def.air.density = 0.0;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = {
    .type = TABOR_EVENT_STRIKE, .velocity = 4.0, .radius = def.strike.radius};
  const TaborEvent hand = {.type = TABOR_EVENT_DAMP, .id = 7, .radius = 0.19, .value = strength};
  const TaborEvent other = {.type = TABOR_EVENT_RELEASE, .id = 8};
  const TaborEvent away = {.type = TABOR_EVENT_RELEASE, .id = 7};
  tabor_drum_process(drum, &stroke, 1, NULL, 4800);
  tabor_drum_process(drum, &hand, 1, NULL, 960);
  const double begun = mean_energy(drum);
  tabor_drum_process(drum, &other, 1, NULL, 4320);
  const double ended = mean_energy(drum);
  tabor_drum_process(drum, &away, 1, NULL, 1); /* from then on nothing is lost */
  const double free = mean_energy(drum);
  tabor_drum_process(drum, NULL, 0, NULL, 4800);
  assert_true(fabs(mean_energy(drum) / free - 1.0) < 1e-3);
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  *residual = fabs(ledger.residual) / ledger.injected;
  *damper = ledger.damper_loss;
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return ended / begun;
}

/* Energy falls by e^(-2 R t/M), M the plate's mass: recorded chokes take 0.2 to 0.5 s for 60 dB. */
static void a_hand_on_the_edge_chokes(void **state) {
  (void)state;
  static const double strengths[] = {7.0, 15.0, 30.0};
  const TaborDrumDef def = physics_preset("crash-16");
  const double mean = def.plate.thickness * (1.0 + 2.0 * def.plate.taper) / 3.0;
  const double mass = def.plate.density * mean * 3.14159265358979 * pow(def.shell.radius, 2.0);
  double residual, damper;
  assert_true(fabs(choked(0.0, &residual, &damper) - 1.0) < 1e-3);
  for (uint32_t i = 0; i < 3; i++) {
    const double rate = -0.5 * log(choked(strengths[i], &residual, &damper)) / 0.1;
    print_message(
      "%.0f N s/m on %.3f kg: %.3f 1/s, %.3f expected, 60 dB in %.2f s; residual %.2g\n",
      strengths[i], mass, rate, strengths[i] / mass, 6.9 / rate, residual);
    assert_true(fabs(rate * mass / strengths[i] - 1.0) < 0.02);
    assert_true(residual < 1e-9 && damper > 0.0);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(motion_decays_with_the_force),
    cmocka_unit_test(it_rests_without_pressure),
    cmocka_unit_test(a_hand_on_the_edge_chokes),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
