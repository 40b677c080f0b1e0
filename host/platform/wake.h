/* SPDX-License-Identifier: MIT */
/**
 * @file wake.h
 * A counting semaphore whose wake_post() real-time threads may call.
 */
#ifndef TABOR_HOST_WAKE_H
#define TABOR_HOST_WAKE_H

#include <stdbool.h>

#ifdef __APPLE__
#  include <dispatch/dispatch.h>
typedef dispatch_semaphore_t Wake; /* sem_init() always fails there */

static inline bool wake_create(Wake *wake) {
  *wake = dispatch_semaphore_create(0);
  return *wake != NULL;
}
static inline void wake_destroy(Wake *wake) {
  if (*wake) dispatch_release(*wake);
}
static inline void wake_post(Wake *wake) { (void)dispatch_semaphore_signal(*wake); }
static inline void wake_wait(Wake *wake) {
  (void)dispatch_semaphore_wait(*wake, DISPATCH_TIME_FOREVER);
}
#else
#  include <semaphore.h>
typedef sem_t Wake;

static inline bool wake_create(Wake *wake) { return sem_init(wake, 0, 0) == 0; }
static inline void wake_destroy(Wake *wake) { (void)sem_destroy(wake); }
/** Does not wait. Any thread. */
static inline void wake_post(Wake *wake) { (void)sem_post(wake); }
/** Waits for a post, or less long. */
static inline void wake_wait(Wake *wake) { (void)sem_wait(wake); }
#endif

#endif
