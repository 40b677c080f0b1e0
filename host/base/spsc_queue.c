/* SPDX-License-Identifier: MIT */
#include "base/spsc_queue.h"

#include <stdlib.h>
#include <string.h>

#define PAGE 4096 /* bytes, or a multiple of it */

/* The system gives memory when it is first written to: not on the audio thread's time. */
static void touch(volatile char *bytes, size_t size) {
  for (size_t i = 0; i < size; i += PAGE) bytes[i] = 0;
}

bool spsc_queue_create(SpscQueue *queue, size_t size, size_t least) {
  size_t capacity = 1;
  while (capacity < least) capacity *= 2;
  queue->messages = calloc(capacity, size);
  queue->size = size;
  queue->capacity = capacity;
  atomic_init(&queue->written, 0);
  atomic_init(&queue->dropped, 0);
  atomic_init(&queue->read, 0);
  if (queue->messages) touch(queue->messages, capacity * size);
  return queue->messages != NULL;
}

void spsc_queue_destroy(SpscQueue *queue) {
  free(queue->messages);
  queue->messages = NULL;
}

/* The counts never wrap in a lifetime; the place of a message is its number modulo the capacity. */
static char *place(const SpscQueue *queue, size_t number) {
  return queue->messages + (number & (queue->capacity - 1)) * queue->size;
}

bool spsc_queue_push(SpscQueue *queue, const void *message) {
  const size_t written = atomic_load_explicit(&queue->written, memory_order_relaxed);
  /* acquire: the consumer has done with the place before it is written again */
  if (written - atomic_load_explicit(&queue->read, memory_order_acquire) == queue->capacity) {
    atomic_fetch_add_explicit(&queue->dropped, 1, memory_order_relaxed);
    return false;
  }
  memcpy(place(queue, written), message, queue->size);
  atomic_store_explicit(&queue->written, written + 1, memory_order_release);
  return true;
}

const void *spsc_queue_peek(const SpscQueue *queue) {
  const size_t read = atomic_load_explicit(&queue->read, memory_order_relaxed);
  if (atomic_load_explicit(&queue->written, memory_order_acquire) == read) return NULL;
  return place(queue, read);
}

void spsc_queue_pop(SpscQueue *queue) {
  const size_t read = atomic_load_explicit(&queue->read, memory_order_relaxed);
  atomic_store_explicit(&queue->read, read + 1, memory_order_release);
}

size_t spsc_queue_count(const SpscQueue *queue) {
  const size_t read = atomic_load_explicit(&queue->read, memory_order_acquire);
  return atomic_load_explicit(&queue->written, memory_order_acquire) - read;
}

unsigned long long spsc_queue_dropped(const SpscQueue *queue) {
  return atomic_load_explicit(&queue->dropped, memory_order_relaxed);
}
