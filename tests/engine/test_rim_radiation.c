/* SPDX-License-Identifier: MIT */
/* The sound of a shell's wall and of a hoop: against closed forms and against the power that
 * leaves. */
#include "physics.h"

#include "bodies/drum/rim_radiation.h"
#include "math/bessel.h"

static const double PI = 3.14159265358979323846;
static const double RADIUS = 0.1778, DEPTH = 0.14; /* [m] */
static const TaborAirDef AIR = {.density = 1.205, .sound_speed = 343.0};

/* Int_-l^l x sin(kappa x) dx */
static double lever(double kappa, double half) {
  const double y = kappa * half;
  return fabs(y) > 1e-3 ? 2.0 * (sin(y) - y * cos(y)) / (kappa * kappa)
                        : 2.0 / 3.0 * y * half * half;
}

/* |I| far away: n^2/(2 r R) |J_n(k R sin t) Int x sin(k x cos t) dx|. */
static void far_field_is_the_closed_form(void **state) {
  (void)state;
  const double away =
    200.0; /* the middle of the wall is the origin; the rest is (h/r)^2 and k R^2/r */
  for (uint32_t n = 2; n < 6; n++) {
    for (double frequency = 400.0; frequency < 4000.0; frequency *= 2.1) {
      const double k = 2.0 * PI * frequency / AIR.sound_speed;
      double worst = 0.0, largest = 0.0;
      for (double t = 0.1; t < PI; t += 0.2) {
        double field[2];
        tb_wall_field(n, k, RADIUS, DEPTH, away * sin(t), away * cos(t) - 0.5 * DEPTH, field);
        const double expected =
          n * n / (2.0 * away * RADIUS) *
          fabs(tb_bessel_j(n, k * RADIUS * sin(t)) * lever(k * cos(t), 0.5 * DEPTH));
        worst = fmax(worst, fabs(hypot(field[0], field[1]) - expected));
        largest = fmax(largest, expected);
      }
      assert_true(worst < 0.01 * largest);
    }
  }
}

/* The wall's integral by the midpoint rule, with points 0.6 mm apart. */
static void field_by_sums(uint32_t n, double k, double r, double z, double field[2]) {
  enum { AROUND = 900, LEVELS = 240 };
  field[0] = field[1] = 0.0;
  for (int i = 0; i < AROUND; i++) {
    const double t = PI * (i + 0.5) / AROUND;
    const double across = r * r + RADIUS * RADIUS - 2.0 * r * RADIUS * cos(t);
    for (int l = 0; l < LEVELS; l++) {
      const double up = z + DEPTH * (l + 0.5) / LEVELS, distance = sqrt(across + up * up);
      const double out = n * n * ((l + 0.5) / LEVELS - 0.5) * DEPTH / RADIUS; /* -n^2 x/R */
      const double size =
        cos(n * t) * out * DEPTH / (2.0 * distance) / AROUND / LEVELS; /* 2 pi R dt dz/(4 pi d R) */
      field[0] += size * cos(k * distance);
      field[1] -= size * sin(k * distance);
    }
  }
}

/* Few points far from the wall, many near it: in front of it 2 cm away, and on the axis. The
 * midpoint rule is right to (h/distance)^2/24, less than 1e-4. */
static void field_takes_points_enough(void **state) {
  (void)state;
  const double TOLERANCE = 1e-4;
  static const double DISTANCES[] = {0.0, 0.02, 0.1, RADIUS - 0.02, RADIUS + 0.02, 0.3, 1.1};
  for (uint32_t n = 2; n < 12; n += 3) {
    for (double k = 2.0; k < 200.0; k *= 3.1) {
      double worst = 0.0, largest = 0.0;
      for (size_t i = 0; i < sizeof DISTANCES / sizeof *DISTANCES; i++) {
        double field[2], expected[2];
        tb_wall_field(n, k, RADIUS, DEPTH, DISTANCES[i], -0.6 * DEPTH, field);
        field_by_sums(n, k, DISTANCES[i], -0.6 * DEPTH, expected);
        worst = fmax(worst, hypot(field[0] - expected[0], field[1] - expected[1]));
        largest = fmax(largest, hypot(expected[0], expected[1]));
      }
      assert_true(worst < TOLERANCE * largest);
    }
  }
}

