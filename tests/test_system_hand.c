/* SPDX-License-Identifier: MIT */
/* A stick that a hand presses onto the head bounces: the harder, the faster. Its work is accounted for. */
#include "physics.h"

static const double RATE = 48000.0;

/* Makes a stroke of 1 m/s, presses it at once, and counts the contacts of `seconds`; times of the
 * first ones into at[]. */
static uint32_t count_hits(double pressure, double seconds, double *at, uint32_t room,
                           TaborLedger *ledger) {
  TaborDrumDef def = physics_preset("frame-drum");
  def.striker[0].mass = 0.0126; /* a rod of 50 g, 0.4 m, held 0.12 m from its butt */
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent events[2] = {
    {.type = TABOR_EVENT_STRIKE, .id = 5, .velocity = 1.0, .radius = 0.08},
    {.type = TABOR_EVENT_PRESS, .id = 5, .value = pressure}};
  uint32_t hits = 0;
  bool touching = false;
  for (uint32_t i = 0; i < (uint32_t)(seconds * RATE); i++) {
    tabor_drum_process(drum, events, i == 0 ? 2 : 0, NULL, 1);
    TaborProbe probe;
    tabor_drum_probe(drum, &probe);
    const bool touches = probe.striker_force > 0.0;
    if (touches && !touching) {
      if (hits < room) at[hits] = i / RATE;
      hits++;
    }
    touching = touches;
  }
  tabor_drum_ledger(drum, ledger);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return hits;
}

static void harder_pressure_bounces_faster(void **state) {
  (void)state;
  double last_gap = 1.0;
  for (double pressure = 0.0; pressure <= 0.7; pressure += 0.35) {
    double at[4] = {0.0};
    TaborLedger ledger;
    const uint32_t hits = count_hits(pressure, 0.6, at, 4, &ledger);
    const double gap = at[1] - at[0];
    print_message("pressure %.1f: %u contacts in 0.6 s, the first %.1f ms apart; hand %.3g J\n",
                  pressure, hits, 1e3 * gap, ledger.injected - 0.5 * 0.0126);
    assert_true(hits >= 2);
    assert_true(gap < last_gap);
    last_gap = gap;
    assert_true(fabs(ledger.residual) < 1e-9 * fabs(ledger.injected));
  }
}

/* In the limit of no hand at all, a flight of speed v under the force F0 lasts 2 M v/F0. */
static void a_light_press_brings_the_stick_back(void **state) {
  (void)state;
  double at[2] = {0.0};
  TaborLedger ledger;
  assert_true(count_hits(0.0, 0.3, at, 2, &ledger) >= 2);
  /* It leaves with at most the speed it came with: 84 ms at the longest, less by spring and loss. */
  assert_true(at[1] - at[0] > 0.01 && at[1] - at[0] < 2.0 * 0.0126 * 1.0 / 0.3);
}

static void a_released_stick_is_gone_and_the_drum_falls_silent(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("frame-drum");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent events[2] = {{.type = TABOR_EVENT_STRIKE, .id = 5, .velocity = 1.0},
                                {.type = TABOR_EVENT_PRESS, .id = 0, .value = 0.7}};
  const TaborEvent release = {.type = TABOR_EVENT_RELEASE, .id = 5};
  tabor_drum_process(drum, events, 2, NULL, 20000);
  TaborProbe probe;
  tabor_drum_probe(drum, &probe);
  assert_false(isnan(probe.striker));
  tabor_drum_process(drum, &release, 1, NULL, 1);
  tabor_drum_probe(drum, &probe);
  assert_true(isnan(probe.striker));
  for (int i = 0; i < 40 && !tabor_drum_is_silent(drum); i++) {
    tabor_drum_process(drum, NULL, 0, NULL, 9600);
  }
  assert_true(tabor_drum_is_silent(drum));
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  assert_true(fabs(ledger.residual) < 1e-9 * ledger.injected);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(harder_pressure_bounces_faster),
    cmocka_unit_test(a_light_press_brings_the_stick_back),
    cmocka_unit_test(a_released_stick_is_gone_and_the_drum_falls_silent),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
