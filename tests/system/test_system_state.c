/* SPDX-License-Identifier: MIT */
/* The state of a drum is one thing: it can be put back to rest, saved, carried over and continued.
 *
 * usage: test_system_state [brief]: of drums with few modes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "drum_script.h"

/* In mid-ring: a striker just left, the wires chatter, a parameter is still moving. */
enum { MIDDLE = 1166 };

static bool brief;
static TaborModel *model;
static Script script;
static Take whole; /* played in one go */

static TaborModel *model_of(const char *preset) {
  return (brief ? script_narrow_model : script_model)(preset, TABOR_QUALITY_DEFAULT,
                                                      TABOR_INSTRUCTIONS_AUTO);
}

static int set_up(void **state) {
  (void)state;
  model = model_of("tabor");
  script_everything(&script);
  TaborDrum *drum = script_drum(model);
  whole = take_create(model, SCRIPT_FRAMES);
  script_play_all(drum, &script, &whole);
  tabor_drum_destroy(drum);
  return 0;
}

static int tear_down(void **state) {
  (void)state;
  take_destroy(&whole);
  tabor_model_release(model);
  return 0;
}

/* A take whose first half is copied from the whole, for a drum that plays only the second. */
static Take half_take(void) {
  Take take = take_create(model, SCRIPT_FRAMES);
  for (uint32_t mic = 0; mic < take.mics; mic++) {
    const size_t start = (size_t)mic * take.frames;
    memcpy(take.samples + start, whole.samples + start, MIDDLE * sizeof(float));
  }
  return take;
}

static TaborDrum *drum_in_mid_ring(void) {
  TaborDrum *drum = script_drum(model);
  Take take = take_create(model, SCRIPT_FRAMES);
  script_play(drum, &script, 0, MIDDLE, blocks_of_64, NULL, &take);
  take_destroy(&take);
  return drum;
}

static void assert_whole_again(TaborDrum *drum, const char *what) {
  Take take = take_create(model, SCRIPT_FRAMES);
  script_play_all(drum, &script, &take);
  take_assert_same(&whole, &take, what);
  assert_memory_equal(&take.statistics, &whole.statistics, sizeof take.statistics);
  take_destroy(&take);
}

static void reset_equals_a_fresh_drum(void **state) {
  (void)state;
  TaborDrum *drum = drum_in_mid_ring();
  tabor_drum_reset(drum);
  const TaborLedger nothing = {0};
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  assert_memory_equal(&ledger, &nothing, sizeof nothing);
  assert_true(tabor_drum_is_silent(drum));
  assert_whole_again(drum, "after tabor_drum_reset()");
  tabor_drum_destroy(drum);
}

static void a_reset_event_equals_a_fresh_drum(void **state) {
  (void)state;
  TaborDrum *drum = drum_in_mid_ring();
  const TaborEvent reset = {.frame = 6, .type = TABOR_EVENT_RESET};
  tabor_drum_process(drum, &reset, 1, NULL, 7);
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.frames, 1); /* statistics restart with the reset's own frame */
  tabor_drum_reset(drum);
  assert_whole_again(drum, "after TABOR_EVENT_RESET");
  tabor_drum_destroy(drum);
}

/* The swap is an event at frame `when`; the new model is built anew from the same definition. */
static void swap_to_a_twin(uint32_t when) {
  TaborModel *twin = model_of("tabor");
  TaborSwap *swap = NULL;
  assert_int_equal(tabor_swap_create(model, twin, &swap, NULL), TABOR_OK);
  assert_false(tabor_swap_done(swap));

  Script swapped = {.count = 0};
  uint32_t next = 0;
  while (script.events[next].frame < when) script_add(&swapped, script.events[next++]);
  script_add(&swapped, (TaborEvent){.frame = when, .type = TABOR_EVENT_SWAP, .swap = swap});
  while (next < script.count) script_add(&swapped, script.events[next++]);

  TaborDrum *drum = script_drum(model);
  Take take = take_create(model, SCRIPT_FRAMES);
  script_play_all(drum, &swapped, &take);
  assert_int_equal(take.statistics.dropped_events, whole.statistics.dropped_events);
  take_assert_same(&whole, &take, "swap to a twin");
  assert_true(tabor_swap_done(swap));
  assert_ptr_equal(tabor_drum_model(drum), twin);
  tabor_swap_destroy(swap);
  tabor_drum_reset(drum);
  assert_whole_again(drum, "on the twin");
  tabor_drum_destroy(drum);
  take_destroy(&take);
  tabor_model_release(twin);
}

