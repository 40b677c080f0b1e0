/* SPDX-License-Identifier: MIT */
/**
 * @file spsc_queue.h
 * A queue of fixed-size messages from one thread to one other, without locks (C11 atomics).
 *
 * Functions are grouped by the thread that may call them. ring_push(), ring_peek() and ring_pop() are
 * real-time safe: bounded, no allocation, no lock, no system call.
 */
#ifndef TABOR_HOST_RING_H
#define TABOR_HOST_RING_H

#include <stdalign.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/realtime.h"

#define RING_LINE 64 /* bytes of a cache line: the two ends do not share one */

typedef struct Ring {
  char *messages;
  size_t size;     /**< bytes of a message */
  size_t capacity; /**< messages, a power of two */
  alignas(RING_LINE)
    atomic_size_t written;               /**< messages ever pushed; only the producer changes it */
  atomic_ullong dropped;                 /**< messages that found no room */
  alignas(RING_LINE) atomic_size_t read; /**< messages ever popped; only the consumer changes it */
} Ring;

/* SET-UP: while no other thread uses the ring */

/** Room for at least @p least messages of @p size bytes; false without memory. */
bool ring_create(Ring *ring, size_t size, size_t least);
/** A ring of zeros is allowed. */
void ring_destroy(Ring *ring);

/* PRODUCER */

/** Appends a copy of @p message; a full ring stays as it is, counts a dropped message: false. */
bool ring_push(Ring *ring, const void *message) REALTIME;

/* CONSUMER */

/** The oldest message, valid until ring_pop(); NULL if there is none. */
const void *ring_peek(const Ring *ring) REALTIME;
/** Removes the oldest message; there must be one. */
void ring_pop(Ring *ring) REALTIME;

/* ANY */

/** Messages that wait; already another number if the ring is in use. */
size_t ring_count(const Ring *ring);
/** Messages that found no room so far. */
unsigned long long ring_dropped(const Ring *ring);

#endif
