/* SPDX-License-Identifier: MIT */
/**
 * @file notices.h
 * Messages while a screen is drawn: they wait for their line on it instead of spoiling it, and what was wrong
 * is said again once the screen is gone.
 */
#ifndef TABOR_HOST_NOTICES_H
#define TABOR_HOST_NOTICES_H

#include <pthread.h>

#include "base/message.h"

#define NOTICE_SIZE 512    /**< bytes of a line with its terminator */
#define NOTICES_WAITING 16 /**< further ones are not shown */
#define NOTICES_KEPT 32    /**< of what was wrong; further ones are counted */

typedef struct Notices {
  pthread_mutex_t lock;
  char waiting[NOTICES_WAITING][NOTICE_SIZE];
  size_t waiting_count;
  char kept[NOTICES_KEPT][NOTICE_SIZE];
  size_t kept_count, lost_count;
} Notices;

/** From now on all messages come here. */
void notices_begin(Notices *notices);
/** Takes the oldest that waits; false if there is none. */
bool notices_take(Notices *notices, char text[NOTICE_SIZE], bool *is_trouble);
/** Messages are seen again; errors and warnings of the meantime are now. */
void notices_end(Notices *notices);

#endif
