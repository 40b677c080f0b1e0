/* SPDX-License-Identifier: MIT */
/* Places of parameters on the way of a control: ends, order, and what stands at a place stands there. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "plugin/key_way.h"
#include "plugin/knob.h"

static double place_of(const char *key, const char *value) {
  return key_position(tabor_parameter_find(key), value);
}

static void ends_and_middles_are_where_they_should_be(void **state) {
  (void)state;
  assert_true(place_of("wires.strainer", "0") == 0);
  assert_true(place_of("wires.strainer", "0.5") == 0.5);
  assert_true(place_of("wires.strainer", "1") == 1);
  assert_true(place_of("body.kind", "drum") == 0);
  assert_true(place_of("body.kind", "plate") == 0.5);
  assert_true(place_of("body.kind", "hihat") == 1);
  assert_true(place_of("batter.muffle_strength", "0") == 0);
  assert_true(place_of("wire.1.tension", "") < 0); /* follows the others */
  assert_true(place_of("batter.pitch", "0") < 0);  /* follows the tension */
  assert_true(place_of("strike.striker", "stick") < 0);
}

/* Half a step beside a whole number; a ten-thousandth beside a number of four digits. */
static double place_beside(const TaborParameter *parameter, const char *value, int side) {
  char beside[256];
  const double number = strtod(value, NULL);
  const double away = parameter->type == TABOR_TYPE_WHOLE ? 0.5001 : 1e-3 * fabs(number) + 1e-9;
  if (parameter->type == TABOR_TYPE_CHOICE) return key_position(parameter, value) + side * 0.51;
  (void)snprintf(beside, sizeof beside, "%.17g", number + side * away);
  return key_position(parameter, beside);
}

/* 101 places of each parameter: values do not fall, and stand where they came from. */
static void what_stands_at_a_place_stands_there(void **state) {
  (void)state;
  char value[256];
  for (uint32_t i = 0; i < tabor_parameter_count(); i++) {
    const TaborParameter *const parameter = tabor_parameter(i);
    double before = -INFINITY;
    for (int step = 0; step <= 100 && parameter->type != TABOR_TYPE_TEXT; step++) {
      const double from = step / 100.0;
      key_at_position(parameter, from, value, sizeof value);
      const double place = key_position(parameter, value);
      if (place < 0) continue; /* a pitch of 0 */
      const bool is_near = place_beside(parameter, value, -1) <= from + 0.01 &&
                           place_beside(parameter, value, 1) >= from - 0.01;
      if (!is_near || place < before)
        fail_msg("%s.%s at %d %%: %s stands at %.4f", parameter->section, parameter->key, step,
                 value, place);
      before = place;
    }
  }
}

static void values_are_counted(void **state) {
  (void)state;
  assert_int_equal(key_choices(tabor_parameter_find("body.kind")), 3);
  assert_int_equal(key_choices(tabor_parameter_find("quality.newton_cap")), 17);
  assert_int_equal(key_choices(tabor_parameter_find("batter.tension")), 0);
}

static void steps_are_of_one_choice_at_least(void **state) {
  (void)state;
  assert_true(knob_stepped(0.5, KNOB_STEP, 0) == 0.5 + KNOB_STEP);
  assert_true(knob_stepped(0.5, KNOB_STEP, 3) == 1);
  assert_true(knob_stepped(0.5, -KNOB_STEP, 3) == 0);
  assert_true(knob_stepped(0.5, 0.25, 101) == 0.75);
  assert_true(knob_stepped(1, KNOB_STEP, 0) == 1);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(ends_and_middles_are_where_they_should_be),
    cmocka_unit_test(what_stands_at_a_place_stands_there),
    cmocka_unit_test(values_are_counted),
    cmocka_unit_test(steps_are_of_one_choice_at_least),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
