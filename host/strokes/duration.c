/* SPDX-License-Identifier: MIT */
#include "strokes/duration.h"

#include "base/message.h"

Outcome duration_too_short(const Arguments *arguments, bool is_song, double last, bool quiet) {
  const char *const text = arguments_value(arguments, "duration");
  if (!is_song) {
    return refuse("--duration '%.80s': too short; the last stroke comes at %.10g s", text, last);
  }
  if (!quiet) note("what is played goes on until %.10g s; the sound stops at %s s", last, text);
  return OUTCOME_OK;
}
