/* SPDX-License-Identifier: MIT */
/**
 * @file history.h
 * What a window can take back, and two settings that it compares. A setting is plain data of one
 * size: a drum with its knobs, or the knobs of a kit. All functions are for the main thread.
 */
#ifndef TABOR_WINDOW_HISTORY_H
#define TABOR_WINDOW_HISTORY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct History {
  size_t size; /**< bytes of a setting */
  void *context;
  void (*note)(void *context, void *setting);      /**< writes the setting that plays */
  void (*use)(void *context, const void *setting); /**< lets another one play */
  unsigned char *settings;   /**< those to take back, the newest last; two more */
  uint32_t count;            /**< to take back */
  bool has_other, is_second; /**< the second of two compared settings plays */
} History;

/** Takes size, context, note and use from @p history. False if memory is short. */
bool history_begin(History *history);
void history_end(History *history);
/** Notes the setting that plays, to be taken back; the oldest is forgotten. */
void history_keep(History *history);
/** Takes the last one back, if there is one. */
void history_undo(History *history);
/** The other of two settings plays; at first both are the same. */
void history_compare(History *history);

#endif
