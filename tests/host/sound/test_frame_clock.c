/* SPDX-License-Identifier: MIT */
/* From times to frames: steady although blocks are asked for at unsteady times. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "sound/frame_clock.h"

#define RATE 48000.0
#define BLOCK 128u

static double noise(uint64_t *state) {
  *state = *state * 6364136223846793005u + 1442695040888963407u;
  return (double)(*state >> 11) / 9007199254740992.0;
}

static void without_a_block_nothing_is_known(void **state) {
  (void)state;
  FrameClock clock;
  frame_clock_start(&clock, RATE, BLOCK);
  assert_int_equal(frame_clock_frame(&clock, 5.0), 0);
}

static void a_steady_device_gives_exact_frames(void **state) {
  (void)state;
  FrameClock clock;
  frame_clock_start(&clock, RATE, BLOCK);
  for (uint64_t frame = 0; frame < 480000; frame += BLOCK) {
    const double now = 1000 + (double)frame / RATE;
    frame_clock_tick(&clock, frame, BLOCK, now);
    assert_int_equal(frame_clock_frame(&clock, now + 77 / RATE), frame + BLOCK + 77);
  }
}

/* Callbacks up to half a block late, a device 100 parts in a million too fast: an event's frame
   stays within a tenth of a millisecond of a constant delay, where block starts alone would
   give 1.3 ms. */
static void jitter_and_drift_are_smoothed(void **state) {
  (void)state;
  const double true_rate = RATE * 1.0001;
  double least = INFINITY, most = -INFINITY;
  uint64_t random = 3;
  FrameClock clock;
  frame_clock_start(&clock, RATE, BLOCK);
  for (uint64_t frame = 0; frame < 60 * 48000; frame += BLOCK) {
    const double due = (double)frame / true_rate, late = 0.5 * BLOCK / RATE * noise(&random);
    frame_clock_tick(&clock, frame, BLOCK, due + late);
    if (frame < 5 * 48000) continue; /* it has to find out first */
    const double time = due + noise(&random) * BLOCK / RATE;
    const double delay = (double)frame_clock_frame(&clock, time) / true_rate - time;
    least = fmin(least, delay);
    most = fmax(most, delay);
  }
  assert_true(most - least < 2e-4);
  assert_true(fabs(most - BLOCK / RATE) < 2e-3);
}

/* A device that stood still, as a suspended computer's, goes on from where it is. */
static void it_follows_a_jump(void **state) {
  (void)state;
  FrameClock clock;
  frame_clock_start(&clock, RATE, 0);
  frame_clock_tick(&clock, 0, BLOCK, 10);
  frame_clock_tick(&clock, BLOCK, BLOCK, 500);
  assert_int_equal(frame_clock_frame(&clock, 500), 2 * BLOCK);
  assert_int_equal(frame_clock_frame(&clock, 1), 0); /* long ago */
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(without_a_block_nothing_is_known),
    cmocka_unit_test(a_steady_device_gives_exact_frames),
    cmocka_unit_test(jitter_and_drift_are_smoothed),
    cmocka_unit_test(it_follows_a_jump),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
