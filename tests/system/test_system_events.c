/* SPDX-License-Identifier: MIT */
/* Events that are late, out of order or nonsense: acted on or dropped as tabor.h says, and counted. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "drum_script.h"

enum { FRAMES = 512 };

static TaborModel *model;

static int set_up(void **state) {
  (void)state;
  model = script_model("tabor", TABOR_QUALITY_DEFAULT, TABOR_INSTRUCTIONS_AUTO);
  return 0;
}

static int tear_down(void **state) {
  (void)state;
  tabor_model_release(model);
  return 0;
}

/* One block of FRAMES with these events, then another without any. */
static Take play(const TaborEvent *events, uint32_t count) {
  TaborDrum *drum = script_drum(model);
  Take take = take_create(model, 2 * FRAMES);
  for (uint32_t block = 0; block < 2; block++) {
    float *outputs[TABOR_MAX_MICS] = {NULL};
    for (uint32_t mic = 0; mic < take.mics; mic++) {
      outputs[mic] = take.samples + (size_t)mic * take.frames + block * FRAMES;
    }
    tabor_drum_process(drum, block ? NULL : events, block ? 0 : count, outputs, FRAMES);
  }
  tabor_drum_ledger(drum, &take.ledger);
  tabor_drum_statistics(drum, &take.statistics);
  tabor_drum_destroy(drum);
  return take;
}

static void assert_same_and_destroy(Take *a, Take *b, const char *what) {
  take_assert_same(a, b, what);
  take_destroy(a);
  take_destroy(b);
}

static void a_stroke_begins_at_its_frame(void **state) {
  (void)state;
  const TaborEvent stroke = script_strike(101, 3.0, 0.03, 0.0);
  Take take = play(&stroke, 1);
  assert_int_equal(take.statistics.strikes, 1);
  assert_int_equal(take.statistics.frames, 2 * FRAMES);
  assert_int_equal(take.statistics.dropped_events, 0);
  for (uint32_t frame = 0; frame < 101; frame++) assert_true(take.samples[frame] == 0.0f);
  assert_true(take_peak(&take) > 0.0);
  take_destroy(&take);
}

static void a_late_event_acts_at_the_last_frame(void **state) {
  (void)state;
  const TaborEvent late = script_strike(FRAMES + 88, 3.0, 0.03, 0.0);
  const TaborEvent last = script_strike(FRAMES - 1, 3.0, 0.03, 0.0);
  Take a = play(&late, 1);
  Take b = play(&last, 1);
  assert_int_equal(a.statistics.late_events, 1);
  assert_int_equal(b.statistics.late_events, 0);
  assert_int_equal(a.statistics.strikes, 1);
  assert_same_and_destroy(&a, &b, "late");
}

static void a_misordered_event_acts_with_the_one_before_it(void **state) {
  (void)state;
  const TaborEvent misordered[] = {script_strike(200, 3.0, 0.03, 0.0),
                                   script_strike(5, 2.0, 0.06, 90.0)};
  const TaborEvent together[] = {script_strike(200, 3.0, 0.03, 0.0),
                                 script_strike(200, 2.0, 0.06, 90.0)};
  Take a = play(misordered, 2);
  Take b = play(together, 2);
  assert_int_equal(a.statistics.misordered_events, 1);
  assert_int_equal(b.statistics.misordered_events, 0);
  assert_int_equal(a.statistics.strikes, 2);
  assert_same_and_destroy(&a, &b, "misordered");
}

static void values_beyond_their_range_are_clamped(void **state) {
  (void)state;
  const double rim = tabor_model_definition(model)->shell.radius;
  const TaborEvent wild = script_strike(9, 1e9, 0.03, 0.0),
                   fastest = script_strike(9, 30.0, 0.03, 0.0);
  Take a = play(&wild, 1);
  Take b = play(&fastest, 1);
  assert_same_and_destroy(&a, &b, "velocity");

  const TaborEvent outside = script_strike(9, 2.0, 1e9, 0.0),
                   edge = script_strike(9, 2.0, rim, 0.0);
  a = play(&outside, 1);
  b = play(&edge, 1);
  assert_same_and_destroy(&a, &b, "radius");

  const TaborEvent loud[] = {script_parameter(3, "mic.top.gain", 1e9),
                             script_strike(9, 2.0, 0.03, 0.0)};
  const TaborEvent loudest[] = {script_parameter(3, "mic.top.gain", 100.0), loud[1]};
  a = play(loud, 2);
  b = play(loudest, 2);
  assert_int_equal(a.statistics.dropped_events, 0);
  assert_same_and_destroy(&a, &b, "gain");
}

