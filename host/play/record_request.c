/* SPDX-License-Identifier: MIT */
#include "play/record_request.h"

#include <string.h>

void record_request_begin(RecordRequest *request) {
  *request = (RecordRequest){.output = OUTPUT_FILE_NONE};
}

void record_request_free(RecordRequest *request) { output_discard(&request->output); }

/* A recording whose length nobody knows must be good up to where it breaks off. */
static Outcome check_container(const char *name, RecordRequest *request) {
  const bool known = audio_container(name, &request->audio.container);
  if (known && request->audio.container != AUDIO_FLAC) return OUTCOME_OK;
  if (!known && request->output.kind != OUTPUT_REPLACED) {
    request->audio.container = AUDIO_AU;
    return OUTCOME_OK;
  }
  return refuse("--record '%s': the name must end in .wav or .au, with something before it", name);
}

Outcome record_request_read(const Arguments *arguments, uint32_t channels, RecordRequest *request) {
  const char *const name = arguments_value(arguments, "record");
  const char *const format = arguments_value(arguments, "format");
  Outcome outcome = audio_encoding(format ? format : DEFAULT_ENCODING, &request->audio.encoding);
  request->audio.channels = channels;
  if (!name || outcome != OUTCOME_OK) return outcome;
  if (!*name || strcmp(name, "-") == 0) {
    return refuse("--record '%s': allowed: the name of a file, as take.wav", name);
  }
  request->records = true;
  outcome = output_plan(&request->output, name, arguments_has(arguments, "no-overwrite"));
  return outcome == OUTCOME_OK ? check_container(name, request) : outcome;
}
