/* SPDX-License-Identifier: MIT */
/*
 * The audio functions allocate nothing and lock nothing. The linker sends every such call of this
 * program, the engine's included, through the counters below (tests/CMakeLists.txt lists them).
 */
#include <pthread.h>
#include <semaphore.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <threads.h>

#include <cmocka.h>

#include "drum_script.h"

/* Volatile: a compiler knows that malloc does not change a program's own variables. */
static volatile long allocations, locks;

/* Declares the true function and defines the one that counts. */
#define WRAP(counter, type, name, parameters, arguments)                                           \
  type __real_##name parameters;                                                                   \
  type __wrap_##name parameters;                                                                   \
  type __wrap_##name parameters {                                                                  \
    counter++;                                                                                     \
    return __real_##name arguments;                                                                \
  }

WRAP(allocations, void *, malloc, (size_t size), (size))
WRAP(allocations, void *, calloc, (size_t count, size_t size), (count, size))
WRAP(allocations, void *, realloc, (void *memory, size_t size), (memory, size))
WRAP(allocations, void *, aligned_alloc, (size_t alignment, size_t size), (alignment, size))
WRAP(allocations, int, posix_memalign, (void **memory, size_t alignment, size_t size),
     (memory, alignment, size))
void __real_free(void *memory);
void __wrap_free(void *memory);
void __wrap_free(void *memory) {
  allocations++;
  __real_free(memory);
}

WRAP(locks, int, pthread_mutex_lock, (pthread_mutex_t * mutex), (mutex))
WRAP(locks, int, pthread_mutex_trylock, (pthread_mutex_t * mutex), (mutex))
WRAP(locks, int, pthread_cond_wait, (pthread_cond_t * condition, pthread_mutex_t *mutex),
     (condition, mutex))
WRAP(locks, int, pthread_rwlock_rdlock, (pthread_rwlock_t * lock), (lock))
WRAP(locks, int, pthread_rwlock_wrlock, (pthread_rwlock_t * lock), (lock))
WRAP(locks, int, pthread_spin_lock, (pthread_spinlock_t * lock), (lock))
WRAP(locks, int, mtx_lock, (mtx_t * mutex), (mutex))
WRAP(locks, int, sem_wait, (sem_t * semaphore), (semaphore))

static void start_counting(void) { allocations = locks = 0; }

static void assert_nothing_was_counted(const char *what) {
  const long seen_allocations = allocations, seen_locks = locks;
  if (seen_allocations || seen_locks) {
    fail_msg("%s: %ld calls of the allocator, %ld of locks", what, seen_allocations, seen_locks);
  }
}

/* A counter that cannot count would find nothing either. */
static void the_counters_count(void **state) {
  (void)state;
  start_counting();
  void *volatile memory = malloc(100);
  assert_int_equal(allocations, 1);
  free(memory);
  assert_int_equal(allocations, 2);
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  pthread_mutex_lock(&mutex);
  assert_int_equal(locks, 1);
  pthread_mutex_unlock(&mutex);

  /* And they see the engine's own calls: set-up needs memory. */
  TaborModel *model = script_model("frame-drum", TABOR_QUALITY_DRAFT, TABOR_INSTRUCTIONS_AUTO);
  start_counting();
  TaborDrum *drum = script_drum(model);
  assert_true(allocations > 0);
  start_counting();
  tabor_drum_destroy(drum);
  assert_true(allocations > 0);
  tabor_model_release(model);
}

/* Plays everything of drum_script.h, with everything else that an audio thread may call in between.
 */
static void perform(TaborDrum *drum, TaborView *view, const Script *script, Take *take,
                    void *bytes) {
  TaborLedger ledger;
  TaborStatistics statistics;
  TaborProbe probe;
  script_play_all(drum, script, take);
  tabor_drum_ledger(drum, &ledger);
  tabor_drum_statistics(drum, &statistics);
  tabor_drum_probe(drum, &probe);
  (void)tabor_drum_view(drum, view);
  (void)tabor_drum_is_silent(drum);
  tabor_drum_state_save(drum, bytes);
  (void)tabor_drum_state_load(drum, bytes, tabor_drum_state_size(drum));
  (void)tabor_drum_state_load(drum, bytes, 3);
  (void)tabor_drum_model(drum);
}

static void playing_allocates_and_locks_nothing(void **state) {
  (void)state;
  TaborModel *model = script_model("tabor", TABOR_QUALITY_DEFAULT, TABOR_INSTRUCTIONS_AUTO);
  TaborDrum *drum = script_drum(model);
  Take take = take_create(model, SCRIPT_FRAMES);
  Script script;
  script_everything(&script);
  script_add(&script, (TaborEvent){.frame = 4501, .type = TABOR_EVENT_RESET});
  script_add(&script, script_strike(4503, 30.0, 1.0, 0.0));
  script_add(&script, (TaborEvent){.frame = 4600, .type = 99});
  void *bytes = malloc(tabor_drum_state_size(drum));
  assert_non_null(bytes);
  TaborView *view;
  assert_int_equal(tabor_view_create(model, NULL, &view, NULL), TABOR_OK);

  start_counting();
  perform(drum, view, &script, &take, bytes);
  tabor_drum_reset(drum);
  assert_nothing_was_counted("playing");

  assert_true(take_peak(&take) > 0.0);
  assert_true(take.statistics.strikes == 1); /* since the reset */
  assert_true(view->ledger.injected > 0.0);  /* it was looked at */
  tabor_view_destroy(view);
  free(bytes);
  take_destroy(&take);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* The one kind carries the state over, the other lets the old drum fade out: both in mid-ring. */
static void swapping_allocates_and_locks_nothing(void **state) {
  (void)state;
  TaborModel *models[] = {
    script_model("tabor", TABOR_QUALITY_DEFAULT, TABOR_INSTRUCTIONS_AUTO),
    script_model("tabor", TABOR_QUALITY_LIVE, TABOR_INSTRUCTIONS_AUTO),
    script_model("frame-drum", TABOR_QUALITY_DEFAULT, TABOR_INSTRUCTIONS_AUTO),
  };
  TaborSwap *swaps[2];
  Script script = {.count = 0};
  script_add(&script, script_strike(3, 3.0, 0.03, 17.0));
  for (uint32_t i = 0; i < 2; i++) {
    assert_int_equal(tabor_swap_create(models[i], models[i + 1], &swaps[i], NULL), TABOR_OK);
    script_add(&script,
               (TaborEvent){.frame = 1001 + 1000 * i, .type = TABOR_EVENT_SWAP, .swap = swaps[i]});
  }
  script_add(&script, script_strike(2500, 2.0, 0.03, 17.0));
  TaborDrum *drum = script_drum(models[0]);
  Take take = take_create(models[0], SCRIPT_FRAMES);

  start_counting();
  script_play_all(drum, &script, &take);
  const bool done[] = {tabor_swap_done(swaps[0]), tabor_swap_done(swaps[1])};
  assert_nothing_was_counted("swapping");

  assert_true(done[0] && done[1]);
  assert_int_equal(take.statistics.dropped_events, 0);
  assert_ptr_equal(tabor_drum_model(drum), models[2]);
  tabor_drum_destroy(drum);
  for (int i = 0; i < 2; i++) tabor_swap_destroy(swaps[i]);
  for (int i = 0; i < 3; i++) tabor_model_release(models[i]);
  take_destroy(&take);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_counters_count),
    cmocka_unit_test(playing_allocates_and_locks_nothing),
    cmocka_unit_test(swapping_allocates_and_locks_nothing),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