/* Wires leave the head for some steps and meet it again: what they did last goes on in between. */
static void swapping_to_an_identical_model_changes_no_bit(void **state) {
  (void)state;
  static const uint32_t WHEN[] = {173, 270, 829, MIDDLE, 1225, 1720, 2400};
  for (size_t i = 0; i < sizeof WHEN / sizeof *WHEN; i++) swap_to_a_twin(WHEN[i]);
}

static void a_saved_state_continues_to_the_same_bit(void **state) {
  (void)state;
  TaborDrum *drum = drum_in_mid_ring();
  const size_t size = tabor_drum_state_size(drum);
  unsigned char *bytes = malloc(size);
  assert_non_null(bytes);
  tabor_drum_state_save(drum, bytes);
  tabor_drum_destroy(drum);

  TaborDrum *other = script_drum(model);
  assert_int_equal(tabor_drum_state_load(other, bytes, size), TABOR_OK);
  Take take = half_take();
  script_play(other, &script, MIDDLE, SCRIPT_FRAMES, blocks_of_64, NULL, &take);
  take_assert_same(&whole, &take, "from a saved state");
  assert_memory_equal(&take.statistics, &whole.statistics, sizeof take.statistics);
  tabor_drum_destroy(other);
  take_destroy(&take);
  free(bytes);
}

static void assert_refused(TaborDrum *drum, const unsigned char *bytes, size_t size,
                           const char *what) {
  if (tabor_drum_state_load(drum, bytes, size) != TABOR_ERROR_STATE)
    fail_msg("%s was accepted", what);
}

/* No bit of the drum changes either: it saves the same bytes as before, and plays on. */
static void a_damaged_state_is_refused_and_changes_nothing(void **state) {
  (void)state;
  TaborDrum *drum = drum_in_mid_ring();
  const size_t size = tabor_drum_state_size(drum);
  unsigned char *before = malloc(size), *bytes = malloc(size + 1), *after = malloc(size);
  assert_true(before && bytes && after);
  tabor_drum_state_save(drum, before);

  TaborDrum *fresh = script_drum(model);
  tabor_drum_state_save(fresh, bytes);
  tabor_drum_destroy(fresh);
  bytes[size] = 0;
  assert_refused(drum, bytes, 0, "an empty state");
  assert_refused(drum, bytes, size - 1, "a short state");
  assert_refused(drum, bytes, size + 1, "a long state");
  const size_t stride = size / 97 | 1;
  for (size_t i = 0; i < size; i += i < 64 ? 1 : stride) {
    const unsigned char bit = (unsigned char)(1u << i % 8);
    char what[96];
    snprintf(what, sizeof what, "a wrong bit in byte %zu of %zu", i, size);
    bytes[i] ^= bit;
    assert_refused(drum, bytes, size, what);
    bytes[i] ^= bit;
  }
  memset(bytes, 0xff, size);
  assert_refused(drum, bytes, size, "all ones");
  memset(bytes, 0, size);
  assert_refused(drum, bytes, size, "all zeros");

  tabor_drum_state_save(drum, after);
  assert_memory_equal(before, after, size);
  Take take = half_take();
  script_play(drum, &script, MIDDLE, SCRIPT_FRAMES, blocks_of_64, NULL, &take);
  take_assert_same(&whole, &take, "after damaged states");
  tabor_drum_destroy(drum);
  take_destroy(&take);
  free(before);
  free(bytes);
  free(after);
}

static void a_state_of_another_model_is_refused(void **state) {
  (void)state;
  TaborModel *other_model = model_of("bodhran-d-string");
  TaborDrum *drum = drum_in_mid_ring(), *other = script_drum(other_model);
  const size_t size = tabor_drum_state_size(drum);
  unsigned char *bytes = malloc(size);
  assert_non_null(bytes);
  tabor_drum_state_save(drum, bytes);
  assert_refused(other, bytes, size, "another model's state");
  assert_true(tabor_drum_is_silent(other));
  tabor_drum_destroy(drum);
  tabor_drum_destroy(other);
  tabor_model_release(other_model);
  free(bytes);
}

