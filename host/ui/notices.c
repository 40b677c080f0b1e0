/* SPDX-License-Identifier: MIT */
#include "ui/notices.h"

#include <stdio.h>
#include <string.h>

static const char prefix[] = "tabor: "; /* of errors and warnings */

static bool is_wrong(const char *line) { return strncmp(line, prefix, sizeof prefix - 1) == 0; }

/* A MessageSink. */
static void add(void *context, const char *line) {
  Notices *const notices = context;
  (void)pthread_mutex_lock(&notices->lock);
  if (notices->waiting_count < NOTICES_WAITING) {
    (void)snprintf(notices->waiting[notices->waiting_count++], NOTICE_SIZE, "%s", line);
  }
  if (is_wrong(line)) {
    if (notices->kept_count < NOTICES_KEPT) {
      (void)snprintf(notices->kept[notices->kept_count++], NOTICE_SIZE, "%s", line);
    } else {
      notices->lost_count++;
    }
  }
  (void)pthread_mutex_unlock(&notices->lock);
}

void notices_begin(Notices *notices) {
  memset(notices, 0, sizeof *notices);
  (void)pthread_mutex_init(&notices->lock, NULL);
  message_redirect(add, notices);
}

bool notices_take(Notices *notices, char text[NOTICE_SIZE], bool *is_trouble) {
  (void)pthread_mutex_lock(&notices->lock);
  const bool is_there = notices->waiting_count > 0;
  if (is_there) {
    const char *const line = notices->waiting[0];
    *is_trouble = is_wrong(line);
    (void)snprintf(text, NOTICE_SIZE, "%s", *is_trouble ? line + sizeof prefix - 1 : line);
    notices->waiting_count--;
    memmove(notices->waiting[0], notices->waiting[1], notices->waiting_count * NOTICE_SIZE);
  }
  (void)pthread_mutex_unlock(&notices->lock);
  return is_there;
}

void notices_end(Notices *notices) {
  message_redirect(NULL, NULL);
  for (size_t i = 0; i < notices->kept_count; i++) (void)fprintf(stderr, "%s\n", notices->kept[i]);
  if (notices->lost_count > 0) {
    (void)fprintf(stderr, "%sand %zu more such messages\n", prefix, notices->lost_count);
  }
  (void)pthread_mutex_destroy(&notices->lock);
}
