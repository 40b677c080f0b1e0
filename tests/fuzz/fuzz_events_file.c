/* SPDX-License-Identifier: MIT */
/* Events files (strokes/events_file.h): refused with one line, or events in order with finite
 * numbers. */
#include <math.h>

#include "fuzz.h"
#include "strokes/events_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static TaborDrumDef def;
  if (def.struct_size == 0) {
    fuzz_require(tabor_drum_def_preset(&def, "snare-14x5.5", NULL) == TABOR_OK, "a preset");
  }
  char message[1000] = "";
  Strokes strokes = {.rate = 48000.0};
  const MessageCapture before = message_capture(message, sizeof message);
  const StrokeTarget target = {.def = &def};
  const Outcome outcome = events_file_read(fuzz_file(data, size), &target, &strokes);
  if (outcome == OUTCOME_OK) strokes_sort(&strokes);
  message_release(before);
  fuzz_require(outcome == OUTCOME_OK || message[0] != '\0', "a refusal has a reason");
  for (size_t i = 0; outcome == OUTCOME_OK && i < strokes.count; i++) {
    const TaborEvent *const event = &strokes.events[i];
    fuzz_require(i == 0 || event->frame >= strokes.events[i - 1].frame, "events are in order");
    fuzz_require(isfinite(event->velocity) && isfinite(event->radius) && isfinite(event->angle) &&
                   isfinite(event->value),
                 "events are finite");
  }
  strokes_free(&strokes);
  return 0;
}
