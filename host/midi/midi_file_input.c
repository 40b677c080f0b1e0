/* SPDX-License-Identifier: MIT */
#include "midi/midi_file_input.h"

#include <stdlib.h>

#include "base/input_file.h"
#include "midi/midi_mask.h"

Outcome midi_file_parse(const char *name, const void *bytes, size_t size, bool strict,
                        MidiFile *file) {
  MidiFileReport report;
  switch (midi_file_decode(bytes, size, file, &report)) {
  case MIDI_FILE_OK: break;
  case MIDI_FILE_REFUSED: return refuse("%s: %s", input_name(name), report.error);
  case MIDI_FILE_NO_MEMORY: return fail_memory();
  }
  if (strict && report.warnings > 0) {
    midi_file_free(file);
    return refuse("%s: %s; --strict", input_name(name), report.warning[0]);
  }
  for (uint32_t i = 0; i < report.lines; i++) warn("%s: %s", input_name(name), report.warning[i]);
  return OUTCOME_OK;
}

Outcome midi_file_read(const char *name, bool strict, MidiFile *file) {
  char *bytes = NULL;
  size_t size = 0;
  *file = (MidiFile){0};
  Outcome outcome = input_file_read(name, MIDI_FILE_LIMIT, &bytes, &size);
  if (outcome == OUTCOME_OK) outcome = midi_file_parse(name, bytes, size, strict, file);
  free(bytes);
  return outcome;
}

/* Takes out notes that follow too soon. */
static void mask(MidiFile *file, double time) {
  MidiMask mask = {.time = time};
  size_t kept = 0;
  for (size_t i = 0; i < file->count; i++) {
    const MidiFileEvent event = file->events[i];
    if (midi_mask_passes(&mask, &event.message, event.time)) file->events[kept++] = event;
  }
  file->count = kept;
}

Outcome midi_file_of_arguments(const Arguments *arguments, MidiFile *file) {
  const char *const name = arguments_value(arguments, "midi-file");
  double time = 0;
  *file = (MidiFile){0};
  if (!*name) return refuse("--midi-file needs the name of a file");
  Outcome outcome = midi_mask_read(arguments, &time);
  if (outcome == OUTCOME_OK) {
    outcome = midi_file_read(name, arguments_has(arguments, "strict"), file);
  }
  if (outcome == OUTCOME_OK) mask(file, time);
  return outcome;
}
