/* SPDX-License-Identifier: MIT */
#include "window/history.h"

#include <stdlib.h>
#include <string.h>

enum {
  MOST = 16,
  OTHER = MOST,
  NOW
}; /* the other of two settings, and the one that plays, follow */

static void *setting(const History *history, uint32_t number) {
  return history->settings + number * history->size;
}

bool history_begin(History *history) {
  history->settings = calloc(NOW + 1, history->size);
  return history->settings != NULL;
}

void history_end(History *history) { free(history->settings); }

void history_keep(History *history) {
  if (history->count == MOST) {
    history->count--;
    memmove(setting(history, 0), setting(history, 1), history->count * history->size);
  }
  history->note(history->context, setting(history, history->count++));
}

void history_undo(History *history) {
  if (history->count > 0) history->use(history->context, setting(history, --history->count));
}

void history_compare(History *history) {
  history->note(history->context, setting(history, NOW));
  if (history->has_other) history->use(history->context, setting(history, OTHER));
  memcpy(setting(history, OTHER), setting(history, NOW), history->size);
  history->has_other = true;
  history->is_second = !history->is_second;
}
