/* SPDX-License-Identifier: MIT */
/* Set-up is quick, and bounded for whatever a definition may ask: distant microphones, small and large
 * heads, slow air.
 *
 * usage: test_system_setup [brief]: distant microphones above the largest head alone. */
#include <time.h>

#include "physics.h"

/* Processor time for one model [s]: two hundred times what the slowest takes that a player meets, and room
 * for sanitizers; with its integrals growing with the distance the first of these took minutes. */
static const double BOUND = 20.0;

static bool brief;

static double seconds_to_build(const TaborDrumDef *def, uint32_t quality) {
  const clock_t start = clock();
  tabor_model_release(physics_model(def, 48000.0, quality));
  return (double)(clock() - start) / CLOCKS_PER_SEC;
}

static void check(const char *name, const TaborDrumDef *def) {
  const double seconds = seconds_to_build(def, TABOR_QUALITY_STUDIO);
  print_message("%s: %.3f s\n", name, seconds);
  assert_true(seconds < BOUND);
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

/* The drum that a player meets: 14 inch, two heads, six microphones. Under half a second on one core of
 * 2018; ten times that is let pass here, for sanitizers and busy machines. */
static void a_two_headed_drum_with_six_microphones(void **state) {
  (void)state;
  static const double PLACES[6][2] = {{0.05, 0.10}, {0.08, -0.25}, {0.9, 0.5},
                                      {1.5, 1.2},   {0.5, 2.0},    {0.25, 0.04}};
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.two_headed = 1;
  def.shell.radius = 0.1778;
  def.mic_count = 6;
  for (int i = 0; i < 6; i++) {
    def.mic[i] = def.mic[0];
    snprintf(def.mic[i].name, sizeof def.mic[i].name, "mic%d", i);
    def.mic[i].radius = PLACES[i][0];
    def.mic[i].height = PLACES[i][1];
  }
  const double seconds = seconds_to_build(&def, TABOR_QUALITY_LIVE);
  print_message("two heads, six microphones: %.3f s\n", seconds);
  assert_true(seconds < 5.0);
}

int main(int count, char **words) {
  brief = count > 1 && strcmp(words[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(distant_microphones_are_bounded),
    cmocka_unit_test(slow_air_is_bounded),
    cmocka_unit_test(a_two_headed_drum_with_six_microphones),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
