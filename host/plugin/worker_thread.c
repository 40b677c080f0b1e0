/* SPDX-License-Identifier: MIT */
#include "plugin/worker_thread.h"

#include <time.h>

#define GLANCE 5000000 /* [ns] between two looks */

static void *look_for_work(void *context) {
  const struct timespec glance = {.tv_nsec = GLANCE};
  WorkerThread *const thread = context;
  while (!atomic_load(&thread->stops)) {
    thread->work(thread->context);
    (void)nanosleep(&glance, NULL);
  }
  return NULL;
}

bool worker_thread_start(WorkerThread *thread, WorkerThreadFn *work, void *context) {
  thread->work = work;
  thread->context = context;
  atomic_store(&thread->stops, false);
  thread->runs = pthread_create(&thread->thread, NULL, look_for_work, thread) == 0;
  return thread->runs;
}

void worker_thread_stop(WorkerThread *thread) {
  if (!thread->runs) return;
  atomic_store(&thread->stops, true);
  (void)pthread_join(thread->thread, NULL);
  thread->runs = false;
}
