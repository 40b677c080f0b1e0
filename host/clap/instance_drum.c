/* SPDX-License-Identifier: MIT */
#include "clap/instance_drum.h"

#include <math.h>
#include <stdio.h>

void instance_say(Instance *instance, const char *line) {
  char text[2 * TABOR_TEXT_SIZE + 16];
  (void)snprintf(text, sizeof text, "Tabor: %s", line);
  if (instance->log) instance->log->log(instance->host, CLAP_LOG_ERROR, text);
}

void instance_restore(Instance *instance, const SavedState *saved) {
  instance->saved = *saved;
  instance->is_saved = true;
  atomic_store(&instance->room_decay, (float)saved->def.room.decay);
  if (!instance->is_open) return;
  model_worker_restore(&instance->worker, saved);
  instance->host->request_process(instance->host); /* a block has to ask for the model */
}

/* A knob whose value is unknown there has not been turned since. */
void instance_save(Instance *instance, SavedState *saved) {
  *saved = instance->saved;
  if (instance->is_open) model_worker_save(&instance->worker, saved);
  for (uint32_t i = 0; i < KNOB_SEEN; i++) {
    if (isnan(saved->seen[i])) saved->seen[i] = atomic_load(&instance->values[i]);
  }
}
