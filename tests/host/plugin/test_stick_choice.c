/* SPDX-License-Identifier: MIT */
/* Sticks by name: their numbers follow from sizes and materials, and what is no stick stays as it
 * is. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "plugin/knobs.h"
#include "plugin/stick_choice.h"

static const double PI = 3.14159265358979323846;

static TaborDrumDef preset(const char *name) {
  TaborDrumDef def;
  assert_int_equal(tabor_drum_def_preset(&def, name, NULL), TABOR_OK);
  return def;
}

/* A fifth of 0.915 of a cylinder of hickory; a beam with free ends, 400 Hz at 15 mm and 406 mm. */
static void numbers_follow_from_sizes(void **state) {
  (void)state;
  static const struct {
    double diameter, length; /* [m] */
  } sizes[] = {{0.0137, 0.394}, {0.0144, 0.406}, {0.0151, 0.406}, {0.0160, 0.413}};
  for (uint32_t i = 0; i < 4; i++) {
    TaborDrumDef def = preset("snare-14x5.5");
    const double d = sizes[i].diameter, l = sizes[i].length;
    const double mass = 0.2 * 0.915 * 790.0 * PI / 4.0 * d * d * l;
    const double bending = 400.0 * d / 0.015 * (0.406 / l) * (0.406 / l);
    stick_choice_take(1 + i, &def);
    const TaborStrikerDef *const stick = knob_usual_striker(&def);
    print_message("%.1f g, %.0f Hz, by its size %.1f g, %.0f Hz\n", 1e3 * stick->mass,
                  stick->bending_frequency, 1e3 * mass, bending);
    assert_true(fabs(stick->mass / mass - 1.0) < 0.01);
    assert_true(fabs(stick->bending_frequency / bending - 1.0) < 0.01);
    assert_int_equal(tabor_drum_def_validate(&def, NULL), TABOR_OK);
  }
}

/* Hertz: K = 4/3 E/(1 - nu^2) sqrt(R); both numbers are E/(1 - nu^2). */
static void nylon_is_harder(void **state) {
  (void)state;
  const double wood = 4.0 / 3.0 * 0.95e9 * sqrt(0.005);
  const double nylon = 4.0 / 3.0 * 1.7e9 * sqrt(0.005);
  for (uint32_t i = 1; i <= 4; i++) {
    TaborDrumDef a = preset("snare-14x5.5"), b = a;
    const double own = knob_usual_striker(&a)->contact_stiffness;
    assert_true(fabs(own / wood - 1.0) < 0.01);
    stick_choice_take(i, &a);
    stick_choice_take(4 + i, &b);
    assert_true(knob_usual_striker(&a)->contact_stiffness == own);
    assert_true(knob_usual_striker(&b)->mass == knob_usual_striker(&a)->mass);
    assert_true(fabs(knob_usual_striker(&b)->contact_stiffness / nylon - 1.0) < 0.02);
  }
}

static void others_stay(void **state) {
  (void)state;
  static const char *const drums[] = {"bass-drum-22", "timpani-26"};
  for (size_t i = 0; i < 2; i++) {
    const TaborDrumDef before = preset(drums[i]);
    TaborDrumDef def = before;
    for (uint32_t choice = 0; choice < STICK_CHOICE_COUNT; choice++)
      stick_choice_take(choice, &def);
    assert_memory_equal(&def, &before, sizeof def);
  }
  const TaborDrumDef before = preset("snare-14x5.5");
  TaborDrumDef def = before;
  stick_choice_take(0, &def);
  stick_choice_take(STICK_CHOICE_COUNT, &def);
  assert_memory_equal(&def, &before, sizeof def);
}

static void every_choice_has_a_word(void **state) {
  (void)state;
  uint32_t words = 1;
  for (const char *at = STICK_CHOICES; *at; at++) words += *at == '|';
  assert_int_equal(words, STICK_CHOICE_COUNT);
  assert_true(knobs[KNOB_STICK].maximum == STICK_CHOICE_COUNT - 1);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(numbers_follow_from_sizes),
    cmocka_unit_test(nylon_is_harder),
    cmocka_unit_test(others_stay),
    cmocka_unit_test(every_choice_has_a_word),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