/* ---- directions ----------------------------------------------------------------------------- */

enum { TURN_FRAMES = 64 };

/* A drum on which each kind of striker, a brush that moves and a hand are at `angle`. */
static void play_at(TaborDrum *drum, uint32_t striker, TaborTechnique technique, double angle) {
  const TaborEvent events[] = {
    {.type = TABOR_EVENT_STRIKE,
     .id = 1,
     .striker = striker,
     .technique = technique,
     .velocity = 1.0,
     .radius = 0.05,
     .angle = angle,
     .value = 0.5},
    {.type = TABOR_EVENT_DAMP, .id = 2, .radius = 0.1, .angle = angle, .value = 10.0},
    {.frame = 9, .type = TABOR_EVENT_MOVE, .id = 1, .radius = 0.1, .angle = -angle, .value = 0.1},
  };
  tabor_drum_process(drum, events, sizeof events / sizeof *events, NULL, TURN_FRAMES);
}

static unsigned char *state_at(TaborModel *drums, uint32_t striker, TaborTechnique technique,
                               double angle, size_t *size) {
  TaborDrum *drum = script_drum(drums);
  play_at(drum, striker, technique, angle);
  *size = tabor_drum_state_size(drum);
  unsigned char *bytes = malloc(*size);
  assert_non_null(bytes);
  tabor_drum_state_save(drum, bytes);
  tabor_drum_destroy(drum);
  return bytes;
}

static void assert_loads(TaborModel *drums, uint32_t striker, TaborTechnique technique,
                         double angle) {
  size_t size;
  TaborDrum *other = script_drum(drums);
  unsigned char *bytes = state_at(drums, striker, technique, angle, &size);
  if (tabor_drum_state_load(other, bytes, size) != TABOR_OK) {
    fail_msg("striker %u, technique %d at %g degrees: its state is refused", striker,
             (int)technique, angle);
  }
  tabor_drum_destroy(other);
  free(bytes);
}

static void assert_same_direction(TaborModel *drums, uint32_t striker, TaborTechnique technique,
                                  double angle, double turned) {
  size_t size, other_size;
  unsigned char *bytes = state_at(drums, striker, technique, angle, &size);
  unsigned char *other = state_at(drums, striker, technique, turned, &other_size);
  assert_int_equal(size, other_size);
  assert_memory_equal(bytes, other, size);
  free(bytes);
  free(other);
}

/* A cross-stick's tip is 180 degrees further than the stroke, so it is the one that goes too far.
 */
static void a_state_with_any_angle_is_loaded(void **state) {
  (void)state;
  static const double ANGLES[] = {-1e300, -1e6, -999999.5, -540.0, 540.0, 999999.5, 1e6, 1e300};
  TaborModel *drums = script_model("snare-14x5.5", TABOR_QUALITY_DRAFT, TABOR_INSTRUCTIONS_AUTO);
  const uint32_t strikers = tabor_model_definition(drums)->striker_count;
  for (uint32_t striker = 0; striker < strikers; striker++) {
    for (uint32_t technique = 0; technique <= TABOR_TECHNIQUE_SWEEP; technique++) {
      for (size_t i = 0; i < sizeof ANGLES / sizeof *ANGLES; i++) {
        assert_loads(drums, striker, (TaborTechnique)technique, ANGLES[i]);
      }
      /* whole turns, so the same place to the bit */
      assert_same_direction(drums, striker, (TaborTechnique)technique, 30.1015625,
                            360.0 * 2777 + 30.1015625);
      assert_same_direction(drums, striker, (TaborTechnique)technique, -30.1015625,
                            -360.0 * 2777 - 30.1015625);
    }
  }
  tabor_model_release(drums);
}

int main(int argc, char **argv) {
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(reset_equals_a_fresh_drum),
    cmocka_unit_test(a_reset_event_equals_a_fresh_drum),
    cmocka_unit_test(swapping_to_an_identical_model_changes_no_bit),
    cmocka_unit_test(a_saved_state_continues_to_the_same_bit),
    cmocka_unit_test(a_damaged_state_is_refused_and_changes_nothing),
    cmocka_unit_test(a_state_of_another_model_is_refused),
    cmocka_unit_test(a_state_with_any_angle_is_loaded),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