/* Each alone must be dropped and counted, and leave the drum as silent as it was. */
static void nonsense_is_dropped_and_counted(void **state) {
  (void)state;
  const uint32_t gain = tabor_parameter_find("mic.top.gain")->id;
  const uint32_t batter_tension = tabor_parameter_find("batter.tension")->id;
  const TaborEvent nonsense[] = {
    script_strike(1, NAN, 0.03, 0.0),
    script_strike(1, INFINITY, 0.03, 0.0),
    script_strike(1, -INFINITY, 0.03, 0.0),
    script_strike(1, 2.0, NAN, 0.0),
    script_strike(1, 2.0, INFINITY, 0.0),
    script_strike(1, 2.0, 0.03, NAN),
    script_strike(1, 2.0, 0.03, -INFINITY),
    {.type = TABOR_EVENT_STRIKE, .striker = 1000, .velocity = 2.0},
    {.type = TABOR_EVENT_STRIKE, .striker = UINT32_MAX, .velocity = 2.0},
    {.type = TABOR_EVENT_DAMP, .id = 1, .radius = 0.05, .value = NAN},
    {.type = TABOR_EVENT_DAMP, .id = 1, .radius = NAN, .value = 5.0},
    {.type = TABOR_EVENT_DAMP, .id = 1, .radius = 0.05, .angle = INFINITY, .value = 5.0},
    {.type = TABOR_EVENT_PRESS, .id = 1, .value = 1.0},
    {.type = TABOR_EVENT_SWAP, .swap = NULL},
    {.type = 0},
    {.type = 8},
    {.type = UINT32_MAX},
    {.type = TABOR_EVENT_PARAMETER, .parameter = 0, .value = 1.0},
    {.type = TABOR_EVENT_PARAMETER, .parameter = UINT32_MAX, .value = 1.0},
    {.type = TABOR_EVENT_PARAMETER, .parameter = batter_tension, .value = 3000.0},
    {.type = TABOR_EVENT_PARAMETER, .parameter = gain, .index = 1000, .value = 1.0},
    {.type = TABOR_EVENT_PARAMETER, .parameter = gain, .index = UINT32_MAX, .value = 1.0},
    script_parameter(1, "wires.tension", NAN),
    script_parameter(1, "output.full_scale", INFINITY),
    script_parameter(1, "wires.strainer", -INFINITY),
  };
  enum { COUNT = sizeof nonsense / sizeof *nonsense };
  for (uint32_t i = 0; i < COUNT; i++) {
    Take take = play(&nonsense[i], 1);
    if (take.statistics.dropped_events != 1) {
      fail_msg("event %u of the list: %llu dropped", i,
               (unsigned long long)take.statistics.dropped_events);
    }
    assert_true(take_peak(&take) == 0.0);
    assert_true(take.ledger.control == 0.0);
    take_destroy(&take);
  }
  /* And among good events they are as if they had not been there. */
  TaborEvent mixed[COUNT + 1];
  memcpy(mixed, nonsense, sizeof nonsense);
  for (uint32_t i = 0; i < COUNT; i++) mixed[i].frame = 1;
  mixed[COUNT] = script_strike(1, 2.0, 0.03, 0.0);
  Take a = play(mixed, COUNT + 1);
  Take b = play(&mixed[COUNT], 1);
  assert_int_equal(a.statistics.dropped_events, COUNT);
  assert_same_and_destroy(&a, &b, "among good events");
}

static void a_swap_of_another_model_is_dropped(void **state) {
  (void)state;
  TaborModel *other = script_model("frame-drum", TABOR_QUALITY_DRAFT, TABOR_INSTRUCTIONS_AUTO);
  TaborSwap *swap = NULL;
  assert_int_equal(tabor_swap_create(other, model, &swap, NULL), TABOR_OK);
  const TaborEvent event = {.frame = 20, .type = TABOR_EVENT_SWAP, .swap = swap};
  Take take = play(&event, 1);
  assert_int_equal(take.statistics.dropped_events, 1);
  tabor_swap_destroy(swap);
  take_destroy(&take);
  tabor_model_release(other);
}

/* More strokes in one frame than strikers exist: one is taken away for each new one, and counted. */
static void the_pool_of_strikers_is_bounded(void **state) {
  (void)state;
  TaborEvent strokes[3 * TABOR_MAX_ACTIVE];
  enum { COUNT = sizeof strokes / sizeof *strokes };
  for (int i = 0; i < COUNT; i++) strokes[i] = script_strike(7, 4.0, 0.02, 15.0 * i);
  Take take = play(strokes, COUNT);
  assert_int_equal(take.statistics.strikes + take.statistics.dropped_events, COUNT);
  assert_true(take.statistics.strikes >= 1);
  assert_int_equal(take.statistics.recovered, 0);
  assert_true(take_peak(&take) > 0.0);
  take_destroy(&take);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_stroke_begins_at_its_frame),
    cmocka_unit_test(a_late_event_acts_at_the_last_frame),
    cmocka_unit_test(a_misordered_event_acts_with_the_one_before_it),
    cmocka_unit_test(values_beyond_their_range_are_clamped),
    cmocka_unit_test(nonsense_is_dropped_and_counted),
    cmocka_unit_test(a_swap_of_another_model_is_dropped),
    cmocka_unit_test(the_pool_of_strikers_is_bounded),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
