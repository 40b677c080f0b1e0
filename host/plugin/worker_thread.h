/* SPDX-License-Identifier: MIT */
/**
 * @file worker_thread.h
 * A thread that builds what an instance needs, for hosts without one. It looks for work every 5 ms:
 * to wake it, the audio thread would have to make a system call. SET-UP: all functions.
 */
#ifndef TABOR_PLUGIN_WORKER_THREAD_H
#define TABOR_PLUGIN_WORKER_THREAD_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>

/** Does what there is to do, if anything, and returns. */
typedef void WorkerThreadFn(void *context);

typedef struct WorkerThread {
  WorkerThreadFn *work;
  void *context;
  pthread_t thread;
  bool runs;
  atomic_bool stops;
} WorkerThread;

/** Starts the thread. False if the system has none. */
bool worker_thread_start(WorkerThread *thread, WorkerThreadFn *work, void *context);
/** Stops the thread, if it runs, and waits for what it does: cancel that before. */
void worker_thread_stop(WorkerThread *thread);

#endif
