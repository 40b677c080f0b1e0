/* SPDX-License-Identifier: MIT */
/**
 * @file kit_threads.h
 * Computes the drums of a kit on several threads: those of this file, or those of a plugin's host.
 * The sound is that of one thread, to the bit.
 *
 * A round is one call of the kit: all drums of a piece of some 16 frames. Each thread has its part
 * of them (kit_division.h). When its own part is done, the caller takes those that no thread has
 * begun, so that it does without a thread that does not run. It waits for one that has begun: some
 * tens of microseconds, or as long as the system lets that thread stand. After 2 ms of this the
 * caller of live sound computes alone for 0.2 s, and for up to 10 s where it happens again and
 * again.
 *
 * Threads without work sleep on a semaphore, after they have looked for work for 20 us. They take
 * the priority of the caller; if the system refuses it, the caller computes alone, as it does while
 * one thread is enough.
 */
#ifndef TABOR_HOST_KIT_THREADS_H
#define TABOR_HOST_KIT_THREADS_H

#include <stdbool.h>

#include <tabor/kit.h>

typedef struct KitThreads KitThreads;

/** Threads of a host. */
typedef struct KitPool {
  /** Calls kit_threads_part() with each part < @p parts, on any threads, and returns when all have
   * returned; or calls none, and returns false. Called on the thread that plays the kit. */
  bool (*run)(void *context, uint32_t parts);
  void *context;
} KitPool;

/** Number of threads that plugins and `play` use: that of processors, or the environment's
 * TABOR_THREADS if that is less. */
uint32_t kit_threads_usual(void);
/** Starts up to @p count - 1 threads beside the caller's, or uses those of @p pool, which may be
 * NULL and is copied. @p is_live: sound that must be there in time. NULL if there is none to start:
 * kits are then computed by their callers alone. */
KitThreads *kit_threads_begin(uint32_t count, bool is_live, const KitPool *pool);
/** Lets the threads, which may be NULL, serve @p kit instead of another one; AUDIO. */
void kit_threads_serve(KitThreads *threads, TaborKit *kit);
/** AUDIO, on a thread of a pool: computes a part of the round. */
void kit_threads_part(KitThreads *threads, uint32_t part);
/** Ends the threads. No kit that they serve may play meanwhile or afterwards. Ignores NULL. */
void kit_threads_end(KitThreads *threads);

#endif
