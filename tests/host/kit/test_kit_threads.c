/* SPDX-License-Identifier: MIT */
/* The threads of a kit, without an engine, under ThreadSanitizer where the compiler has it. */
#include <pthread.h>
#include <sched.h>
#include <semaphore.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "kit/kit_threads.h"
#include "platform/clock.h"

enum { DRUMS = 5, ROUNDS = 2000 };

static TaborKitRun *runner;
static void *runner_context;

void tabor_kit_set_runner(TaborKit *kit, TaborKitRun *run, void *context) {
  (void)kit;
  runner = run;
  runner_context = context;
}

/* ---- jobs ----------------------------------------------------------------------------------- */

/* Neither atomic nor locked: rounds order what they do. */
typedef struct Work {
  unsigned played[DRUMS];
  pthread_t by[DRUMS];
  bool is_equal[DRUMS]; /* in priority to the caller */
  int policy;
  double stops; /* [s] a thread beside the caller's in each drum */
} Work;

static pthread_t caller;

static bool is_beside(pthread_t thread) { return !pthread_equal(thread, caller); }

static double now(void) { return stopwatch_seconds(CLOCK_MONOTONIC); }

/* As long as a cheap drum. */
static void play(void *kit, uint32_t drum) {
  Work *const work = kit;
  struct sched_param priority;
  int policy = -1;
  const double begun = now();
  work->played[drum]++;
  work->by[drum] = pthread_self();
  (void)pthread_getschedparam(pthread_self(), &policy, &priority);
  work->is_equal[drum] = policy == work->policy;
  if (is_beside(work->by[drum]) && work->stops > 0) clock_sleep_until(begun + work->stops);
  while (now() - begun < 20e-6) continue;
}

static void play_round(Work *work, uint32_t drums) {
  const unsigned before = work->played[0];
  struct sched_param priority;
  (void)pthread_getschedparam(caller, &work->policy, &priority);
  runner(runner_context, play, work, drums);
  for (uint32_t i = 0; i < drums; i++) {
    assert_int_equal(work->played[i], before + 1);
    assert_true(work->is_equal[i]);
  }
}

static bool has_help(const Work *work) {
  bool any = false;
  for (int i = 0; i < DRUMS; i++) any |= is_beside(work->by[i]);
  return any;
}

/* Plays until another thread than the caller's has played a drum; it has to be asked at least. */
static pthread_t play_with_help(Work *work) {
  const double until = now() + 60;
  do {
    play_round(work, DRUMS);
    if (now() > until) fail_msg("no thread has helped in a minute");
  } while (!has_help(work));
  for (int i = 0;; i++) {
    if (is_beside(work->by[i])) return work->by[i];
  }
}

static KitThreads *begin(uint32_t count, bool is_live, const KitPool *pool) {
  KitThreads *const threads = kit_threads_begin(count, is_live, pool);
  assert_non_null(threads);
  kit_threads_serve(threads, NULL);
  return threads;
}

/* ---- tests ---------------------------------------------------------------------------------- */

static void each_drum_is_played_once_a_round(void **state) {
  (void)state;
  for (uint32_t count = 2; count <= DRUMS; count++) {
    Work work = {.stops = 0};
    KitThreads *const threads = begin(count, false, NULL);
    (void)play_with_help(&work);
    for (unsigned round = 0; round < ROUNDS / count; round++) play_round(&work, DRUMS);
    kit_threads_end(threads);
  }
}

static void kits_of_other_sizes_come_and_go(void **state) {
  (void)state;
  Work work = {.stops = 0};
  KitThreads *const threads = begin(3, false, NULL);
  (void)play_with_help(&work);
  for (unsigned round = 0; round < 100; round++) {
    Work other = {.stops = 0};
    play_round(&other, 1 + round % DRUMS);
    play_round(&work, DRUMS);
  }
  kit_threads_end(threads);
}

/* The system has stopped a thread within a drum: that round is late, those after it are the
 * caller's alone. */
static void who_is_late_is_left_out(void **state) {
  (void)state;
  Work work = {.stops = 0.05};
  KitThreads *const threads = begin(DRUMS, true, NULL);
  (void)play_with_help(&work);
  for (unsigned round = 0; round < 100; round++) {
    play_round(&work, DRUMS);
    assert_false(has_help(&work));
  }
  kit_threads_end(threads);
}

