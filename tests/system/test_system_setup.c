/* SPDX-License-Identifier: MIT */
/* Set-up is quick, and bounded for whatever a definition may ask: distant microphones, small and large
 * heads, slow air.
 *
 * usage: test_system_setup [brief]: distant microphones above the largest head alone. */
#include <time.h>

#include "physics.h"

/* Processor time for one model over that for the drum that a player meets, in the same run: 25 is the most here, 45 under
 * sanitizers. With its integrals growing with the distance the first of these took a thousand times as long. */
static const double BOUND = 200.0;

static bool brief;

static double usual; /* [s] for the drum that a player meets */

static double seconds_to_build(const TaborDrumDef *def, uint32_t quality) {
  const clock_t start = clock();
  tabor_model_release(physics_model(def, 48000.0, quality));
  return (double)(clock() - start) / CLOCKS_PER_SEC;
}

static void check(const char *name, const TaborDrumDef *def) {
  const double seconds = seconds_to_build(def, TABOR_QUALITY_STUDIO);
  print_message("%s: %.3f s, %.1f times the usual\n", name, seconds, seconds / usual);
  assert_true(seconds < BOUND * usual);
}

static TaborDrumDef with_distant_mic(double radius, double mic_radius, double mic_height) {
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.shell.radius = radius;
  def.strike.radius = 0.3 * radius;
  def.mic[0].radius = mic_radius;
  def.mic[0].height = mic_height;
  return def;
}

static void distant_microphones_are_bounded(void **state) {
  (void)state;
  static const double RADII[] = {0.05, 0.6}, HEIGHTS[] = {0.01, -0.01, 10.0};
  for (int r = brief ? 1 : 0; r < 2; r++) {
    for (int h = brief ? 2 : 0; h < 3; h++) {
      for (uint32_t boundary = 0; boundary < 3; boundary++) {
        TaborDrumDef def = with_distant_mic(RADII[r], 10.0, HEIGHTS[h]);
        def.shell.boundary = boundary;
        if (boundary == TABOR_BOUNDARY_CLOSED && HEIGHTS[h] < 0.0) def.mic[0].height = -2.0;
        check("a microphone at 10 m", &def);
      }
    }
  }
}

/* Where sound is slower than the head's waves, everything radiates, and with many nodes. */
static void slow_air_is_bounded(void **state) {
  (void)state;
  for (uint32_t boundary = 0; boundary < 2; boundary++) {
    TaborDrumDef def = with_distant_mic(0.6, 1.5, 0.02);
    def.shell.boundary = boundary;
    def.air.sound_speed = 100.0;
    def.batter.tension = 20000.0;
    def.batter.surface_density = 0.2;
    def.batter.bending_stiffness = 1.0;
    check("slow air", &def);
  }
}

/* The drum that a player meets: 14 inch, two heads, `mics` microphones. */
static TaborDrumDef usual_drum(uint32_t mics) {
  static const double PLACES[6][2] = {{0.05, 0.10}, {0.08, -0.25}, {0.9, 0.5},
                                      {1.5, 1.2},   {0.5, 2.0},    {0.25, 0.04}};
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.two_headed = 1;
  def.shell.radius = 0.1778;
  def.mic_count = mics;
  for (uint32_t i = 0; i < mics; i++) {
    def.mic[i] = def.mic[0];
    snprintf(def.mic[i].name, sizeof def.mic[i].name, "mic%u", i);
    def.mic[i].radius = PLACES[i][0];
    def.mic[i].height = PLACES[i][1];
  }
  return def;
}

static int build_the_usual_drum(void **state) {
  (void)state;
  const TaborDrumDef def = usual_drum(6);
  usual = seconds_to_build(&def, TABOR_QUALITY_LIVE);
  print_message("two heads, six microphones: %.3f s\n", usual);
  return 0;
}

/* What microphones share is computed once. */
static void six_microphones_cost_less_than_six_drums(void **state) {
  (void)state;
  const TaborDrumDef def = usual_drum(1);
  const double seconds = seconds_to_build(&def, TABOR_QUALITY_LIVE);
  print_message("with one microphone: %.3f s\n", seconds);
  assert_true(usual < 6.0 * seconds);
}

int main(int count, char **words) {
  brief = count > 1 && strcmp(words[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(distant_microphones_are_bounded),
    cmocka_unit_test(slow_air_is_bounded),
    cmocka_unit_test(six_microphones_cost_less_than_six_drums),
  };
  return cmocka_run_group_tests(tests, build_the_usual_drum, NULL);
}
