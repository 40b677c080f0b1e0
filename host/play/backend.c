/* SPDX-License-Identifier: MIT */
#include "play/backend.h"

#include <string.h>

#include "base/suggest.h"

static const Backend *const backends[] = {&backend_portaudio, &backend_null, &backend_file, NULL};

static const char *backend_name_at(const void *list, size_t index) {
  const Backend *const backend = ((const Backend *const *)list)[index];
  return backend ? backend->name : NULL;
}

Outcome backend_find(const char *name, const Backend **backend) {
  char hint[160];
  for (size_t i = 0; backends[i]; i++) {
    *backend = backends[i];
    if (strcmp(backends[i]->name, name) == 0) return OUTCOME_OK;
  }
  suggest_choice(hint, sizeof hint, name, "", backend_name_at, backends);
  return refuse("--backend '%.80s': unknown%s", name, hint);
}
