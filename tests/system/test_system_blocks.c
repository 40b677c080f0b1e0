/* SPDX-License-Identifier: MIT */
/* Output depends neither on how frames are divided into blocks nor on the caller's processor state.
 *
 * usage: test_system_blocks [brief]: at live alone. */
#define _GNU_SOURCE /* feenableexcept */
#include <fenv.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "drum_script.h"
#include "physics.h"

static const char *const presets[] = {"tabor", "frame-drum", "bodhran-d-string"};
enum { PRESETS = sizeof presets / sizeof *presets };

/* Of the first drum. The others play at one that is quicker to compute. */
static TaborQuality first_quality = TABOR_QUALITY_DEFAULT;

static TaborModel *preset_model(int preset) {
  const TaborQuality quality = preset == 0 ? first_quality : TABOR_QUALITY_LIVE;
  return script_model(presets[preset], quality, TABOR_INSTRUCTIONS_AUTO);
}

/* xorshift64*: small, and the same everywhere. */
static uint64_t random_next(uint64_t *state) {
  *state ^= *state >> 12;
  *state ^= *state << 25;
  *state ^= *state >> 27;
  return *state * UINT64_C(2685821657736338717);
}

/* 0 to 300, often small; an empty block is a block too. */
static uint32_t blocks_at_random(void *context) {
  const uint64_t draw = random_next(context);
  const uint32_t most = draw & 1 ? 8 : 300;
  return (uint32_t)((draw >> 33) % (most + 1));
}

static Take play_fresh(TaborModel *model, const Script *script, BlockSize *size, void *context) {
  TaborDrum *drum = script_drum(model);
  Take take = take_create(model, SCRIPT_FRAMES);
  script_play(drum, script, 0, SCRIPT_FRAMES, size, context, &take);
  tabor_drum_destroy(drum);
  return take;
}

static void every_block_size_gives_the_same_bits(void **state) {
  (void)state;
  static const uint32_t sizes[] = {1, 7, 64, 256, 1024, SCRIPT_FRAMES};
  uint64_t seed = physics_seed();
  Script script;
  script_everything(&script);
  for (int p = 0; p < PRESETS; p++) {
    TaborModel *model = preset_model(p);
    Take first = play_fresh(model, &script, blocks_of_64, NULL);
    assert_true(take_peak(&first) > 0.0);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
      uint32_t size = sizes[i];
      Take other = play_fresh(model, &script, blocks_of, &size);
      char what[96];
      snprintf(what, sizeof what, "%s in blocks of %u", presets[p], size);
      take_assert_same(&first, &other, what);
      take_destroy(&other);
    }
    Take other = play_fresh(model, &script, blocks_at_random, &seed);
    take_assert_same(&first, &other, "blocks of random sizes");
    take_destroy(&other);
    take_destroy(&first);
    tabor_model_release(model);
  }
}

static void silence(Take *take, uint32_t frames) {
  for (uint32_t mic = 0; mic < take->mics; mic++) {
    memset(take->samples + (size_t)mic * take->frames, 0, frames * sizeof(float));
  }
}

/* A NULL channel costs nothing: what was under way to its microphone is missing when it is heard
 * again, all that comes later is there. */
static void what_nobody_hears_sounds_the_same_later(void **state) {
  (void)state;
  enum { UNHEARD = 2400, UNDER_WAY = 600 };
  Script script;
  script_everything(&script);
  TaborModel *model = script_model("tabor", first_quality, TABOR_INSTRUCTIONS_AUTO);
  Take heard = play_fresh(model, &script, blocks_of_64, NULL);
  TaborDrum *drum = script_drum(model);
  Take later = take_create(model, SCRIPT_FRAMES);
  Take nobody = {.mics = 0, .frames = SCRIPT_FRAMES};
  script_play(drum, &script, 0, UNHEARD, blocks_of_64, NULL, &nobody);
  script_play(drum, &script, UNHEARD, SCRIPT_FRAMES, blocks_of_64, NULL, &later);
  silence(&heard, UNHEARD + UNDER_WAY);
  silence(&later, UNHEARD + UNDER_WAY);
  assert_true(take_peak(&heard) > 0.0);
  take_assert_same(&heard, &later, "NULL channels");
  tabor_drum_process(drum, NULL, 0, NULL, 100);
  tabor_drum_process(drum, NULL, 0, NULL, 0);
  tabor_drum_destroy(drum);
  take_destroy(&heard);
  take_destroy(&later);
  tabor_model_release(model);
}

/* A host may round upwards, or trap on floating-point exceptions: that is its own business. */
static void the_callers_floating_point_mode_does_not_matter(void **state) {
  (void)state;
  Script script;
  script_everything(&script);
  TaborModel *model = script_model("tabor", first_quality, TABOR_INSTRUCTIONS_AUTO);
  Take plain = play_fresh(model, &script, blocks_of_64, NULL);
  TaborDrum *drum = script_drum(model);
  Take odd = take_create(model, SCRIPT_FRAMES);

  fenv_t before;
  assert_int_equal(fegetenv(&before), 0);
  assert_int_equal(fesetround(FE_UPWARD), 0);
#ifdef __GLIBC__
  feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW);
  const int trapping = fegetexcept();
#endif
  script_play_all(drum, &script, &odd);
  const int rounding = fegetround();
#ifdef __GLIBC__
  const int trapping_after = fegetexcept();
#endif
  fesetenv(&before);
  fesetround(FE_TONEAREST); /* mingw's fesetenv() leaves the registers of SSE as they are */
  tabor_drum_ledger(drum, &odd.ledger); /* its sums round as its caller does */

  assert_int_equal(rounding, FE_UPWARD);
#ifdef __GLIBC__
  assert_int_equal(trapping_after, trapping);
#endif
  take_assert_same(&plain, &odd, "rounding upwards");
  tabor_drum_destroy(drum);
  take_destroy(&plain);
  take_destroy(&odd);
  tabor_model_release(model);
}

/* The strainer and gravity hold the wires to the head; they have done so since before it began. */
static void a_drum_that_nobody_touches_is_silent(void **state) {
  (void)state;
  for (int p = 0; p < PRESETS; p++) {
    TaborModel *model = preset_model(p);
    const Script script = {.count = 0};
    const TaborLedger nothing = {0};
    TaborDrum *drum = script_drum(model);
    assert_true(tabor_drum_is_silent(drum));
    Take take = take_create(model, SCRIPT_FRAMES);
    script_play_all(drum, &script, &take);
    assert_true(take_peak(&take) == 0.0);
    assert_memory_equal(&take.ledger, &nothing, sizeof nothing);
    assert_true(tabor_drum_is_silent(drum));
    tabor_drum_destroy(drum);
    take_destroy(&take);
    tabor_model_release(model);
  }
}

int main(int count, char **words) {
  if (count > 1 && strcmp(words[1], "brief") == 0) first_quality = TABOR_QUALITY_LIVE;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(every_block_size_gives_the_same_bits),
    cmocka_unit_test(what_nobody_hears_sounds_the_same_later),
    cmocka_unit_test(the_callers_floating_point_mode_does_not_matter),
    cmocka_unit_test(a_drum_that_nobody_touches_is_silent),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
