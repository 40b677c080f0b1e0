/* SPDX-License-Identifier: MIT */
/* The drum that [Rossing1992] measured: 14 inch wide, its heads coupled by the air between them.
 * They give the pairs of frequencies; tensions and depth are fitted here, one value for each head,
 * to six of them. */
#include "physics.h"

/* Within 5 %: the heads' masses, the shell's give and the table under the drum are not known. */
static const double NEARNESS = 0.05;

typedef struct Measured {
  uint32_t m;
  double low, high; /* [Hz] */
} Measured;

static const Measured PAIRS[] = {{0, 182.0, 330.0}, {1, 278.0, 341.0}, {2, 403.0, 512.0}};

/* A 6.5 inch shell, 10 mil of Mylar above and 3 mil below. */
static TaborDrumDef measured_drum(void) {
  TaborDrumDef def = physics_preset("snare-14x5.5");
  def.shell.depth = 0.1651;
  def.batter.tension = 3490.0;
  def.resonant.tension = 2660.0;
  def.wires.count = 0;
  def.mic_count = 1;
  return def;
}

/* The lowest two modes of order m. */
static void lowest_pair(const TaborModel *model, uint32_t m, TaborModeInfo pair[2]) {
  uint32_t found = 0;
  for (uint32_t row = 0; found < 2; row++) {
    TaborModeInfo mode;
    assert_true(tabor_model_mode(model, row, &mode));
    if (mode.m == m && mode.n == 1 && mode.part != TABOR_PART_RIM) pair[found++] = mode;
  }
}

static void assert_near(double found, double measured) {
  assert_true(fabs(found / measured - 1.0) < NEARNESS);
}

static const char *motion(int32_t phase) { return phase > 0 ? "together" : "against each other"; }

static void pairs_lie_where_they_were_measured(void **state) {
  (void)state;
  const TaborDrumDef def = measured_drum();
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  for (size_t i = 0; i < sizeof PAIRS / sizeof PAIRS[0]; i++) {
    const Measured *pair = &PAIRS[i];
    TaborModeInfo mode[2];
    lowest_pair(model, pair->m, mode);
    for (int k = 0; k < 2; k++) {
      const double measured = k == 0 ? pair->low : pair->high;
      print_message("(%u,1): %5.1f Hz, measured %3.0f (%+.1f %%), heads move %s, part %d\n",
                    pair->m, mode[k].frequency, measured,
                    100.0 * (mode[k].frequency / measured - 1.0), motion(mode[k].phase),
                    (int)mode[k].part);
      assert_near(mode[k].frequency, measured);
    }
  }
  tabor_model_release(model);
}

/* Low (0,1): the heads move together and the air between them goes along; high (0,1): they squeeze
 * it. Of (1,1) it is the other way round: against each other they make it slosh from side to side,
 * which loads them, where moving together they only hand it on. */
static void heads_move_as_they_were_seen_to(void **state) {
  (void)state;
  const TaborDrumDef def = measured_drum();
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborModeInfo round[2], across[2];
  lowest_pair(model, 0, round);
  lowest_pair(model, 1, across);
  assert_int_equal(round[0].part, TABOR_PART_BOTH);
  assert_int_equal(round[0].phase, 1);
  assert_int_equal(round[1].part, TABOR_PART_BOTH);
  assert_int_equal(round[1].phase, -1);
  assert_int_equal(across[0].phase, -1);
  assert_int_equal(across[1].phase, 1);
  /* A source that pumps radiates, one that sways hardly does. */
  assert_true(round[1].radiation_rate > 10.0 * round[0].radiation_rate);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(pairs_lie_where_they_were_measured),
    cmocka_unit_test(heads_move_as_they_were_seen_to),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
