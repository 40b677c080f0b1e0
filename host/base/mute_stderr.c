/* SPDX-License-Identifier: MIT */
#include "base/mute_stderr.h"

#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <unistd.h>

/* Two at once would take each other's silence for the user's terminal. */
static pthread_mutex_t muted = PTHREAD_MUTEX_INITIALIZER;

int mute_stderr_begin(void) {
  (void)pthread_mutex_lock(&muted);
  (void)fflush(stderr);
  const int kept = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (kept >= 0 && nowhere >= 0) (void)dup2(nowhere, STDERR_FILENO);
  if (nowhere >= 0) (void)close(nowhere);
  return kept;
}

void mute_stderr_end(int kept) {
  (void)fflush(stderr);
  if (kept >= 0) {
    (void)dup2(kept, STDERR_FILENO);
    (void)close(kept);
  }
  (void)pthread_mutex_unlock(&muted);
}
