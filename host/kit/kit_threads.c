/* SPDX-License-Identifier: MIT */
#include "kit/kit_threads.h"

#include <assert.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdlib.h>

enum { SPINS = 200 }; /* looks at the round before a thread yields to others */

/* A round is one call of the kit: all drums of a piece. Whoever is free takes the next drum. */
struct KitThreads {
  pthread_t threads[TABOR_KIT_DRUMS];
  uint32_t count;
  uint32_t drums;   /* of the kit: never changes */
  TaborKitJob *job; /* this and `kit` belong to whoever got a drum of the round */
  void *kit;
  atomic_uint round; /* number of the newest */
  atomic_uint next;  /* drum to begin with */
  atomic_uint left;  /* drums that are not done */
  atomic_bool over;
};

static void take_drums(KitThreads *threads) {
  for (;;) {
    const uint32_t drum = atomic_fetch_add(&threads->next, 1u);
    if (drum >= threads->drums) return;
    threads->job(threads->kit, drum);
    atomic_fetch_sub(&threads->left, 1u);
  }
}

static void relax(unsigned *spins) {
  if (++*spins % SPINS == 0) (void)sched_yield();
}

static void *work(void *context) {
  KitThreads *const threads = context;
  unsigned seen = 0, spins = 0;
  while (!atomic_load(&threads->over)) {
    const unsigned round = atomic_load(&threads->round);
    if (round == seen) {
      relax(&spins);
      continue;
    }
    seen = round;
    take_drums(threads);
  }
  return NULL;
}

/* A TaborKitRun. `next` is set last: a thread that is late from the round before finds no drum until then, and
 * whoever finds one also sees the round's job. */
static void run(void *context, TaborKitJob *job, void *kit, uint32_t count) {
  KitThreads *const threads = context;
  unsigned spins = 0;
  assert(count == threads->drums);
  (void)count;
  threads->job = job;
  threads->kit = kit;
  atomic_store(&threads->left, threads->drums);
  atomic_store(&threads->next, 0u);
  atomic_fetch_add(&threads->round, 1u);
  take_drums(threads);
  while (atomic_load(&threads->left) > 0) relax(&spins);
}

KitThreads *kit_threads_begin(TaborKit *kit, uint32_t count) {
  const uint32_t drums = tabor_kit_definition(kit)->drum_count;
  KitThreads *const threads = calloc(1, sizeof *threads);
  if (!threads) return NULL;
  threads->drums = drums;
  atomic_init(&threads->next, drums);
  const uint32_t most = count < drums ? count : drums;
  while (threads->count + 1 < most &&
         pthread_create(&threads->threads[threads->count], NULL, work, threads) == 0) {
    threads->count++;
  }
  if (threads->count == 0) {
    free(threads);
    return NULL;
  }
  tabor_kit_set_runner(kit, run, threads);
  return threads;
}

void kit_threads_end(KitThreads *threads, TaborKit *kit) {
  if (!threads) return;
  tabor_kit_set_runner(kit, NULL, NULL);
  atomic_store(&threads->over, true);
  for (uint32_t i = 0; i < threads->count; i++) (void)pthread_join(threads->threads[i], NULL);
  free(threads);
}
