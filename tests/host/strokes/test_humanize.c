/* SPDX-License-Identifier: MIT */
/* The scatter of strokes: its bounds, its distribution, its seeds. */
#include "strokes/humanize.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#define STROKES 20000
#define HEAD 0.1778 /* [m] */
#define PI 3.14159265358979323846

/* Standard errors that a mean of STROKES draws may be off: one run in 15,000 for a random seed, and
   these seeds are fixed. */
#define MEAN_ERRORS 4.0

static TaborEvent stroke(double radius, double angle) {
  return (TaborEvent){.frame = 7,
                      .type = TABOR_EVENT_STRIKE,
                      .id = 3,
                      .velocity = 2.5,
                      .radius = radius,
                      .angle = angle};
}

static void amount_zero_changes_no_bit(void **state) {
  (void)state;
  Humanizer player = humanizer(0, 1);
  for (int i = 0; i < 100; i++) {
    const TaborEvent before = stroke(HEAD * i / 99, 3.6 * i);
    TaborEvent event = before;
    humanize(&player, HEAD, &event);
    assert_memory_equal(&event, &before, sizeof event);
  }
}

static void other_events_stay_as_they_are(void **state) {
  (void)state;
  Humanizer player = humanizer(1, 1);
  const uint64_t untouched = player.state;
  for (uint32_t type = TABOR_EVENT_PRESS; type <= TABOR_EVENT_RESET; type++) {
    TaborEvent before = stroke(0.05, 30);
    before.type = type;
    TaborEvent event = before;
    humanize(&player, HEAD, &event);
    assert_memory_equal(&event, &before, sizeof event);
  }
  assert_true(player.state == untouched);
}

/* How far the place moved [m]. */
static double move_of(const TaborEvent *from, const TaborEvent *to, double *x, double *y) {
  const double a = from->angle * PI / 180, b = to->angle * PI / 180;
  *x = to->radius * cos(b) - from->radius * cos(a);
  *y = to->radius * sin(b) - from->radius * sin(a);
  return hypot(*x, *y);
}

static void places_lie_evenly_on_a_disc(void **state) {
  (void)state;
  const double amounts[] = {1, 0.3};
  for (int a = 0; a < 2; a++) {
    const double reach = amounts[a] * HUMANIZE_PLACE;
    Humanizer player = humanizer(amounts[a], 42);
    double farthest = 0, sum_x = 0, sum_y = 0;
    int inner = 0;
    for (int i = 0; i < STROKES; i++) {
      const TaborEvent before = stroke(0.1, 77);
      TaborEvent event = before;
      humanize(&player, HEAD, &event);
      double x, y;
      const double move = move_of(&before, &event, &x, &y);
      farthest = fmax(farthest, move);
      inner += move < reach / sqrt(2.0); /* half of the disc */
      sum_x += x;
      sum_y += y;
    }
    print_message("seed 42, amount %g: up to %.4g mm, %d of %d inside\n", amounts[a],
                  1e3 * farthest, inner, STROKES);
    assert_true(farthest <= reach * (1 + 1e-12)); /* rounding */
    assert_true(farthest > 0.999 * reach);        /* STROKES draws all below: (0.998)^20000 */
    const double error = MEAN_ERRORS * 0.5 * reach / sqrt(STROKES); /* x deviates by reach/2 */
    assert_true(fabs(sum_x / STROKES) < error && fabs(sum_y / STROKES) < error);
    assert_true(fabs(inner - STROKES / 2.0) < MEAN_ERRORS * 0.5 * sqrt(STROKES));
  }
}

static void speeds_are_triangular(void **state) {
  (void)state;
  Humanizer player = humanizer(1, 5);
  double largest = 0, sum = 0, squares = 0;
  for (int i = 0; i < STROKES; i++) {
    TaborEvent event = stroke(0.1, 0);
    humanize(&player, HEAD, &event);
    const double change = event.velocity / 2.5 - 1;
    largest = fmax(largest, fabs(change));
    sum += change;
    squares += change * change;
  }
  const double deviation = HUMANIZE_SPEED / sqrt(6.0); /* of a triangle that wide */
  print_message("seed 5: speed changes by up to %.3g %%, deviation %.3g %%\n", 100 * largest,
                100 * sqrt(squares / STROKES));
  assert_true(largest <= HUMANIZE_SPEED * (1 + 1e-12));
  assert_true(largest > 0.95 * HUMANIZE_SPEED);
  assert_true(fabs(sum / STROKES) < MEAN_ERRORS * deviation / sqrt(STROKES));
  assert_true(fabs(sqrt(squares / STROKES) / deviation - 1) <
              0.02); /* a few of 1/sqrt(2 STROKES) */
}

static void strokes_stay_on_the_head(void **state) {
  (void)state;
  Humanizer player = humanizer(1, 9);
  const double heads[] = {HEAD, 0.05, 0.001}; /* the last smaller than the scatter */
  for (int h = 0; h < 3; h++) {
    for (int i = 0; i < 2000; i++) {
      TaborEvent event = stroke(i % 2 ? heads[h] : 0, 360);
      humanize(&player, heads[h], &event);
      assert_true(event.radius >= 0 && event.radius <= heads[h]);
      assert_true(isfinite(event.angle));
    }
  }
}

static void seeds_decide(void **state) {
  (void)state;
  Humanizer first = humanizer(0.3, 1), same = humanizer(0.3, 1), other = humanizer(0.3, 2);
  int different = 0;
  for (int i = 0; i < 100; i++) {
    TaborEvent a = stroke(0.05, 0), b = a, c = a;
    humanize(&first, HEAD, &a);
    humanize(&same, HEAD, &b);
    humanize(&other, HEAD, &c);
    assert_memory_equal(&a, &b, sizeof a);
    different += memcmp(&a, &c, sizeof a) != 0;
  }
  assert_int_equal(different, 100);
}

/* The published first outputs of SplitMix64 for seed 1234567, by way of what they do to a stroke.
 */
static void generator_is_the_published_one(void **state) {
  (void)state;
  const uint64_t published[] = {6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
                                4593380528125082431u};
  double share[4];
  for (int i = 0; i < 4; i++) share[i] = (double)(published[i] >> 11) / 9007199254740992.0;
  Humanizer player = humanizer(1, 1234567);
  TaborEvent event = stroke(0, 0);
  humanize(&player, HEAD, &event);
  const double x = 2 * share[0] - 1, y = 2 * share[1] - 1; /* inside the disc */
  assert_true(fabs(event.radius - 0.015 * hypot(x, y)) < 1e-15);
  assert_true(fabs(event.angle - atan2(y, x) * 180 / PI) < 1e-9);
  assert_true(fabs(event.velocity - 2.5 * (1 + 0.06 * (share[2] - share[3]))) < 1e-14);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(amount_zero_changes_no_bit),
    cmocka_unit_test(other_events_stay_as_they_are),
    cmocka_unit_test(places_lie_evenly_on_a_disc),
    cmocka_unit_test(speeds_are_triangular),
    cmocka_unit_test(strokes_stay_on_the_head),
    cmocka_unit_test(seeds_decide),
    cmocka_unit_test(generator_is_the_published_one),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
