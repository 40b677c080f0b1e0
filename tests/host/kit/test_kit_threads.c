/* SPDX-License-Identifier: MIT */
/* The threads of a kit, without an engine, under ThreadSanitizer where the compiler has it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "kit/kit_threads.h"

enum { DRUMS = 5, ROUNDS = 20000 };

static TaborKitDef definition = {.drum_count = DRUMS};
static TaborKitRun *runner;
static void *runner_context;

const TaborKitDef *tabor_kit_definition(const TaborKit *kit) {
  (void)kit;
  return &definition;
}

void tabor_kit_set_runner(TaborKit *kit, TaborKitRun *run, void *context) {
  (void)kit;
  runner = run;
  runner_context = context;
}

static unsigned played[DRUMS];

/* Neither atomic nor locked: rounds order what they do. */
static void play(void *kit, uint32_t drum) { ((unsigned *)kit)[drum]++; }

static void each_drum_is_played_once_a_round(void **state) {
  (void)state;
  for (uint32_t count = 2; count <= DRUMS; count++) {
    KitThreads *threads = kit_threads_begin(NULL, count);
    assert_non_null(threads);
    memset(played, 0, sizeof played);
    for (unsigned round = 1; round <= ROUNDS / count; round++) {
      runner(runner_context, play, played, DRUMS);
      for (int i = 0; i < DRUMS; i++) assert_int_equal(played[i], round);
    }
    kit_threads_end(threads, NULL);
    assert_null(runner);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(each_drum_is_played_once_a_round)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
