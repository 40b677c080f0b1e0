/* SPDX-License-Identifier: MIT */
#include "window/history.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
  OTHER = HISTORY_MOST,
  SPARE,
  ALL
}; /* the other of two settings, and one for exchanges, follow */

static void *setting(const History *history, uint32_t number) {
  return history->settings + number * history->size;
}

static void note(const History *history, uint32_t number) {
  history->drop(setting(history, number));
  memset(setting(history, number), 0, history->size);
  history->note(history->context, setting(history, number));
}

bool history_begin(History *history) {
  history->settings = calloc(ALL, history->size);
  return history->settings != NULL;
}

void history_end(History *history) {
  for (uint32_t i = 0; history->settings && i < ALL; i++) history->drop(setting(history, i));
  free(history->settings);
}

static void forget_oldest(History *history) {
  history->drop(setting(history, 0));
  history->count--;
  memmove(setting(history, 0), setting(history, 1), history->count * history->size);
  memmove(history->names[0], history->names[1], history->count * sizeof *history->names);
  memset(setting(history, history->count), 0, history->size);
}

void history_keep(History *history, const char *name) {
  if (history->count == HISTORY_MOST) forget_oldest(history);
  (void)snprintf(history->names[history->count], HISTORY_NAME, "%s", name);
  note(history, history->count++);
  history->undone = 0;
}

void history_drop(History *history) {
  if (history->count > 0) history->count--;
}

/* What plays takes the place of the setting that plays from now on. */
static void exchange(const History *history, uint32_t number) {
  note(history, SPARE);
  if (number != OTHER || history->has_other)
    history->use(history->context, setting(history, number));
  history->drop(setting(history, number));
  memcpy(setting(history, number), setting(history, SPARE), history->size);
  memset(setting(history, SPARE), 0, history->size);
}

void history_undo(History *history) {
  if (history->count == 0) return;
  exchange(history, --history->count);
  history->undone++;
}

void history_redo(History *history) {
  if (history->undone == 0) return;
  exchange(history, history->count++);
  history->undone--;
}

const char *history_undo_name(const History *history) {
  return history->count > 0 ? history->names[history->count - 1] : NULL;
}

const char *history_redo_name(const History *history) {
  return history->undone > 0 ? history->names[history->count] : NULL;
}

void history_compare(History *history) {
  exchange(history, OTHER);
  history->has_other = true;
  history->is_second = !history->is_second;
}