/* What passes a sphere 100 m away, Int |p|^2/(2 rho0 c0) dA, by the field itself. */
static double power_through_sphere(uint32_t n, double omega) {
  const double away = 100.0, k = omega / AIR.sound_speed;
  double sum = 0.0;
  enum { RINGS = 400 };
  for (int i = 0; i < RINGS; i++) {
    const double t = PI * (i + 0.5) / RINGS;
    double field[2];
    tb_wall_field(n, k, RADIUS, DEPTH, away * sin(t), away * cos(t) - 0.5 * DEPTH, field);
    const double p = omega * omega * AIR.density * RADIUS * hypot(field[0], field[1]);
    sum += p * p / (2.0 * AIR.density * AIR.sound_speed) * PI * away * away * sin(t) * PI / RINGS;
  }
  return sum;
}

static void what_leaves_is_what_the_mode_loses(void **state) {
  (void)state;
  static const uint32_t ORDER[] = {2, 3, 6};
  static const double FREQUENCY[] = {420.0, 1310.0, 3060.0};
  for (int i = 0; i < 3; i++) {
    const double omega = 2.0 * PI * FREQUENCY[i];
    const double power = power_through_sphere(ORDER[i], omega);
    const double lost =
      0.5 * tb_wall_resistance(ORDER[i], omega, &AIR, RADIUS, DEPTH) * omega * omega;
    print_message("order %u: %.5g W leave, %.5g W are lost\n", ORDER[i], power, lost);
    assert_true(fabs(power / lost - 1.0) < 0.01);
  }
}

static void long_waves_take_nothing(void **state) {
  (void)state;
  for (uint32_t n = 2; n < 5; n++) {
    const double low = tb_wall_resistance(n, 100.0, &AIR, RADIUS, DEPTH);
    const double high = tb_wall_resistance(n, 200.0, &AIR, RADIUS, DEPTH);
    assert_true(fabs(high / low / pow(4.0, n + 2.0) - 1.0) < 0.01);
  }
}

/* The tilted wall of n = 1 is a rigid body's: upwards in front, inwards above. */
static void a_tilted_wall_moves_inward_above_where_it_rises(void **state) {
  (void)state;
  double above[2], below[2], middle[2];
  tb_wall_field(1, 1.0, RADIUS, DEPTH, RADIUS + 0.01, 0.0, above);
  tb_wall_field(1, 1.0, RADIUS, DEPTH, RADIUS + 0.01, -DEPTH, below);
  tb_wall_field(1, 1.0, RADIUS, DEPTH, RADIUS + 0.01, -0.5 * DEPTH, middle);
  assert_true(above[0] < 0.0 && fabs(above[0] + below[0]) < 1e-9);
  assert_true(fabs(middle[0]) < 1e-9 * fabs(above[0]));
}

/* Strips 3 cm wide: far below the sound's wavelength, dipoles in their own plane are silent, and
 * what passes a sphere is what is lost. */
static void a_strip_radiates_what_it_loses(void **state) {
  (void)state;
  const double width = 0.03, away = 100.0;
  enum { RINGS = 400 };
  for (int motion = TB_STRIP_UP; motion <= TB_STRIP_OUT; motion++) {
    for (uint32_t n = 0; n < 8; n += n ? 3 : 1) {
      const double omega = 2.0 * PI * (800.0 + 500.0 * n), k = omega / AIR.sound_speed;
      double power = 0.0, field[2];
      for (int i = 0; i < RINGS; i++) {
        const double t = PI * (i + 0.5) / RINGS;
        tb_strip_field(motion, n, k, RADIUS, width, away * sin(t), away * cos(t), field);
        const double p = omega * omega * AIR.density * RADIUS * hypot(field[0], field[1]);
        power += (n ? 1.0 : 2.0) * p * p / (2.0 * AIR.density * AIR.sound_speed) * PI * away *
                 away * sin(t) * PI / RINGS;
      }
      const double lost =
        0.5 * tb_strip_resistance(motion, n, omega, &AIR, RADIUS, width) * omega * omega;
      print_message("motion %d, order %u: %.5g W leave, %.5g W are lost\n", motion, n, power, lost);
      assert_true(fabs(power / lost - 1.0) < 0.01);
      if (motion != TB_STRIP_UP) continue;
      tb_strip_field(motion, n, k, RADIUS, width, 0.1, 0.0, field);
      assert_true(field[0] == 0.0 && field[1] == 0.0);
    }
  }
}

