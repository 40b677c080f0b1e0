/* SPDX-License-Identifier: MIT */
/* Pitches as notes with cents, and back. */
#include "drums/pitch_text.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

#define HALF_CENT 0.00029 /* relative: 2^(1/2400) - 1, as far as rounding to whole cents moves */
#define SAME 1e-12        /* relative: rounding of doubles */

static void says(double frequency, const char *expected) {
  char text[32];
  assert_true(pitch_text(frequency, text, sizeof text) > 0);
  assert_string_equal(text, expected);
}

/* Equal temperament: a semitone is the twelfth root of 2. Frequencies of notes are those of any
 * table. */
static void test_notes_are_named(void **state) {
  (void)state;
  says(440, "A4");
  says(220, "A3");
  says(261.6256, "C4");
  says(184.9972, "F#3");
  says(16.3516, "C0");
  says(15804.27, "B9");
  says(220 * pow(2, 12 / 1200.0), "A3 +12 ct");
  says(220 * pow(2, -5 / 1200.0), "A3 -5 ct");
  says(220 * pow(2, 49.4 / 1200), "A3 +49 ct");
  says(220 * pow(2, 49.6 / 1200), "Bb3 -50 ct");
  says(9.5, "9.5 Hz");
  says(0, "0 Hz");
  says(20000, "20000 Hz");
}

static void reads(const char *text, double expected) {
  double frequency = -1;
  if (!pitch_read(text, &frequency)) fail_msg("'%s'", text);
  if (!(fabs(frequency - expected) <= SAME * expected)) fail_msg("'%s': %.15g", text, frequency);
}

static void test_texts_are_read(void **state) {
  (void)state;
  reads("A3", 220);
  reads("a3", 220);
  reads("A3 +12 ct", 220 * pow(2, 12 / 1200.0));
  reads("A3+12", 220 * pow(2, 12 / 1200.0));
  reads("A#3 -5", 220 * pow(2, 95 / 1200.0));
  reads("Bb3 -5 ct", 220 * pow(2, 95 / 1200.0));
  reads("220 Hz", 220);
  reads("220", 220);
  reads(" 171.2 Hz ", 171.2);
}

static void test_other_texts_are_refused(void **state) {
  (void)state;
  static const char *const texts[] = {"",         "loud",   "nan",     "inf",
                                      "H3",       "A",      "A3 12",   "A3 +120 ct",
                                      "A3 ct ct", "220 ct", "A3 + Hz", "220 Hz Hz"};
  double frequency = 1;
  for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
    if (pitch_read(texts[i], &frequency)) fail_msg("'%s'", texts[i]);
  }
  assert_true(frequency == 1);
}

/* A text that is read gives the same text again, and is within half a cent. */
static void test_texts_are_read_back(void **state) {
  (void)state;
  for (double pitch = 17; pitch < 15000; pitch *= 1.0003) {
    char text[32], again[32];
    double frequency = 0;
    (void)pitch_text(pitch, text, sizeof text);
    assert_true(pitch_read(text, &frequency));
    assert_true(fabs(frequency / pitch - 1) <= HALF_CENT);
    (void)pitch_text(frequency, again, sizeof again);
    assert_string_equal(text, again);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_notes_are_named),
    cmocka_unit_test(test_texts_are_read),
    cmocka_unit_test(test_other_texts_are_refused),
    cmocka_unit_test(test_texts_are_read_back),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
