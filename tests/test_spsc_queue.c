/* SPDX-License-Identifier: MIT */
/* The queue between two threads: order, fullness, and nothing torn or lost between them. */
#include <pthread.h>
#include <sched.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/spsc_queue.h"

typedef struct Numbers {
  uint64_t number, twice, more[6];
} Numbers;

static Numbers numbers(uint64_t number) {
  return (Numbers){number, 2 * number, {number, number, number, number, number, number}};
}

static void it_keeps_order_and_counts_what_found_no_room(void **state) {
  (void)state;
  Ring ring;
  assert_true(ring_create(&ring, sizeof(Numbers), 5)); /* becomes 8 */
  assert_null(ring_peek(&ring));
  uint64_t pushed = 0, popped = 0;
  for (int round = 0; round < 20; round++) {
    Numbers message = numbers(pushed);
    while (ring_push(&ring, &message)) message = numbers(++pushed);
    assert_int_equal(ring_count(&ring), 8);
    assert_int_equal(ring_dropped(&ring), round + 1);
    for (int i = 0; i < 1 + round % 8; i++) {
      const Numbers *const oldest = ring_peek(&ring);
      assert_int_equal(oldest->number, popped++);
      assert_int_equal(oldest->twice, 2 * oldest->number);
      ring_pop(&ring);
    }
  }
  ring_destroy(&ring);
}

static void a_ring_of_zeros_is_none(void **state) {
  (void)state;
  Ring ring = {0};
  ring_destroy(&ring);
}

enum { MANY = 300000 };

static void *produce(void *context) {
  for (uint64_t i = 0; i < MANY;) {
    const Numbers message = numbers(i);
    if (ring_push(context, &message)) {
      i++;
    } else {
      (void)sched_yield();
    }
  }
  return NULL;
}

static void two_threads_lose_nothing(void **state) {
  (void)state;
  Ring ring;
  pthread_t producer;
  assert_true(ring_create(&ring, sizeof(Numbers), 64));
  assert_int_equal(pthread_create(&producer, NULL, produce, &ring), 0);
  for (uint64_t i = 0; i < MANY;) {
    const Numbers *const message = ring_peek(&ring);
    if (!message) {
      (void)sched_yield();
      continue;
    }
    assert_int_equal(message->number, i);
    assert_int_equal(message->more[5], i);
    ring_pop(&ring);
    i++;
  }
  assert_int_equal(pthread_join(producer, NULL), 0);
  assert_null(ring_peek(&ring));
  ring_destroy(&ring);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(it_keeps_order_and_counts_what_found_no_room),
    cmocka_unit_test(a_ring_of_zeros_is_none),
    cmocka_unit_test(two_threads_lose_nothing),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
