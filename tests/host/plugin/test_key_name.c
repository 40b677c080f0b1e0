/* SPDX-License-Identifier: MIT */
/* Keys of drums and kits: their row of the engine's table, their section, their name for people. */
#include "plugin/key_name.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void a_drum_of_a_kit_has_the_rows_of_a_drum(void **state) {
  (void)state;
  const TaborParameter *const tension = tabor_parameter_find("batter.tension");
  assert_non_null(tension);
  assert_ptr_equal(key_parameter("batter.tension"), tension);
  assert_ptr_equal(key_parameter("drum.snare.batter.tension"), tension);
  assert_ptr_equal(key_parameter("drum.name"), tabor_parameter_find("drum.name"));
  assert_null(key_parameter("drum.snare.no.such"));
  assert_null(key_parameter("drum."));
}

static void sections_are_what_stands_before_the_last_dot(void **state) {
  (void)state;
  assert_int_equal(key_section("drum.snare.batter.tension"), strlen("drum.snare.batter"));
  assert_int_equal(key_section("version"), 0);
  assert_true(key_is_same_section("batter.tension", "batter.pitch"));
  assert_true(key_is_same_section("version", "name"));
  assert_false(key_is_same_section("drum.a.batter.tension", "drum.b.batter.tension"));
  assert_false(key_is_same_section("version", "batter.pitch"));
}

static void names_are_for_people(void **state) {
  (void)state;
  char name[16];
  assert_int_equal(key_title("batter.surface_density", name, sizeof name), 15);
  assert_string_equal(name, "surface density");
  assert_int_equal(key_title("batter.surface_density", name, 9), 15);
  assert_string_equal(name, "surface ");
  assert_int_equal(key_title("version", name, sizeof name), 7);
  assert_string_equal(name, "version");
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_drum_of_a_kit_has_the_rows_of_a_drum),
    cmocka_unit_test(sections_are_what_stands_before_the_last_dot),
    cmocka_unit_test(names_are_for_people),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
