/* SPDX-License-Identifier: MIT */
#include "base/mute_stderr.h"

#include <pthread.h>
#include <stdio.h>
#include <unistd.h>

#include "platform/files.h"

/* Two at once would take each other's silence for the user's terminal. */
static pthread_mutex_t muted = PTHREAD_MUTEX_INITIALIZER;

int mute_stderr_begin(void) {
  (void)pthread_mutex_lock(&muted);
  (void)fflush(stderr);
  const int kept = file_duplicate(STDERR_FILENO);
  const int nowhere = file_open_nowhere(true);
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
