/* SPDX-License-Identifier: MIT */
/**
 * @file worker_thread.h
 * A thread that builds an instance's models, for hosts without one. It looks for work every 5 ms: to wake it, the
 * audio thread would have to make a system call. SET-UP: all functions.
 */
#ifndef TABOR_PLUGIN_WORKER_THREAD_H
#define TABOR_PLUGIN_WORKER_THREAD_H

#include "plugin/model_worker.h"

typedef struct WorkerThread {
  ModelWorker *worker;
  pthread_t thread;
  bool runs;
  atomic_bool stops;
} WorkerThread;

/** Starts the thread. False if the system has none. */
bool worker_thread_start(WorkerThread *thread, ModelWorker *worker);
/** Stops the thread, if it runs, and cancels what it builds. */
void worker_thread_stop(WorkerThread *thread);

#endif
