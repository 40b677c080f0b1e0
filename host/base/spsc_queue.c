/* SPDX-License-Identifier: MIT */
#include "base/spsc_queue.h"

#include <stdlib.h>
#include <string.h>

#define PAGE 4096 /* bytes, or a multiple of it */

/* The system gives memory when it is first written to: not on the audio thread's time. */
static void touch(volatile char *bytes, size_t size) {
  for (size_t i = 0; i < size; i += PAGE) bytes[i] = 0;
}

bool ring_create(Ring *ring, size_t size, size_t least) {
  size_t capacity = 1;
  while (capacity < least) capacity *= 2;
  ring->messages = calloc(capacity, size);
  ring->size = size;
  ring->capacity = capacity;
  atomic_init(&ring->written, 0);
  atomic_init(&ring->dropped, 0);
  atomic_init(&ring->read, 0);
  if (ring->messages) touch(ring->messages, capacity * size);
  return ring->messages != NULL;
}

void ring_destroy(Ring *ring) {
  free(ring->messages);
  ring->messages = NULL;
}

/* The counts never wrap in a lifetime; the place of a message is its number modulo the capacity. */
static char *place(const Ring *ring, size_t number) {
  return ring->messages + (number & (ring->capacity - 1)) * ring->size;
}

bool ring_push(Ring *ring, const void *message) {
  const size_t written = atomic_load_explicit(&ring->written, memory_order_relaxed);
  /* acquire: the consumer has done with the place before it is written again */
  if (written - atomic_load_explicit(&ring->read, memory_order_acquire) == ring->capacity) {
    atomic_fetch_add_explicit(&ring->dropped, 1, memory_order_relaxed);
    return false;
  }
  memcpy(place(ring, written), message, ring->size);
  atomic_store_explicit(&ring->written, written + 1, memory_order_release);
  return true;
}

const void *ring_peek(const Ring *ring) {
  const size_t read = atomic_load_explicit(&ring->read, memory_order_relaxed);
  if (atomic_load_explicit(&ring->written, memory_order_acquire) == read) return NULL;
  return place(ring, read);
}

void ring_pop(Ring *ring) {
  const size_t read = atomic_load_explicit(&ring->read, memory_order_relaxed);
  atomic_store_explicit(&ring->read, read + 1, memory_order_release);
}

size_t ring_count(const Ring *ring) {
  const size_t read = atomic_load_explicit(&ring->read, memory_order_acquire);
  return atomic_load_explicit(&ring->written, memory_order_acquire) - read;
}

unsigned long long ring_dropped(const Ring *ring) {
  return atomic_load_explicit(&ring->dropped, memory_order_relaxed);
}
