/* SPDX-License-Identifier: MIT */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "kit/kit_division.h"

enum { CASES = 500, SEED = 20261128, MOST_DRUMS = 7, MOST_PARTS = 4 };

static uint32_t random_state = SEED;

static uint32_t random_below(uint32_t limit) {
  random_state = random_state * 1664525u + 1013904223u;
  return (random_state >> 16) % limit;
}

static double dearest_of(const double *cost, const uint32_t *part, uint32_t parts) {
  double most = 0;
  for (uint32_t i = 0; i < parts; i++) {
    double sum = 0;
    for (uint32_t drum = 0; drum < MOST_DRUMS; drum++) sum += part[i] >> drum & 1u ? cost[drum] : 0;
    if (sum > most) most = sum;
  }
  return most;
}

/* The least that the dearest part can cost, by trying all divisions. */
static double best(const double *cost, uint32_t drums, uint32_t parts) {
  uint64_t count = 1;
  for (uint32_t i = 0; i < drums; i++) count *= parts;
  double least = 1e9;
  for (uint64_t code = 0; code < count; code++) {
    uint32_t part[MOST_PARTS] = {0};
    uint64_t rest = code;
    for (uint32_t drum = 0; drum < drums; drum++, rest /= parts) part[rest % parts] |= 1u << drum;
    const double dearest = dearest_of(cost, part, parts);
    if (dearest < least) least = dearest;
  }
  return least;
}

/* One second has passed, of which drums have taken these parts. */
static void measure(KitDivision *division, const double *cost) {
  for (uint32_t i = 0; i < division->drums; i++) division->seconds[i] = cost[i];
  kit_division_renew(division, division->begun + 1);
}

/* Graham's bound for the rule: 4/3 - 1/(3 parts); a twentieth more where a thread is left out. */
static void divisions_are_near_the_best(void **state) {
  (void)state;
  print_message("seed %d\n", SEED);
  for (int i = 0; i < CASES; i++) {
    const uint32_t drums = 2 + random_below(MOST_DRUMS - 1),
                   most = 2 + random_below(MOST_PARTS - 1);
    double cost[MOST_DRUMS] = {0};
    KitDivision division;
    uint32_t all = 0;
    for (uint32_t drum = 0; drum < drums; drum++) cost[drum] = 0.2 + 0.01 * random_below(100);
    kit_division_begin(&division, drums, most);
    measure(&division, cost); /* when it begins is not known yet */
    measure(&division, cost);
    for (uint32_t part = 0; part < division.parts; part++) {
      assert_int_equal(all & division.part[part], 0);
      all |= division.part[part];
    }
    assert_int_equal(all, (1u << drums) - 1u);
    assert_in_range(division.parts, 1, most);
    const double bound = 1.05 * (4.0 / 3 - 1.0 / (3 * most)) * best(cost, drums, most);
    assert_true(dearest_of(cost, division.part, division.parts) <= bound);
  }
}

static void one_thread_is_enough_for_little(void **state) {
  (void)state;
  const double little[3] = {0.06, 0.05, 0.03}, much[3] = {0.4, 0.3, 0.3},
               some[3] = {0.1, 0.07, 0.06};
  KitDivision division;
  kit_division_begin(&division, 3, 4);
  assert_int_equal(division.parts, 1);
  for (int i = 0; i < 3; i++) measure(&division, little);
  assert_int_equal(division.parts, 1);
  measure(&division, much);
  assert_int_equal(division.parts, 3);
  for (int i = 0; i < 9; i++) measure(&division, some); /* between the two limits */
  assert_true(division.parts > 1);
  measure(&division, little);
  assert_int_equal(division.parts, 1);
}

/* A dear drum sets the time of a round: the others share another thread. */
static void no_more_threads_than_help(void **state) {
  (void)state;
  const double cost[4] = {0.5, 0.2, 0.2, 0.1};
  KitDivision division;
  kit_division_begin(&division, 4, 4);
  measure(&division, cost);
  measure(&division, cost);
  assert_int_equal(division.parts, 2);
}

static void drums_stay_where_they_are(void **state) {
  (void)state;
  KitDivision division;
  kit_division_begin(&division, 4, 2);
  for (int i = 0; i < 50; i++) {
    double cost[4] = {0.3, 0.3, 0.2, 0.2};
    for (int drum = 0; drum < 4; drum++) cost[drum] *= 1 + 1e-4 * random_below(200);
    const uint32_t before = division.part[0];
    measure(&division, cost);
    if (i > 1) assert_int_equal(division.part[0], before);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(divisions_are_near_the_best),
    cmocka_unit_test(one_thread_is_enough_for_little),
    cmocka_unit_test(no_more_threads_than_help),
    cmocka_unit_test(drums_stay_where_they_are),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
