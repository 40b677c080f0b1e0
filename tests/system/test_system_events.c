/* SPDX-License-Identifier: MIT */
/* Events that are late, out of order or nonsense: acted on or dropped as tabor.h says, and counted.
 *
 * usage: test_system_events [brief]: of a drum with few modes. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "drum_script.h"

enum { FRAMES = 512 };

static bool brief;
static TaborModel *model;

static TaborModel *tabor(void) {
  return (brief ? script_narrow_model : script_model)("tabor", TABOR_QUALITY_DEFAULT,
                                                      TABOR_INSTRUCTIONS_AUTO);
}

static int set_up(void **state) {
  (void)state;
  model = tabor();
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

/* More strokes in one frame than strikers exist: none is taken away before it has sounded. */
static void the_pool_of_strikers_is_bounded(void **state) {
  (void)state;
  TaborEvent strokes[3 * TABOR_MAX_ACTIVE];
  enum { COUNT = sizeof strokes / sizeof *strokes };
  for (int i = 0; i < COUNT; i++) strokes[i] = script_strike(7, 4.0, 0.02, 15.0 * i);
  Take take = play(strokes, COUNT);
  assert_int_equal(take.statistics.strikes, TABOR_MAX_ACTIVE);
  assert_int_equal(take.statistics.dropped_events, COUNT - TABOR_MAX_ACTIVE);
  assert_int_equal(take.statistics.recovered, 0);
  assert_true(take_peak(&take) > 0.0);
  take_destroy(&take);
}

/* A hand that strikes twice at once holds one stick: one stroke is lost, and counted. */
static void a_stick_that_never_sounded_is_counted(void **state) {
  (void)state;
  TaborEvent buzzes[2] = {script_strike(7, 2.0, 0.02, 0.0), script_strike(7, 2.0, 0.02, 90.0)};
  for (int i = 0; i < 2; i++) {
    buzzes[i].technique = TABOR_TECHNIQUE_BUZZ;
    buzzes[i].id = 3;
    buzzes[i].value = 0.5;
  }
  Take take = play(buzzes, 2);
  assert_int_equal(take.statistics.dropped_events, 1);
  take_destroy(&take);
  buzzes[1].frame = 400; /* the first has sounded */
  take = play(buzzes, 2);
  assert_int_equal(take.statistics.dropped_events, 0);
  take_destroy(&take);
}

/* ---- floods --------------------------------------------------------------------------------- */

enum { FLOOD = 1000 };

static TaborEvent flood[FLOOD + 4];

static void fill_flood(uint32_t last_frame) {
  for (uint32_t i = 0; i < FLOOD; i++) {
    flood[i] = script_strike(i * last_frame / FLOOD, 3.0, 0.03, 0.7 * i);
    flood[i].id = i + 1;
    flood[i].type = i % 5 == 4 ? TABOR_EVENT_DAMP : TABOR_EVENT_STRIKE;
    flood[i].value = 1.0;
  }
}

/* Plays the flood in blocks of `size`. */
static Take play_flood(uint32_t size) {
  TaborDrum *drum = script_drum(model);
  Take take = take_create(model, FRAMES);
  for (uint32_t start = 0; start < FRAMES; start += size) {
    TaborEvent events[FLOOD];
    uint32_t count = 0;
    float *outputs[TABOR_MAX_MICS] = {NULL};
    for (uint32_t mic = 0; mic < take.mics; mic++) {
      outputs[mic] = take.samples + (size_t)mic * take.frames + start;
    }
    for (uint32_t i = 0; i < FLOOD; i++) {
      if (flood[i].frame < start || flood[i].frame >= start + size) continue;
      events[count] = flood[i];
      events[count++].frame -= start;
    }
    tabor_drum_process(drum, events, count, outputs, size);
  }
  tabor_drum_ledger(drum, &take.ledger);
  tabor_drum_statistics(drum, &take.statistics);
  tabor_drum_destroy(drum);
  return take;
}

/* What is dropped does not depend on the division into blocks, nor does the sound. */
static void blocks_do_not_change_a_flood(void **state) {
  (void)state;
  fill_flood(300);
  Take whole = play_flood(FRAMES);
  assert_true(whole.statistics.dropped_events > 0);
  static const uint32_t sizes[] = {1, 64};
  for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
    Take parts = play_flood(sizes[i]);
    assert_int_equal(parts.statistics.dropped_events, whole.statistics.dropped_events);
    take_assert_same(&whole, &parts, "a flood in blocks");
    take_destroy(&parts);
  }
  take_destroy(&whole);
}

