/* SPDX-License-Identifier: MIT */
/* Ballistics of the meters. */
#include "ui/meter.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define EXACT 1e-9 /* rounding of sums of some hundred steps [dB] */
#define LOOK 0.05  /* between looks [s] */

static void assert_near(double value, double expected) {
  if (!(fabs(value - expected) < EXACT)) fail_msg("%.12g instead of %.12g", value, expected);
}

static void look_on(Meter *meter, double seconds) {
  for (double time = 0; time < seconds - LOOK / 2; time += LOOK) meter_take(meter, 0, LOOK);
}

static void levels_rise_at_once_and_fall_steadily(void **state) {
  (void)state;
  Meter meter = meter_begin();
  assert_near(meter.level, METER_FLOOR);
  meter_take(&meter, 0.5, LOOK);
  assert_near(meter.level, 20 * log10(0.5));
  look_on(&meter, 1);
  assert_near(meter.level, 20 * log10(0.5) - METER_FALL);
  look_on(&meter, 10);
  assert_near(meter.level, METER_FLOOR);
}

static void peaks_stand_and_then_fall(void **state) {
  (void)state;
  Meter meter = meter_begin();
  meter_take(&meter, 1, LOOK);
  look_on(&meter, METER_HOLD);
  assert_near(meter.peak, 0);
  look_on(&meter, 1);
  assert_near(meter.peak, -METER_PEAK_FALL);
  meter_take(&meter, 0.5, LOOK);
  assert_near(meter.peak, 20 * log10(0.5));
  look_on(&meter, 20);
  assert_near(meter.peak, METER_FLOOR);
}

static void peaks_do_not_depend_on_how_often_one_looks(void **state) {
  (void)state;
  Meter often = meter_begin(), once = meter_begin();
  meter_take(&often, 1, LOOK);
  meter_take(&once, 1, LOOK);
  look_on(&often, 3);
  meter_take(&once, 0, 3);
  assert_near(often.level, once.level);
  assert_near(often.peak, once.peak);
}

static void the_clip_light_goes_out_again(void **state) {
  (void)state;
  Meter meter = meter_begin();
  meter_take(&meter, 1, LOOK);
  assert_true(meter.clip_left == 0); /* full scale is not beyond it */
  meter_take(&meter, 1.01, LOOK);
  look_on(&meter, METER_CLIP - LOOK);
  assert_true(meter.clip_left > 0);
  look_on(&meter, 2 * LOOK);
  assert_true(meter.clip_left == 0);
}

static void loads_settle_and_hold(void **state) {
  (void)state;
  LoadMeter meter = {0};
  load_meter_take(&meter, 0.4, 0.9, METER_LOAD_SETTLE);
  assert_near(meter.median, 0.4 * (1 - exp(-1)));
  assert_near(meter.worst, 0.9);
  load_meter_take(&meter, 0.4, 0.5, METER_LOAD_HOLD - LOOK);
  assert_near(meter.worst, 0.9);
  load_meter_take(&meter, 0.4, 0.5, 2 * LOOK);
  assert_near(meter.worst, 0.5);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(levels_rise_at_once_and_fall_steadily),
    cmocka_unit_test(peaks_stand_and_then_fall),
    cmocka_unit_test(peaks_do_not_depend_on_how_often_one_looks),
    cmocka_unit_test(the_clip_light_goes_out_again),
    cmocka_unit_test(loads_settle_and_hold),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
