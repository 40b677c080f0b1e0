/* SPDX-License-Identifier: MIT */
#include "counted_calls.h"

#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

static _Thread_local volatile bool is_counting;
static _Thread_local volatile long calls;

static void count(void) {
  if (is_counting) calls++;
}

void count_calls_begin(void) {
  calls = 0;
  is_counting = true;
}

long count_calls_end(void) {
  is_counting = false;
  return calls;
}

/* Declares the true function and defines the one that counts. */
#define WRAP(type, name, parameters, arguments)                                                    \
  type __real_##name parameters;                                                                   \
  type __wrap_##name parameters;                                                                   \
  type __wrap_##name parameters {                                                                  \
    count();                                                                                       \
    return __real_##name arguments;                                                                \
  }

WRAP(void *, malloc, (size_t size), (size))
WRAP(void *, calloc, (size_t number, size_t size), (number, size))
WRAP(void *, realloc, (void *memory, size_t size), (memory, size))
WRAP(void *, aligned_alloc, (size_t alignment, size_t size), (alignment, size))
WRAP(int, posix_memalign, (void **memory, size_t alignment, size_t size), (memory, alignment, size))
void __real_free(void *memory);
void __wrap_free(void *memory);
void __wrap_free(void *memory) {
  count();
  __real_free(memory);
}
WRAP(int, pthread_mutex_lock, (pthread_mutex_t * mutex), (mutex))
WRAP(int, pthread_mutex_trylock, (pthread_mutex_t * mutex), (mutex))
WRAP(int, pthread_mutex_unlock, (pthread_mutex_t * mutex), (mutex))
WRAP(int, pthread_cond_wait, (pthread_cond_t * condition, pthread_mutex_t *mutex),
     (condition, mutex))
WRAP(int, pthread_cond_signal, (pthread_cond_t * condition), (condition))
WRAP(int, nanosleep, (const struct timespec *time, struct timespec *left), (time, left))
WRAP(ssize_t, write, (int file, const void *bytes, size_t size), (file, bytes, size))
WRAP(ssize_t, read, (int file, void *bytes, size_t size), (file, bytes, size))
WRAP(FILE *, fopen, (const char *name, const char *mode), (name, mode))
WRAP(size_t, fwrite, (const void *bytes, size_t size, size_t number, FILE *stream),
     (bytes, size, number, stream))
WRAP(int, fputs, (const char *text, FILE *stream), (text, stream))
WRAP(int, puts, (const char *text), (text))

void the_counters_count(void **state) {
  (void)state;
  count_calls_begin();
  (void)count_calls_end();
  void *volatile memory = malloc(10);
  assert_int_equal(calls, 0);
  count_calls_begin();
  free(memory);
  (void)!write(STDOUT_FILENO, "", 0);
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  pthread_mutex_lock(&mutex);
  pthread_mutex_unlock(&mutex);
  assert_int_equal(count_calls_end(), 4);
}
