/* SPDX-License-Identifier: MIT */
/* The far field of a mode: limits that one can work out. */
#include "air_model/far_field.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static const double PI = 3.14159265358979323846;
static const double DEPTH = 0.8; /* of the shell, in radii */

/* I of e^{-i x s}/s times a pattern, s in radii from the drum's middle. */
static void fields_of(double x, double (*pattern)(double cosine), double *fields) {
  TbAirPoint points[TB_FAR_NODES];
  tb_far_points(DEPTH, points);
  for (int i = 0; i < TB_FAR_NODES; i++) {
    const double up = points[i].height + 0.5 * DEPTH, s = hypot(points[i].radius, up);
    fields[2 * i] = pattern(up / s) * cos(x * s) / s;
    fields[2 * i + 1] = -pattern(up / s) * sin(x * s) / s;
  }
}

static double monopole(double cosine) {
  (void)cosine;
  return 1.0;
}
static double dipole(double cosine) { return cosine; }

static double rate_of(double x, uint32_t m, double (*pattern)(double cosine)) {
  const TaborAirDef air = {.density = 1.2, .sound_speed = 343.0};
  double fields[2 * TB_FAR_NODES], far[2 * TB_FAR_NODES];
  fields_of(x, pattern, fields);
  tb_far_from_fields(DEPTH, x, fields, far);
  return tb_far_decay_rate(&air, 0.2, m, x * air.sound_speed / 0.2, far);
}

/* P/omega^2 of a monopole F = 1, which has the volume V = 4 pi R^2, is omega^2 rho0 V^2/(8 pi c0);
 * a dipole has a third of it, and a pattern cos(m theta) half. */
static void slow_sources_have_the_power_that_one_can_work_out(void **state) {
  (void)state;
  for (double x = 0.1; x < TB_FAR_TOP; x *= 2.0) {
    const double omega = x * 343.0 / 0.2, volume = 4.0 * PI * 0.04;
    const double expected = omega * omega * 1.2 * volume * volume / (8.0 * PI * 343.0);
    assert_true(fabs(rate_of(x, 0, monopole) / expected - 1.0) < 1e-12);
    assert_true(fabs(rate_of(x, 0, dipole) / expected - 1.0 / 3.0) < 1e-12);
    assert_true(fabs(rate_of(x, 1, dipole) / expected - 1.0 / 6.0) < 1e-12);
  }
}

/* Phases count from when the sound leaves the nearest point of a head, as those of microphones:
 * along the axis that is half the depth sooner than from the middle. */
static void phases_count_from_the_nearest_head(void **state) {
  (void)state;
  const double x = 0.5;
  double fields[2 * TB_FAR_NODES], far[2 * TB_FAR_NODES];
  TbAirPoint points[TB_FAR_NODES];
  fields_of(x, monopole, fields);
  tb_far_points(DEPTH, points);
  tb_far_from_fields(DEPTH, x, fields, far);
  for (int i = 0; i < TB_FAR_NODES; i++) {
    const double up = points[i].height > 0.0 ? points[i].height : -points[i].height - DEPTH;
    const double sooner =
      hypot(points[i].radius, points[i].height + 0.5 * DEPTH) - hypot(up, points[i].radius - 1.0);
    assert_true(fabs(far[2 * i] - cos(x * sooner)) < 1e-9);
    assert_true(fabs(far[2 * i + 1] + sin(x * sooner)) < 1e-9);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(slow_sources_have_the_power_that_one_can_work_out),
    cmocka_unit_test(phases_count_from_the_nearest_head),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
