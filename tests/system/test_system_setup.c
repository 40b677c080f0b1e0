/* SPDX-License-Identifier: MIT */
/* Set-up is bounded for whatever a definition may ask: distant microphones, small and large heads,
 * slow air.
 *
 * Values of Bessel functions are counted, not seconds: they are what the air's integrals are made
 * of, and their number is the same on every machine. The linker routes the engine's calls through
 * the counters (CMakeLists.txt).
 *
 * usage: test_system_setup [brief]: distant microphones above the largest head alone. */
#include "math/bessel.h"
#include "math/bessel_table.h"
#include "physics.h"

/* Work for one model over that for the drum that a player meets: 32 is the most here. With
 * integrals growing with the distance the first of these took a thousand times as much. */
static const double BOUND = 100.0;

static bool brief;

static double values; /* of Bessel functions since the count began */
static double usual;  /* for the drum that a player meets */

void __real_tb_bessel_table_values(const TbBesselTable *table, uint32_t m, uint32_t count,
                                   double scale, const double *x, double *j);
void __wrap_tb_bessel_table_values(const TbBesselTable *table, uint32_t m, uint32_t count,
                                   double scale, const double *x, double *j) {
  values += count;
  __real_tb_bessel_table_values(table, m, count, scale, x, j);
}

void __real_tb_bessel_half8(const double x[8], uint32_t count, double *j);
void __wrap_tb_bessel_half8(const double x[8], uint32_t count, double *j) {
  values += 8.0 * count;
  __real_tb_bessel_half8(x, count, j);
}

static double work_to_build(const TaborDrumDef *def, uint32_t quality) {
  values = 0.0;
  tabor_model_release(physics_model(def, 48000.0, quality));
  return values;
}

static void check(const char *name, const TaborDrumDef *def) {
  const double work = work_to_build(def, TABOR_QUALITY_STUDIO);
  print_message("%s: %.0f values, %.2f times the usual\n", name, work, work / usual);
  assert_true(work < BOUND * usual);
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
  usual = work_to_build(&def, TABOR_QUALITY_LIVE);
  print_message("two heads, six microphones: %.0f values\n", usual);
  return 0;
}

/* What microphones share is computed once. */
static void six_microphones_take_less_than_six_drums(void **state) {
  (void)state;
  const TaborDrumDef def = usual_drum(1);
  const double one = work_to_build(&def, TABOR_QUALITY_LIVE);
  print_message("with one microphone: %.0f values\n", one);
  assert_true(one > 0.0);
  assert_true(usual < 6.0 * one);
}

int main(int count, char **words) {
  brief = count > 1 && strcmp(words[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(distant_microphones_are_bounded),
    cmocka_unit_test(slow_air_is_bounded),
    cmocka_unit_test(six_microphones_take_less_than_six_drums),
  };
  return cmocka_run_group_tests(tests, build_the_usual_drum, NULL);
}
