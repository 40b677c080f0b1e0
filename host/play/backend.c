/* SPDX-License-Identifier: MIT */
#include "play/backend.h"

#include <string.h>

#include "base/suggest.h"

#define DEFAULT_BUFFER 128

static const Backend *const backends[] = {&backend_portaudio, &backend_null, &backend_file, NULL};

static const char *backend_name_at(const void *list, size_t index) {
  const Backend *const backend = ((const Backend *const *)list)[index];
  return backend ? backend->name : NULL;
}

static Outcome find(const char *name, const Backend **backend) {
  char hint[160];
  for (size_t i = 0; backends[i]; i++) {
    *backend = backends[i];
    if (strcmp(backends[i]->name, name) == 0) return OUTCOME_OK;
  }
  suggest_choice(hint, sizeof hint, name, "", backend_name_at, backends);
  return refuse("--backend '%.80s': unknown%s", name, hint);
}

Outcome backend_read(const Arguments *arguments, const Backend **backend, BackendRequest *request) {
  static const NumberField buffer = {"--buffer", 16, 4096, true};
  const char *const name = arguments_value(arguments, "backend");
  double frames = DEFAULT_BUFFER;
  Outcome outcome = arguments_number(arguments, &buffer, &frames);
  if (outcome == OUTCOME_OK) outcome = find(name ? name : "portaudio", backend);
  if (outcome != OUTCOME_OK) return outcome;
  request->device = arguments_value(arguments, "device");
  request->buffer = (uint32_t)frames;
  if (request->device && *backend != &backend_portaudio) {
    return refuse("--device: only --backend portaudio has devices");
  }
  if ((*backend)->waits && arguments_has(arguments, "midi-in")) {
    return refuse("--midi-in: with --backend file nothing is heard live");
  }
  if ((*backend)->waits && !arguments_has(arguments, "record")) {
    return refuse("--backend file needs --record FILE");
  }
  return OUTCOME_OK;
}
