/* SPDX-License-Identifier: MIT */
#include "host_threads.h"

#include <pthread.h>
#include <semaphore.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

enum { MOST_THREADS = 16 };

struct HostThreads {
  pthread_t thread[MOST_THREADS];
  uint32_t count;
  sem_t begin, end;
  HostTask *task;
  void *context;
  uint32_t tasks;
  atomic_uint next;
  atomic_bool is_over;
  uint64_t runs;
};

static void take_tasks(HostThreads *threads) {
  uint32_t task;
  while ((task = atomic_fetch_add(&threads->next, 1u)) < threads->tasks)
    threads->task(threads->context, task);
}

static void wait_for(sem_t *semaphore) {
  while (sem_wait(semaphore) != 0) continue;
}

static void *work(void *context) {
  HostThreads *const threads = context;
  for (;;) {
    wait_for(&threads->begin);
    if (atomic_load(&threads->is_over)) return NULL;
    take_tasks(threads);
    assert_int_equal(sem_post(&threads->end), 0);
  }
}

static void wake_all(HostThreads *threads) {
  for (uint32_t i = 0; i < threads->count; i++) assert_int_equal(sem_post(&threads->begin), 0);
}

HostThreads *host_threads_begin(uint32_t count) {
  HostThreads *const threads = calloc(1, sizeof *threads);
  assert_non_null(threads);
  assert_true(count <= MOST_THREADS);
  assert_int_equal(sem_init(&threads->begin, 0, 0), 0);
  assert_int_equal(sem_init(&threads->end, 0, 0), 0);
  for (; threads->count < count; threads->count++)
    assert_int_equal(pthread_create(&threads->thread[threads->count], NULL, work, threads), 0);
  return threads;
}

void host_threads_end(HostThreads *threads) {
  atomic_store(&threads->is_over, true);
  wake_all(threads);
  for (uint32_t i = 0; i < threads->count; i++) (void)pthread_join(threads->thread[i], NULL);
  (void)sem_destroy(&threads->begin);
  (void)sem_destroy(&threads->end);
  free(threads);
}

void host_threads_run(HostThreads *threads, HostTask *task, void *context, uint32_t count) {
  threads->runs++;
  threads->task = task;
  threads->context = context;
  threads->tasks = count;
  atomic_store(&threads->next, 0u);
  wake_all(threads);
  take_tasks(threads);
  for (uint32_t i = 0; i < threads->count; i++) wait_for(&threads->end);
}

uint64_t host_threads_runs(const HostThreads *threads) { return threads->runs; }