/* From now on no other thread comes back from its sleep, as where the system gives it no processor,
 * until `thaw` is posted. */
static atomic_bool is_frozen;
static atomic_uint frozen;
static sem_t thaw;

int __real_sem_wait(sem_t *semaphore);
int __wrap_sem_wait(sem_t *semaphore);
int __wrap_sem_wait(sem_t *semaphore) {
  if (atomic_load(&is_frozen) && is_beside(pthread_self())) {
    atomic_fetch_add(&frozen, 1u);
    (void)__real_sem_wait(&thaw);
  }
  return __real_sem_wait(semaphore);
}

static void who_does_not_wake_is_not_missed(void **state) {
  (void)state;
  Work work = {.stops = 0};
  assert_int_equal(sem_init(&thaw, 0, 0), 0);
  KitThreads *const threads = begin(2, true, NULL);
  (void)play_with_help(&work);
  atomic_store(&is_frozen, true);
  while (atomic_load(&frozen) == 0) play_round(&work, DRUMS);
  for (unsigned round = 0; round < ROUNDS; round++) {
    play_round(&work, DRUMS);
    assert_false(has_help(&work));
  }
  atomic_store(&is_frozen, false);
  assert_int_equal(sem_post(&thaw), 0);
  kit_threads_end(threads);
  assert_int_equal(sem_destroy(&thaw), 0);
}

static void threads_take_the_callers_priority(void **state) {
  (void)state;
  struct sched_param priority, before;
  int policy;
  assert_int_equal(pthread_getschedparam(pthread_self(), &policy, &before), 0);
  priority.sched_priority = sched_get_priority_min(SCHED_RR);
  KitThreads *const threads = begin(2, false, NULL);
  Work work = {.stops = 0};
  (void)play_with_help(&work);
  if (pthread_setschedparam(pthread_self(), SCHED_RR, &priority) == 0) {
    kit_threads_end(threads);
    KitThreads *const urgent = begin(2, false, NULL);
    (void)play_with_help(&work);
    kit_threads_end(urgent);
    (void)pthread_setschedparam(pthread_self(), policy, &before);
    return;
  }
  print_message("the system gives no real-time priority\n");
  kit_threads_end(threads);
}

/* ---- a host's threads ----------------------------------------------------------------------- */

static KitThreads *pooled;
static uint32_t asked;

static void *play_part(void *context) {
  kit_threads_part(pooled, *(const uint32_t *)context);
  return NULL;
}

static bool run_parts(void *context, uint32_t parts) {
  static uint32_t number[TABOR_KIT_DRUMS];
  pthread_t thread[TABOR_KIT_DRUMS];
  (void)context;
  asked++;
  for (uint32_t i = 0; i < parts; i++) {
    number[i] = i;
    assert_int_equal(pthread_create(&thread[i], NULL, play_part, &number[i]), 0);
  }
  for (uint32_t i = 0; i < parts; i++) (void)pthread_join(thread[i], NULL);
  return true;
}

static bool run_on_this_thread(void *context, uint32_t parts) {
  (void)context;
  asked++;
  while (parts > 0) kit_threads_part(pooled, --parts);
  return true;
}

static bool refuse(void *context, uint32_t parts) {
  (void)context;
  (void)parts;
  asked++;
  return false;
}

static void a_hosts_threads_serve(void **state) {
  (void)state;
  static const KitPool pools[] = {{run_parts, NULL}, {run_on_this_thread, NULL}, {refuse, NULL}};
  for (size_t i = 0; i < sizeof pools / sizeof *pools; i++) {
    for (int is_live = 0; is_live <= 1; is_live++) {
      Work work = {.stops = 0};
      pooled = begin(4, is_live == 1, &pools[i]);
      asked = 0;
      while (asked < 50) {
        play_round(&work, DRUMS);
        if (is_live == 1 && asked > 0 && work.played[0] > asked + ROUNDS) break; /* it gave it up */
      }
      assert_true(asked > 0);
      kit_threads_end(pooled);
    }
  }
}

int main(void) {
  caller = pthread_self();
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(each_drum_is_played_once_a_round),
    cmocka_unit_test(kits_of_other_sizes_come_and_go),
    cmocka_unit_test(who_is_late_is_left_out),
    cmocka_unit_test(who_does_not_wake_is_not_missed),
    cmocka_unit_test(threads_take_the_callers_priority),
    cmocka_unit_test(a_hosts_threads_serve),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
