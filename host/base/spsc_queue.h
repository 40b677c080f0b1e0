/* SPDX-License-Identifier: MIT */
/**
 * @file spsc_queue.h
 * A lock-free queue of fixed-size messages from one thread to another (C11 atomics).
 *
 * Functions are grouped by the thread that may call them. spsc_queue_push(), spsc_queue_peek() and
 * spsc_queue_pop() are real-time safe: bounded, no allocation, no lock, no system call.
 */
#ifndef TABOR_HOST_SPSC_QUEUE_H
#define TABOR_HOST_SPSC_QUEUE_H

#include <stdalign.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/realtime.h"

#define SPSC_QUEUE_LINE 64 /* cache line [bytes]; the two ends do not share one */

typedef struct SpscQueue {
  char *messages;
  size_t size;     /**< bytes of a message */
  size_t capacity; /**< messages, a power of two */
  alignas(SPSC_QUEUE_LINE)
    atomic_size_t written; /**< messages ever pushed; only the producer changes it */
  atomic_ullong dropped;   /**< messages dropped because the queue was full */
  alignas(SPSC_QUEUE_LINE)
    atomic_size_t read; /**< messages ever popped; only the consumer changes it */
} SpscQueue;

/* SET-UP: call while no other thread uses the queue */

/** Creates a queue for at least @p least messages of @p size bytes; false if memory is short. */
bool spsc_queue_create(SpscQueue *queue, size_t size, size_t least);
/** Frees the queue. A queue of zeros is allowed. */
void spsc_queue_destroy(SpscQueue *queue);

/* PRODUCER */

/** Appends a copy of @p message. If the queue is full, counts a dropped message and returns false.
 */
bool spsc_queue_push(SpscQueue *queue, const void *message) REALTIME;

/* CONSUMER */

/** Returns the oldest message, valid until spsc_queue_pop(); NULL if there is none. */
const void *spsc_queue_peek(const SpscQueue *queue) REALTIME;
/** Removes the oldest message; there must be one. */
void spsc_queue_pop(SpscQueue *queue) REALTIME;

/* ANY */

/** Number of waiting messages; it may be outdated at once if the queue is in use. */
size_t spsc_queue_count(const SpscQueue *queue);
/** Number of messages dropped so far. */
unsigned long long spsc_queue_dropped(const SpscQueue *queue);

#endif
