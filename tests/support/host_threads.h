/* SPDX-License-Identifier: MIT */
/**
 * @file host_threads.h
 * Threads of a host that plugins may use, as CLAP's extension thread-pool has them. Any failure
 * fails the test.
 */
#ifndef TABOR_TESTS_HOST_THREADS_H
#define TABOR_TESTS_HOST_THREADS_H

#include <stdint.h>

typedef struct HostThreads HostThreads;
typedef void HostTask(void *context, uint32_t task);

/** Starts @p count threads beside the caller's. */
HostThreads *host_threads_begin(uint32_t count);
void host_threads_end(HostThreads *threads);
/** Calls @p task with each number < @p count, on any of the threads and the caller's, and returns
 * when all have returned. */
void host_threads_run(HostThreads *threads, HostTask *task, void *context, uint32_t count);
/** Calls of host_threads_run(). */
uint64_t host_threads_runs(const HostThreads *threads);

#endif
