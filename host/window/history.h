/* SPDX-License-Identifier: MIT */
/**
 * @file history.h
 * What a window can take back and do again, each with its name, and two settings that it compares.
 * A setting is data of one size, which may lead to memory of its own; one of zeros says nothing.
 * All functions are for the main thread.
 */
#ifndef TABOR_WINDOW_HISTORY_H
#define TABOR_WINDOW_HISTORY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define HISTORY_MOST 16 /**< changes to take back */
#define HISTORY_NAME 64 /**< bytes of a name, with its terminator */

typedef struct History {
  size_t size; /**< bytes of a setting */
  void *context;
  void (*note)(void *context, void *setting); /**< writes the one that plays over one of zeros */
  void (*use)(void *context, const void *setting); /**< lets another one play */
  void (*drop)(void *setting);                     /**< frees what it leads to */
  unsigned char *settings; /**< before each change, of those undone after it; two more */
  char names[HISTORY_MOST][HISTORY_NAME];
  uint32_t count, undone;    /**< to take back, and to do again */
  bool has_other, is_second; /**< the second of two compared settings plays */
} History;

/** Takes size and calls from @p history. False if memory is short. */
bool history_begin(History *history);
void history_end(History *history);
/** Notes the setting that plays before a change called @p name; the oldest change is forgotten, and
 * those that were undone. */
void history_keep(History *history, const char *name);
/** Forgets the newest change, which was not made. */
void history_drop(History *history);
/** Takes the last change back, or does the last undone one again, if there is one. */
void history_undo(History *history);
void history_redo(History *history);
/** Name of the change that history_undo() takes back, and of that which history_redo() does again;
 * NULL: there is none. */
const char *history_undo_name(const History *history);
const char *history_redo_name(const History *history);
/** The other of two settings plays; at first both are the same. */
void history_compare(History *history);

#endif
