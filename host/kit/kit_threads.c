/* SPDX-License-Identifier: MIT */
#include "kit/kit_threads.h"

#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "kit/kit_division.h"
#include "platform/clock.h"
#include "platform/process.h"
#include "platform/wake.h"

/* [s] for which a thread looks before it sleeps. For the groove of docs/kit.md with 5 us two
 * threads take an eighth longer and as much of their processors; with 60 us a twentieth less, and
 * as much more of their processors. */
static const double SPIN = 20e-6;
static const double LATE = 2e-3; /* [s] for which nobody waits who must be in time */
/* [s] for which the caller is alone then; each time twice as long if it happens within RECOVERY
 * again. */
static const double RECOVERY = 0.2, LONGEST_RECOVERY = 10;
static const double TERM = 0.2, TERM_ALONE = 0.05; /* [s] after which drums are divided anew */

/* A thread that waits, and where it sleeps. */
typedef struct Sleeper {
  Wake wake;
  atomic_bool sleeps;
} Sleeper;

typedef struct Helper {
  KitThreads *threads;
  uint32_t part;
  pthread_t thread;
  Sleeper sleeper;
  atomic_uint is_called;
} Helper;

struct KitThreads {
  Helper helpers[TABOR_KIT_DRUMS];
  uint32_t count; /* of the helpers that run; 0 with a pool */
  uint32_t most;  /* parts */
  KitPool pool;   /* or nothing */
  bool is_live;
  TaborKitJob *job; /* this and `kit` belong to whoever got a drum of the round */
  void *kit;
  KitDivision division;
  atomic_uint part[TABOR_KIT_DRUMS]; /* the division's */
  atomic_uint open;                  /* bits of the round's drums that nobody has taken */
  atomic_uint left;                  /* drums that are not done */
  Sleeper sleeper;                   /* the caller */
  atomic_bool is_over;
  double elapsed;     /* [s] of the term's rounds */
  double alone_until; /* [s] */
  double recovery;    /* [s] the newest */
  pthread_t caller;   /* of the round before */
  bool has_caller;
  bool is_equal; /* helpers have this priority */
  int policy;
  struct sched_param priority;
};

static double now(void) { return stopwatch_seconds(CLOCK_MONOTONIC); }

static void relax(void) {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  __asm__ volatile("yield");
#endif
}

/* ---- waiting -------------------------------------------------------------------------------- */

/* Either the sleeper sees what it waits for before it sleeps, or who brings it sees that it sleeps.
 */
static void wait_until(Sleeper *sleeper, const atomic_uint *place, unsigned value) {
  const double until = now() + SPIN;
  while (now() < until) {
    if (atomic_load(place) == value) return;
    relax();
  }
  while (atomic_load(place) != value) {
    atomic_store(&sleeper->sleeps, true);
    const bool is_there = atomic_load(place) == value;
    if (is_there && atomic_exchange(&sleeper->sleeps, false)) return;
    wake_wait(&sleeper->wake);
  }
}

static void wake(Sleeper *sleeper) {
  if (atomic_exchange(&sleeper->sleeps, false)) wake_post(&sleeper->wake);
}

/* ---- a drum of a round ---------------------------------------------------------------------- */

static void compute(KitThreads *threads, uint32_t drum) {
  const double begun = now();
  threads->job(threads->kit, drum);
  threads->division.seconds[drum] += now() - begun;
}

/* Computes those of @p drums that nobody has taken: a part is taken as a whole, since its tables
 * are in one processor's cache. A thread that is late from a round before takes part in the newest:
 * `open` is set last, so who finds a drum in it also sees the round's job. */
static void take(KitThreads *threads, uint32_t drums) {
  const uint32_t taken = atomic_fetch_and(&threads->open, ~drums) & drums;
  for (uint32_t i = 0; taken >> i; i++) {
    if (!(taken >> i & 1u)) continue;
    compute(threads, i);
    if (atomic_fetch_sub(&threads->left, 1u) == 1) wake(&threads->sleeper);
  }
}

void kit_threads_part(KitThreads *threads, uint32_t part) {
  if (part < TABOR_KIT_DRUMS) take(threads, atomic_load(&threads->part[part]));
}

/* ---- the helpers ---------------------------------------------------------------------------- */

static void *help(void *context) {
  Helper *const helper = context;
  for (;;) {
    wait_until(&helper->sleeper, &helper->is_called, 1);
    atomic_store(&helper->is_called, 0);
    if (atomic_load(&helper->threads->is_over)) return NULL;
    kit_threads_part(helper->threads, helper->part);
  }
}

static void call(Helper *helper) {
  atomic_store(&helper->is_called, 1);
  wake(&helper->sleeper);
}

static bool take_priority(const KitThreads *threads, int policy,
                          const struct sched_param *priority) {
  for (uint32_t i = 0; i < threads->count; i++) {
    if (pthread_setschedparam(threads->helpers[i].thread, policy, priority) != 0) return false;
  }
  return true;
}

