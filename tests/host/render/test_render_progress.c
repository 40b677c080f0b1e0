/* SPDX-License-Identifier: MIT */
/* What is said of how far a rendering is. */
#include "render/render_progress.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define RATE 48000.0

/* A sound of which so many seconds have been played; a length of 0: until the drum has died away.
 */
static RenderJob sound(double played, double last_stroke, double length) {
  return (RenderJob){.rate = RATE,
                     .last_stroke = last_stroke,
                     .length = length,
                     .played = (unsigned)(played * RATE)};
}

static RenderJob finished_sound(double played, double last_stroke, double length) {
  RenderJob job = sound(played, last_stroke, length);
  atomic_store(&job.finished, true);
  return job;
}

static void expect_text(const char *expected, RenderJob *jobs, size_t count, size_t left,
                        double elapsed) {
  RenderBatch batch = {.jobs = jobs, .count = count};
  char text[RENDER_PROGRESS_SIZE];
  render_progress_text(&batch, left, elapsed, text, sizeof text);
  assert_string_equal(text, expected);
}

static void a_sound_of_known_length(void **state) {
  (void)state;
  RenderJob job = sound(2.5, 0, 10);
  expect_text("2 s, 25 %, about 0:15 left", &job, 1, 1, 5);
  job = sound(2.5, 0, 10);
  expect_text("2 s, 25 %, about 1:30 left", &job, 1, 1, 30);
  job = sound(10, 0, 10);
  expect_text("10 s, 99 %, about 0:00 left", &job, 1, 1, 5);
}

static void no_forecast_without_a_ground(void **state) {
  (void)state;
  RenderJob job = sound(2.5, 0, 10);
  expect_text("2 s, 25 %", &job, 1, 1, 0.5);
  job = sound(0.1, 0, 10);
  expect_text("0 s, 1 %", &job, 1, 1, 5);
}

/* A drum that rings on for longer than was thought takes nothing back. */
static void progress_never_shrinks(void **state) {
  (void)state;
  RenderJob jobs[2] = {sound(3, 0, 0), sound(0, 0, 0)};
  RenderBatch batch = {.jobs = jobs, .count = 2};
  char text[RENDER_PROGRESS_SIZE];
  render_progress_text(&batch, 2, 0.5, text, sizeof text);
  assert_string_equal(text, "0 of 2 done, 50 %");
  atomic_store(&jobs[0].played, 12 * 48000);
  atomic_store(&jobs[0].finished, true); /* so the other one will probably last for 12 s, too */
  atomic_store(&jobs[1].played, 48000 / 2);
  render_progress_text(&batch, 1, 0.5, text, sizeof text);
  assert_string_equal(text, "1 of 2 done, 52 %");
  atomic_store(&jobs[0].played, 24 * 48000);
  render_progress_text(&batch, 1, 0.5, text, sizeof text);
  assert_string_equal(text, "1 of 2 done, 52 %");
}

/* After its last stroke a drum sounds as long as it likes. */
static void strokes_without_a_length(void **state) {
  (void)state;
  RenderJob job = sound(10, 17, 0);
  expect_text("10 s, 50 %, about 0:04 left", &job, 1, 1, 4);
  job = sound(18, 17, 0);
  expect_text("18 s", &job, 1, 1, 4);
  job = sound(2, 0, 0);
  expect_text("2 s", &job, 1, 1, 4);
}

static void several_sounds(void **state) {
  (void)state;
  RenderJob jobs[] = {finished_sound(10, 0, 10), sound(5, 0, 10), sound(0, 0, 10), sound(0, 0, 10)};
  expect_text("1 of 4 done, 37 %, about 0:10 left", jobs, 4, 3, 6);
  expect_text("1 of 4 done, 37 %", jobs, 4, 3, 0.2);
}

/* Those that have died away say how long the others will sound: 4 s here after the last stroke. */
static void several_sounds_without_a_length(void **state) {
  (void)state;
  RenderJob jobs[] = {finished_sound(5, 1, 0), sound(0, 1, 0)};
  expect_text("1 of 2 done, 50 %, about 0:08 left", jobs, 2, 1, 8);
}

/* What could not be read has no sound. */
static void sounds_that_failed(void **state) {
  (void)state;
  RenderJob jobs[] = {{.outcome = OUTCOME_FAILED}, sound(5, 0, 10)};
  atomic_store(&jobs[0].finished, true);
  expect_text("1 of 2 done, 50 %, about 0:05 left", jobs, 2, 1, 5);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_sound_of_known_length),  cmocka_unit_test(no_forecast_without_a_ground),
    cmocka_unit_test(strokes_without_a_length), cmocka_unit_test(progress_never_shrinks),
    cmocka_unit_test(several_sounds),           cmocka_unit_test(several_sounds_without_a_length),
    cmocka_unit_test(sounds_that_failed),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