/* Behind a thousand strokes at once, a release, a parameter, a swap and a reset still act. */
static void what_ends_or_changes_a_sound_always_acts(void **state) {
  (void)state;
  TaborModel *twin = tabor();
  TaborSwap *swap = NULL;
  assert_int_equal(tabor_swap_create(model, twin, &swap, NULL), TABOR_OK);
  TaborDrum *drum = script_drum(model);
  TaborStatistics statistics;
  float sound[64], *outputs[TABOR_MAX_MICS] = {sound};
  fill_flood(0);
  flood[FLOOD] = (TaborEvent){.type = TABOR_EVENT_RELEASE};
  flood[FLOOD + 1] = script_parameter(0, "mic.top.gain", 0.0);
  flood[FLOOD + 2] = (TaborEvent){.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(drum, flood, FLOOD + 3, NULL, 0);
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.in_play, 0);
  assert_ptr_equal(tabor_drum_model(drum), twin);
  assert_true(tabor_swap_done(swap));

  flood[FLOOD] = (TaborEvent){.type = TABOR_EVENT_RESET};
  tabor_drum_process(drum, flood, FLOOD + 1, outputs, 64);
  assert_true(tabor_drum_is_silent(drum));
  for (int i = 0; i < 64; i++) assert_true(sound[i] == 0.0f);
  tabor_drum_destroy(drum);
  tabor_swap_destroy(swap);
  tabor_model_release(twin);
}

/* A silence acts however many strokes came before it, and those after it find no room. */
static void a_silence_behind_a_flood_acts(void **state) {
  (void)state;
  TaborDrum *drum = script_drum(model);
  TaborStatistics statistics;
  for (uint32_t i = 0; i < FLOOD; i++) {
    flood[i] = script_strike(0, 3.0, 0.03, 0.7 * i);
    if (i % 2 == 1) flood[i].type = TABOR_EVENT_SILENCE;
  }
  tabor_drum_process(drum, flood, FLOOD, NULL, 0);
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.strikes, TABOR_BURST / 8); /* a silence counts like 7 strokes */
  assert_int_equal(statistics.dropped_events, FLOOD / 2 - statistics.strikes);
  assert_int_equal(statistics.in_play, 0);
  tabor_drum_process(drum, NULL, 0, NULL, 721);
  assert_true(tabor_drum_is_silent(drum));
  tabor_drum_destroy(drum);
}

/* Moves of a knob act even behind a flood of strokes; of thousands the last are dropped and
 * counted. */
static void thousands_of_live_changes_are_bounded(void **state) {
  (void)state;
  enum { CHANGES = 3000, LEAST = 1000 };
  TaborDrum *drum = script_drum(model);
  TaborStatistics statistics;
  fill_flood(0);
  tabor_drum_process(drum, flood, FLOOD, NULL, 0);
  tabor_drum_statistics(drum, &statistics);
  const uint64_t before = statistics.dropped_events;
  for (uint32_t i = 0; i < CHANGES; i++) {
    TaborEvent change = script_parameter(0, "mic.top.gain", i % 2);
    if (i % 3 == 0) change.type = TABOR_EVENT_GAIN;
    tabor_drum_process(drum, &change, 1, NULL, 0);
    tabor_drum_statistics(drum, &statistics);
    if (i < LEAST) assert_int_equal(statistics.dropped_events, before);
  }
  assert_true(statistics.dropped_events > before);
  tabor_drum_destroy(drum);
}

/* The debt of a flood is paid back while the drum sleeps, too. */
static void strokes_act_again_after_a_flood(void **state) {
  (void)state;
  TaborDrum *drum = script_drum(model);
  TaborStatistics statistics;
  const TaborEvent reset = {.type = TABOR_EVENT_RESET};
  fill_flood(0);
  for (uint32_t i = 0; i < TABOR_BURST / TABOR_MAX_ACTIVE; i++) {
    tabor_drum_process(drum, flood, FLOOD, NULL, 0);
    tabor_drum_process(drum, &reset, 1, NULL, 0);
  }
  tabor_drum_process(drum, flood, 1, NULL, 0);
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.dropped_events, 1); /* a reset is no way around the bound */
  tabor_drum_process(drum, &reset, 1, NULL, 0);   /* of a drum at rest: free */
  /* 8 strokes, a reset that counts like 7, and one stroke made the burst; a reset came on top of
   * it. */
  tabor_drum_process(drum, NULL, 0, NULL, (7 + 1) * TABOR_BURST_FRAMES);
  tabor_drum_process(drum, flood, 2, NULL, 0);
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.strikes, 1);
  assert_int_equal(statistics.dropped_events, 1);
  tabor_drum_reset(drum); /* as a new one: without debt */
  TaborDrum *fresh = script_drum(model);
  TaborStatistics expected;
  tabor_drum_process(drum, flood, FLOOD, NULL, 0);
  tabor_drum_statistics(drum, &statistics);
  tabor_drum_process(fresh, flood, FLOOD, NULL, 0);
  tabor_drum_statistics(fresh, &expected);
  assert_int_equal(statistics.strikes, expected.strikes);
  assert_int_equal(statistics.dropped_events, expected.dropped_events);
  tabor_drum_destroy(fresh);
  tabor_drum_destroy(drum);
}

int main(int argc, char **argv) {
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_stick_that_never_sounded_is_counted),
    cmocka_unit_test(blocks_do_not_change_a_flood),
    cmocka_unit_test(what_ends_or_changes_a_sound_always_acts),
    cmocka_unit_test(a_silence_behind_a_flood_acts),
    cmocka_unit_test(thousands_of_live_changes_are_bounded),
    cmocka_unit_test(strokes_act_again_after_a_flood),
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