/* Hosts may play on another thread than before: a helper below its priority could hold it up. */
static void follow_caller(KitThreads *threads) {
  struct sched_param priority;
  int policy;
  const pthread_t self = pthread_self();
  if (threads->has_caller && pthread_equal(self, threads->caller)) return;
  threads->caller = self;
  threads->has_caller = true;
  threads->is_equal = pthread_getschedparam(self, &policy, &priority) == 0;
  if (!threads->is_equal) return;
  if (policy == threads->policy && priority.sched_priority == threads->priority.sched_priority)
    return;
  threads->is_equal = take_priority(threads, policy, &priority);
  threads->policy = threads->is_equal ? policy : -1;
  threads->priority = priority;
}

/* ---- rounds --------------------------------------------------------------------------------- */

static void recover(KitThreads *threads) {
  const double time = now();
  if (!threads->is_live) return;
  const bool is_again = time - threads->alone_until < RECOVERY;
  threads->recovery = is_again ? 2 * threads->recovery : RECOVERY;
  if (threads->recovery > LONGEST_RECOVERY) threads->recovery = LONGEST_RECOVERY;
  threads->alone_until = time + threads->recovery;
}

/* Threads by which rounds take longer than their drums one after another are of no use. */
static void judge(KitThreads *threads) {
  double spent = 0;
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) spent += threads->division.seconds[i];
  if (threads->elapsed > spent) recover(threads);
  threads->elapsed = 0;
}

static void renew(KitThreads *threads, uint32_t drums) {
  KitDivision *const division = &threads->division;
  if (division->drums != drums) kit_division_begin(division, drums, threads->most);
  const double time = now();
  if (time - division->begun < (division->parts > 1 ? TERM : TERM_ALONE)) return;
  judge(threads);
  kit_division_renew(division, time);
  for (uint32_t i = 0; i < division->parts; i++) atomic_store(&threads->part[i], division->part[i]);
}

static bool is_alone(KitThreads *threads) {
  if (threads->division.parts == 1) return true;
  if (threads->alone_until > 0 && now() < threads->alone_until) return true;
  if (threads->pool.run) return false;
  follow_caller(threads);
  return !threads->is_equal;
}

static void wait_for_rest(KitThreads *threads) {
  const double begun = now();
  wait_until(&threads->sleeper, &threads->left, 0);
  if (now() - begun > LATE) recover(threads);
}

static void call_others(KitThreads *threads) {
  const uint32_t parts = threads->division.parts;
  if (threads->pool.run) {
    (void)threads->pool.run(threads->pool.context, parts);
    return;
  }
  for (uint32_t i = 0; i + 1 < parts && i < threads->count; i++) call(&threads->helpers[i]);
}

/* A TaborKitRun. */
static void run(void *context, TaborKitJob *job, void *kit, uint32_t count) {
  KitThreads *const threads = context;
  const uint32_t all = (1u << count) - 1u;
  renew(threads, count);
  threads->job = job;
  threads->kit = kit;
  if (is_alone(threads)) {
    for (uint32_t i = 0; i < count; i++) compute(threads, i);
    return;
  }
  const double begun = now();
  atomic_store(&threads->left, count);
  atomic_store(&threads->open, all);
  call_others(threads);
  kit_threads_part(threads, 0);
  take(threads, all);
  wait_for_rest(threads);
  threads->elapsed += now() - begun;
}

void kit_threads_serve(KitThreads *threads, TaborKit *kit) {
  if (threads) tabor_kit_set_runner(kit, run, threads);
}

/* ---- beginning and end ---------------------------------------------------------------------- */

uint32_t kit_threads_usual(void) {
  const char *const text = getenv("TABOR_THREADS");
  const uint32_t processors = process_processors();
  char *end;
  const unsigned long most = text ? strtoul(text, &end, 10) : processors;
  return text && (end == text || *end != 0 || most > processors) ? processors : (uint32_t)most;
}

static bool start(KitThreads *threads) {
  Helper *const helper = &threads->helpers[threads->count];
  helper->threads = threads;
  helper->part = threads->count + 1;
  if (!wake_create(&helper->sleeper.wake)) return false;
  if (pthread_create(&helper->thread, NULL, help, helper) == 0) {
    threads->count++;
    return true;
  }
  wake_destroy(&helper->sleeper.wake);
  return false;
}

KitThreads *kit_threads_begin(uint32_t count, bool is_live, const KitPool *pool) {
  KitThreads *const threads = count > 1 ? calloc(1, sizeof *threads) : NULL;
  if (!threads) return NULL;
  if (!wake_create(&threads->sleeper.wake)) {
    free(threads);
    return NULL;
  }
  threads->policy = -1;
  threads->is_live = is_live;
  threads->most = count < TABOR_KIT_DRUMS ? count : TABOR_KIT_DRUMS;
  if (pool) {
    threads->pool = *pool;
    return threads;
  }
  while (threads->count + 1 < threads->most && start(threads)) continue;
  threads->most = threads->count + 1;
  if (threads->count > 0) return threads;
  kit_threads_end(threads);
  return NULL;
}

void kit_threads_end(KitThreads *threads) {
  if (!threads) return;
  atomic_store(&threads->is_over, true);
  for (uint32_t i = 0; i < threads->count; i++) {
    call(&threads->helpers[i]);
    (void)pthread_join(threads->helpers[i].thread, NULL);
    wake_destroy(&threads->helpers[i].sleeper.wake);
  }
  wake_destroy(&threads->sleeper.wake);
  free(threads);
}
