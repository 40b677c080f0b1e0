/* SPDX-License-Identifier: MIT */
/**
 * @file notices.h
 * Collects messages while a screen is drawn. They wait for the screen's message line; errors and
 * warnings are printed again after the screen is closed.
 */
#ifndef TABOR_HOST_NOTICES_H
#define TABOR_HOST_NOTICES_H

#include <pthread.h>

#include "base/message.h"

#define NOTICE_SIZE 512    /**< size of a line with its terminator [bytes] */
#define NOTICES_WAITING 16 /**< most waiting lines; further ones are not shown */
#define NOTICES_KEPT 32    /**< most errors and warnings kept; further ones are counted */

typedef struct Notices {
  pthread_mutex_t lock;
  char waiting[NOTICES_WAITING][NOTICE_SIZE];
  size_t waiting_count;
  char kept[NOTICES_KEPT][NOTICE_SIZE];
  size_t kept_count, lost_count;
} Notices;

/** Starts to collect all messages. */
void notices_begin(Notices *notices);
/** Takes the oldest waiting message; false if there is none. */
bool notices_take(Notices *notices, char text[NOTICE_SIZE], bool *is_trouble);
/** Prints the kept errors and warnings; from now on messages are printed directly. */
void notices_end(Notices *notices);

#endif
