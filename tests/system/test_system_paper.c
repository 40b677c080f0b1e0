/* SPDX-License-Identifier: MIT */
/* The three configurations of [Torin2014] section 4.2: how high head and string go in the first 120
 * ms, how often the string bounces, and whose motion dies first. */
#include "physics.h"

static const double SECONDS = 0.12, LATE = 0.08;
/* The paper's stroke, which it does not give: this one moves the centre by some 0.7 mm [m/s]. */
static const double SPEED = 1.42;
/* A bounce: the gap at the midpoint opens beyond the first, then closes to the second [m]. */
static const double OPEN = 1e-4, CLOSED = 2e-5;
/* "Around 1 mm and 2-3 mm" [m]. */
static const double HEAD_LEAST = 0.6e-3, HEAD_MOST = 1.6e-3;
static const double WIRE_LEAST = 1.5e-3, WIRE_MOST = 4.5e-3;
/* "Approximately twice as many" in the laboratory, "considerably more" in their model. */
static const double MORE_BOUNCES = 1.5;

enum { PIANO, SLACK, TENSIONED, CONFIGURATIONS };
static const char *const PRESETS[CONFIGURATIONS] = {"bodhran-piano-string", "bodhran-d-string",
                                                    "bodhran-d-string-tensioned"};

typedef struct Motion {
  int bounces;
  double head, wire; /* peaks [m] */
  double late;       /* largest |wire| of the last 40 ms over that of the whole */
} Motion;

/* Counts a bounce when an open gap closes. */
static bool bounces_now(const TaborProbe *probe, bool *open) {
  const double gap = fmax(0.0, probe->wire - probe->head);
  if (gap > OPEN) *open = true;
  if (!*open || gap >= CLOSED) return false;
  *open = false;
  return true;
}

static Motion motion_of(TaborModel *model, const TaborEvent *strike, double rate) {
  TaborDrum *drum = physics_drum(model);
  Motion motion = {0};
  bool open = false;
  double whole = 0.0, late = 0.0;
  const int frames = (int)lround(SECONDS * rate);
  for (int i = 0; i < frames; i++) {
    tabor_drum_process(drum, strike, i == 0 ? 1 : 0, NULL, 1);
    TaborProbe probe;
    tabor_drum_probe(drum, &probe);
    motion.head = fmax(motion.head, fabs(probe.head));
    motion.wire = fmax(motion.wire, probe.wire);
    whole = fmax(whole, fabs(probe.wire));
    if (i >= LATE * rate) late = fmax(late, fabs(probe.wire));
    motion.bounces += bounces_now(&probe, &open);
  }
  motion.late = late / whole;
  tabor_drum_destroy(drum);
  return motion;
}

static void check(const Motion motions[CONFIGURATIONS]) {
  for (int c = 0; c < CONFIGURATIONS; c++) {
    assert_true(motions[c].head >= HEAD_LEAST && motions[c].head <= HEAD_MOST);
    assert_true(motions[c].wire >= WIRE_LEAST && motions[c].wire <= WIRE_MOST);
  }
  assert_true(motions[SLACK].bounces > 0);
  assert_true(motions[TENSIONED].bounces >= MORE_BOUNCES * motions[SLACK].bounces);
  assert_true(motions[PIANO].bounces > motions[SLACK].bounces);
}

/* What is left of the motion. */
static void check_decay(const Motion motions[CONFIGURATIONS]) {
  assert_true(motions[PIANO].late < motions[SLACK].late);
  assert_true(motions[PIANO].late < motions[TENSIONED].late);
}

/* All three, struck `factor` times as fast as SPEED, one factor after the other. */
static void compare(double rate, uint32_t quality, const double *factors, int count) {
  TaborModel *models[CONFIGURATIONS];
  for (int c = 0; c < CONFIGURATIONS; c++) {
    const TaborDrumDef def = physics_preset(PRESETS[c]);
    models[c] = physics_model(&def, rate, quality);
  }
  for (int f = 0; f < count; f++) {
    Motion motions[CONFIGURATIONS];
    for (int c = 0; c < CONFIGURATIONS; c++) {
      TaborEvent strike = physics_strike(tabor_model_definition(models[c]));
      strike.velocity = factors[f] * SPEED;
      motions[c] = motion_of(models[c], &strike, rate);
      print_message("%-26s %g x: head %.2f mm, wire %.2f mm, %d bounces, late %.2f\n", PRESETS[c],
                    factors[f], 1e3 * motions[c].head, 1e3 * motions[c].wire, motions[c].bounces,
                    motions[c].late);
    }
    check(motions);
    check_decay(motions);
  }
  for (int c = 0; c < CONFIGURATIONS; c++) tabor_model_release(models[c]);
}

/* Bounces are sensitive; the conclusions may not hang on a hundredth of the speed. */
static const double NEAR[] = {0.99, 1.0, 1.01, 1.02};

static void at_studio_quality(void **state) {
  (void)state;
  compare(48000.0, TABOR_QUALITY_STUDIO, NEAR, 4);
}

static void at_speeds_beside(void **state) {
  (void)state;
  static const double FACTORS[] = {0.98, 1.03};
  compare(48000.0, TABOR_QUALITY_STUDIO, FACTORS, 2);
}

static void at_reference_quality(void **state) {
  (void)state;
  compare(48000.0, TABOR_QUALITY_REFERENCE, NEAR, 4);
}

/* At 48 kHz studio steps at 96 kHz. */
static void at_twice_the_rate(void **state) {
  (void)state;
  compare(192000.0, TABOR_QUALITY_STUDIO, NEAR, 4);
}

/* `brief` as argument: the presets' own strokes at 48 kHz alone, for slow builds. */
int main(int argc, char **argv) {
  const struct CMUnitTest first[] = {cmocka_unit_test(at_studio_quality)};
  const struct CMUnitTest rest[] = {
    cmocka_unit_test(at_speeds_beside),
    cmocka_unit_test(at_reference_quality),
    cmocka_unit_test(at_twice_the_rate),
  };
  const int failed = cmocka_run_group_tests(first, NULL, NULL);
  if (argc > 1 && strcmp(argv[1], "brief") == 0) return failed;
  return failed + cmocka_run_group_tests(rest, NULL, NULL);
}
