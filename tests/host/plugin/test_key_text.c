/* SPDX-License-Identifier: MIT */
/* Values of parameters in players' units, both ways, for every number of every built-in drum. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "plugin/key_text.h"

static const char *shown(const char *key, const char *value) {
  static char text[256];
  (void)key_text(tabor_parameter_find(key), value, text, sizeof text);
  return text;
}

static const char *read_as(const char *key, const char *now, const char *typed) {
  static char text[256];
  return key_text_read(tabor_parameter_find(key), now, typed, text, sizeof text) ? text : "refused";
}

static void values_are_shown_for_players(void **state) {
  (void)state;
  assert_string_equal(shown("shell.depth", "0.1397"), "139.7 mm");
  assert_string_equal(shown("mic.top.height", "1.5"), "1.5 m");
  assert_string_equal(shown("striker.stick.mass", "0.011"), "11 g");
  assert_string_equal(shown("shell.mass", "4"), "4 kg");
  assert_string_equal(shown("batter.tension", "3360"), "3360 N/m");
  assert_string_equal(shown("batter.pitch", "440"), "A4");
  assert_string_equal(shown("batter.pitch", "0"), "by tension");
  assert_string_equal(shown("body.kind", "plate"), "plate");
  assert_string_equal(shown("batter.lug_count", "10"), "10");
}

static void typed_values_convert(void **state) {
  (void)state;
  assert_string_equal(read_as("shell.depth", "0.1397", "6 in"), "0.1524");
  assert_string_equal(read_as("shell.depth", "0.1397", "6\""), "0.1524");
  assert_string_equal(read_as("shell.depth", "0.1397", "14 cm"), "0.14");
  assert_string_equal(read_as("shell.depth", "0.1397", "0.14 m"), "0.14");
  assert_string_equal(read_as("shell.depth", "0.1397", "139.7"), "0.1397"); /* as it is shown */
  assert_string_equal(read_as("mic.top.height", "1.5", "2"), "2");
  assert_string_equal(read_as("striker.stick.mass", "0.011", "12"), "0.012");
  assert_string_equal(read_as("striker.stick.mass", "0.011", "0.012 kg"), "0.012");
  assert_string_equal(read_as("batter.tension", "3360", "3400 N/m"), "3400");
  assert_string_equal(read_as("batter.pitch", "0", "A3"), "220");
  assert_string_equal(read_as("batter.pitch", "220", "by tension"), "0");
  assert_string_equal(read_as("body.kind", "drum", "plate"), "plate");
}

static void other_units_are_refused(void **state) {
  (void)state;
  assert_string_equal(read_as("shell.depth", "0.1397", "6 kg"), "refused");
  assert_string_equal(read_as("batter.tension", "3360", "10 mm"), "refused");
  assert_string_equal(read_as("shell.depth", "0.1397", "6 furlongs"), "refused");
  assert_string_equal(read_as("shell.depth", "0.1397", "deep"), "deep"); /* the engine refuses it */
}

/* What is shown, typed again, is the value: to the six digits that are shown. */
static void what_is_shown_can_be_typed(void **state) {
  (void)state;
  char key[2 * TABOR_NAME_SIZE], value[2 * TABOR_TEXT_SIZE];
  uint32_t count = 0;
  for (uint32_t preset = 0; preset < tabor_preset_count(); preset++) {
    TaborDrumDef def;
    assert_int_equal(tabor_drum_def_preset(&def, tabor_preset(preset)->name, NULL), TABOR_OK);
    for (uint32_t i = 0; tabor_drum_def_key(&def, i, key, sizeof key); i++) {
      if (tabor_parameter_find(key)->type != TABOR_TYPE_NUMBER) continue;
      assert_int_equal(tabor_drum_def_get(&def, key, value, sizeof value, NULL), TABOR_OK);
      if (!*value) continue; /* of a wire that follows the others */
      const double number = strtod(value, NULL),
                   back = strtod(read_as(key, value, shown(key, value)), NULL);
      if (strstr(key, ".pitch")) continue; /* to the cent */
      if (!(back >= number - 1e-5 * (number < 0 ? -number : number) &&
            back <= number + 1e-5 * (number < 0 ? -number : number)))
        fail_msg("%s: %s is shown as %s", key, value, shown(key, value));
      count++;
    }
  }
  print_message("%u values\n", count);
  assert_true(count > 1000);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(values_are_shown_for_players),
    cmocka_unit_test(typed_values_convert),
    cmocka_unit_test(other_units_are_refused),
    cmocka_unit_test(what_is_shown_can_be_typed),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
