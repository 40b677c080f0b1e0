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
  SpscQueue queue;
  assert_true(spsc_queue_create(&queue, sizeof(Numbers), 5)); /* becomes 8 */
  assert_null(spsc_queue_peek(&queue));
  uint64_t pushed = 0, popped = 0;
  for (int round = 0; round < 20; round++) {
    Numbers message = numbers(pushed);
    while (spsc_queue_push(&queue, &message)) message = numbers(++pushed);
    assert_int_equal(spsc_queue_count(&queue), 8);
    assert_int_equal(spsc_queue_dropped(&queue), round + 1);
    for (int i = 0; i < 1 + round % 8; i++) {
      const Numbers *const oldest = spsc_queue_peek(&queue);
      assert_int_equal(oldest->number, popped++);
      assert_int_equal(oldest->twice, 2 * oldest->number);
      spsc_queue_pop(&queue);
    }
  }
  spsc_queue_destroy(&queue);
}

static void a_ring_of_zeros_is_none(void **state) {
  (void)state;
  SpscQueue queue = {0};
  spsc_queue_destroy(&queue);
}

enum { MANY = 300000 };

static void *produce(void *context) {
  for (uint64_t i = 0; i < MANY;) {
    const Numbers message = numbers(i);
    if (spsc_queue_push(context, &message)) {
      i++;
    } else {
      (void)sched_yield();
    }
  }
  return NULL;
}

static void two_threads_lose_nothing(void **state) {
  (void)state;
  SpscQueue queue;
  pthread_t producer;
  assert_true(spsc_queue_create(&queue, sizeof(Numbers), 64));
  assert_int_equal(pthread_create(&producer, NULL, produce, &queue), 0);
  for (uint64_t i = 0; i < MANY;) {
    const Numbers *const message = spsc_queue_peek(&queue);
    if (!message) {
      (void)sched_yield();
      continue;
    }
    assert_int_equal(message->number, i);
    assert_int_equal(message->more[5], i);
    spsc_queue_pop(&queue);
    i++;
  }
  assert_int_equal(pthread_join(producer, NULL), 0);
  assert_null(spsc_queue_peek(&queue));
  spsc_queue_destroy(&queue);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(it_keeps_order_and_counts_what_found_no_room),
    cmocka_unit_test(a_ring_of_zeros_is_none),
    cmocka_unit_test(two_threads_lose_nothing),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