/* Both motions together: no power is their product. */
static void a_hoop_that_rises_and_leans_loses_both_powers(void **state) {
  (void)state;
  enum { RINGS = 400 };
  const double omega = 2.0 * PI * 2300.0, k = omega / AIR.sound_speed, away = 100.0;
  double both = 0.0, apart = 0.0;
  for (int i = 0; i < RINGS; i++) {
    const double t = PI * (i + 0.5) / RINGS;
    double up[2], out[2];
    tb_strip_field(TB_STRIP_UP, 4, k, RADIUS, 0.015, away * sin(t), away * cos(t), up);
    tb_strip_field(TB_STRIP_OUT, 4, k, RADIUS, 0.028, away * sin(t), away * cos(t), out);
    for (int c = 0; c < 2; c++) {
      both += (up[c] - out[c]) * (up[c] - out[c]) * sin(t);
      apart += (up[c] * up[c] + out[c] * out[c]) * sin(t);
    }
  }
  assert_true(fabs(both / apart - 1.0) < 1e-6);
}

/* Far below its wavelength the air of its circle; far above it, plane waves from both sides, 2 rho0
 * c w. */
static void a_wide_strip_radiates_plane_waves(void **state) {
  (void)state;
  const double width = 0.02, k[] = {0.1, 1e5};
  double field[2][2], narrow[2][2];
  for (int i = 0; i < 2; i++) {
    tb_strip_field(TB_STRIP_UP, 0, k[i], RADIUS, width, 0.0, 0.5, field[i]);
    tb_strip_field(TB_STRIP_UP, 0, k[i], RADIUS, 1e-9, 0.0, 0.5, narrow[i]);
    const double mass =
      0.25 * PI * 1e-18 * hypot(field[i][0], field[i][1]) / hypot(narrow[i][0], narrow[i][1]);
    const double expected = i ? 2.0 * width / k[i] : 0.25 * PI * width * width; /* of rho0 */
    assert_true(fabs(mass / expected - 1.0) < 1e-3);
  }
}

/* A section that turns freely leans as the edge of a cylinder that does not stretch, n^2 x/R; a
 * closed one turns at most twice. */
static void a_hoop_leans_as_its_section_lets_it(void **state) {
  (void)state;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.shell.radius = RADIUS;
  def.hoop.wall = 0.028;
  for (uint32_t n = 2; n < 10; n++) {
    const double middle = 0.5 * def.hoop.wall / RADIUS;
    def.hoop.torsion = 1e-9;
    assert_true(fabs(tb_hoop_lean(&def, n) / (-middle * n * n) - 1.0) < 1e-6);
    def.hoop.torsion = 1.0;
    assert_true(fabs(tb_hoop_lean(&def, n)) < 2.0 * middle);
  }
  def.hoop.torsion = 0.02;
  assert_true(fabs(tb_hoop_lean(&def, 1) + 0.5 * def.hoop.wall / RADIUS) <
              1e-12); /* tilts as a whole */
  assert_true(tb_hoop_lean(&def, 0) == 0.0);
}

/* A slow strip on its axis: the mass that it drags along pushes as a dipole of strength mass times
 * acceleration, p = F z/(4 pi s^3), and upward acceleration presses above. */
static void a_slow_strip_is_a_dipole(void **state) {
  (void)state;
  const double width = 0.01, z = 3.0, s2 = z * z + RADIUS * RADIUS;
  double field[2];
  tb_strip_field(TB_STRIP_UP, 0, 1e-6, RADIUS, width, 0.0, z, field);
  const double mass = AIR.density * PI * 0.25 * width * width * 2.0 * PI * RADIUS;
  const double expected = mass * z / (4.0 * PI * s2 * sqrt(s2));
  assert_true(fabs(AIR.density * RADIUS * field[0] / expected - 1.0) < 1e-9);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(far_field_is_the_closed_form),
    cmocka_unit_test(field_takes_points_enough),
    cmocka_unit_test(what_leaves_is_what_the_mode_loses),
    cmocka_unit_test(long_waves_take_nothing),
    cmocka_unit_test(a_tilted_wall_moves_inward_above_where_it_rises),
    cmocka_unit_test(a_strip_radiates_what_it_loses),
    cmocka_unit_test(a_hoop_that_rises_and_leans_loses_both_powers),
    cmocka_unit_test(a_wide_strip_radiates_plane_waves),
    cmocka_unit_test(a_hoop_leans_as_its_section_lets_it),
    cmocka_unit_test(a_slow_strip_is_a_dipole),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
