/* SPDX-License-Identifier: MIT */
/**
 * @file kit_threads.h
 * Computes the drums of a kit on several threads, for sound that is not played live: threads without work spin, and yield
 * to others.
 */
#ifndef TABOR_HOST_KIT_THREADS_H
#define TABOR_HOST_KIT_THREADS_H

#include <tabor/kit.h>

typedef struct KitThreads KitThreads;

/** Starts up to @p count - 1 threads beside the caller's for @p kit. NULL if there is none to start; the kit then is computed
 * by the caller alone. */
KitThreads *kit_threads_begin(TaborKit *kit, uint32_t count);
/** Ends the threads, and leaves the kit to the caller. Ignores NULL. */
void kit_threads_end(KitThreads *threads, TaborKit *kit);

#endif
