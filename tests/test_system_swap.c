/* SPDX-License-Identifier: MIT */
/* Models exchanged under a ringing drum: no parametric pump. */
#include "physics.h"

static TaborDrumDef two_heads(void) {
  TaborDrumDef def = physics_preset("frame-drum");
  def.two_headed = 1;
  def.shell.depth = 0.1;
  def.quality.losses = 0;
  def.quality.two_way_bandwidth = 3000.0;
  for (uint32_t i = 0; i < def.mic_count; i++) def.mic[i].height = 0.1 + 0.1 * i;
  return def;
}

static double stored(const TaborDrum *drum) {
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  return ledger.stored;
}

static void exchange(TaborDrum *drum, TaborModel *from, TaborModel *to) {
  TaborSwap *swap;
  TaborError error;
  assert_int_equal(tabor_swap_create(from, to, &swap, &error), TABOR_OK);
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(drum, &event, 1, NULL, 64);
  assert_true(tabor_swap_done(swap));
  tabor_swap_destroy(swap);
}

/* Phase and action are kept per mode, so the energy follows the frequencies: it swings by sqrt(1.1) at
 * most and comes back, but for the modes that only one of the models keeps. Carrying displacements over
 * multiplied it by 2e9 in this second. */
static void a_tension_toggled_by_ten_per_cent_pumps_no_energy(void **state) {
  (void)state;
  for (int head = 0; head < 2; head++) {
    TaborDrumDef def = two_heads(), tense = def;
    (head ? &tense.resonant : &tense.batter)->tension *= 1.1;
    TaborModel *models[2] = {physics_model(&def, 48000.0, TABOR_QUALITY_LIVE),
                             physics_model(&tense, 48000.0, TABOR_QUALITY_LIVE)};
    TaborDrum *drum = physics_drum(models[0]);
    const TaborEvent strike = physics_strike(&def);
    tabor_drum_process(drum, &strike, 1, NULL, 4800); /* the stick is gone by then */
    const double start = stored(drum);
    double most = start;
    for (int toggle = 0; toggle < 750; toggle++) {
      exchange(drum, models[toggle % 2], models[1 - toggle % 2]);
      most = fmax(most, stored(drum));
    }
    print_message("%s: energy rises to %.4f of its start at most, ends at %.6f\n",
                  head ? "resonant" : "batter", most / start, stored(drum) / start);
    assert_true(most < sqrt(1.1) * start * (1.0 + 1e-9));
    assert_true(fabs(stored(drum) / start - 1.0) < 1e-4);
    TaborLedger ledger;
    tabor_drum_ledger(drum, &ledger);
    assert_true(fabs(ledger.residual) < 1e-9 * (ledger.injected + fabs(ledger.control)));
    tabor_drum_destroy(drum);
    for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
  }
}

/* Made for another model, it cannot act: the drum stays as it is, and the swap may be freed. */
static void a_swap_for_another_model_is_dropped_and_done(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("frame-drum");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT),
             *other = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  TaborSwap *swap;
  TaborError error;
  assert_int_equal(tabor_swap_create(other, model, &swap, &error), TABOR_OK);
  assert_false(tabor_swap_done(swap));
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(drum, &event, 1, NULL, 64);
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.dropped_events, 1);
  assert_ptr_equal(tabor_drum_model(drum), model);
  assert_true(tabor_swap_done(swap));
  tabor_swap_destroy(swap);
  tabor_drum_destroy(drum);
  tabor_model_release(other);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_tension_toggled_by_ten_per_cent_pumps_no_energy),
    cmocka_unit_test(a_swap_for_another_model_is_dropped_and_done),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
