/* SPDX-License-Identifier: MIT */
/* The reader of decimal numbers beside strtod(), which this C library rounds correctly. Tests run
 * in the C locale. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "math/decimal.h"

static void check(const char *text) {
  const double expected = strtod(text, NULL), value = tb_decimal_read(text);
  if (memcmp(&value, &expected, sizeof value) != 0)
    fail_msg("%.60s: %a instead of %a", text, value, expected);
}

static uint64_t draw(uint64_t *seed) {
  *seed = *seed * 6364136223846793005u + 1442695040888963407u;
  return *seed >> 11;
}

static void known_ones(void **state) {
  (void)state;
  static const char *const texts[] = {
    "0",
    "-0",
    "+0",
    "0.0",
    "-0e5",
    "00000",
    ".0",
    "0.",
    "1",
    "-1",
    "+1",
    "1.",
    ".5",
    "0.1",
    "3480",
    "5e-4",
    "1e23",
    "8.5e22",
    "1e22",
    "1e-22",
    "123456789012345678901234567890",
    "9007199254740993",
    "9007199254740992.5",
    "9007199254740993.0000000000000000000000000000000000000000000001",
    /* around the ends of the range */
    "1.7976931348623157e308",
    "1.7976931348623158e308",
    "1.7976931348623159e308",
    "1.8e308",
    "1e309",
    "1e400",
    "1e401",
    "1e99999999999999999999",
    "-1e99999999999999999999",
    "1e-99999999999999999999",
    "2.2250738585072014e-308",
    "2.2250738585072011e-308",
    "2.225073858507201e-308",
    "4.9e-324",
    "2.4703282292062327e-324",
    "2.4703282292062328e-324",
    "2.4703282292062329e-324",
    "1e-324",
    "1e-400",
    "0e99999999999",
    "0.000000000000000000000000000000000000000000000000000000000000000000001e70",
    "100000000000000000000000000000000000000000000000000000000000000000000000000000000000000e-86",
  };
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) check(texts[i]);
}

static void random_ones(void **state) {
  (void)state;
  uint64_t seed = 1;
  char text[100];
  for (int i = 0; i < 100000; i++) {
    const uint64_t whole = draw(&seed) >> (draw(&seed) % 53);
    const int exponent = (int)(draw(&seed) % (i % 2 ? 60 : 700)) - (i % 2 ? 30 : 360);
    snprintf(text, sizeof text, "%s%llu.%llue%d", i % 3 ? "" : "-", (unsigned long long)whole,
             (unsigned long long)draw(&seed), exponent);
    check(text);
    snprintf(text, sizeof text, "%llue%d", (unsigned long long)whole % 100000, exponent / 10);
    check(text);
  }
}

/* All digits of a number half-way between two doubles; then one digit more, far behind. */
static void halves(void **state) {
  (void)state;
#ifdef _WIN32
  enum { FIRST = 200 }; /* mingw's strtod() makes 2^-1022 of some smaller numbers */
#else
  enum { FIRST = 0 };
#endif
  uint64_t seed = 2;
  char text[1400];
  for (int i = FIRST; i < 3000; i++) {
    const int exponent = i < 200 ? -1074 : (int)(draw(&seed) % 2000) - 1074;
    const uint64_t mantissa = i < 200 ? draw(&seed) >> (i % 53) : draw(&seed) | (uint64_t)1 << 52;
    const long double half = ldexpl((long double)(2 * mantissa + 1), exponent - 1);
    if (half > DBL_MAX) continue;
    snprintf(text, sizeof text, "%.1100Le", half);
    check(text);
    char *const e = strchr(text, 'e');
    e[-1] = '1';
    check(text);
  }
}

/* More digits than are kept. */
static void long_ones(void **state) {
  (void)state;
  enum { LENGTH = 5000 };
  static char text[LENGTH + 30];
  for (int kind = 0; kind < 4; kind++) {
    memset(text, kind % 2 ? '9' : '0', LENGTH);
    memcpy(text, kind < 2 ? "9007199254740993" : "0.900719925474099350", kind < 2 ? 16 : 20);
    strcpy(text + LENGTH, kind < 2 ? "e-4980" : "7e10");
    check(text);
    text[LENGTH - 1] = '1';
    check(text);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(known_ones), cmocka_unit_test(random_ones),
                                     cmocka_unit_test(halves), cmocka_unit_test(long_ones)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
