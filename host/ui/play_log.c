/* SPDX-License-Identifier: MIT */
#include "ui/play_log.h"

#include <stdio.h>
#include <string.h>

#include "base/message.h"
#include "ui/screen.h"

static void tell_strokes(PlayLog *log, const PlayStatus *status, double head_radius) {
  const uint64_t more = status->strokes - log->strokes;
  char text[200], others[40] = "";
  if (more == 0 || status->last_event.type != TABOR_EVENT_STRIKE) return;
  log->strokes = status->strokes;
  screen_event(&status->last_event, head_radius, text, sizeof text);
  if (more > 1)
    (void)snprintf(others, sizeof others, ", the last of %llu", (unsigned long long)more);
  note("%.3f s: %s%s", status->last_time, text, others);
}

static void tell_preset(PlayLog *log, const PlayStatus *status) {
  if (status->building || strcmp(log->preset, status->preset) == 0) return;
  if (log->has_begun) note("%.3f s: preset %s", status->time, status->preset);
  (void)snprintf(log->preset, sizeof log->preset, "%s", status->preset);
}

static void tell_count(uint64_t *told, uint64_t count, const PlayStatus *status, const char *what,
                       const char *why) {
  const uint64_t more = count - *told;
  *told = count;
  if (more == 0) return;
  note("%.3f s: %llu %s%s: %s", status->time, (unsigned long long)more, what, more == 1 ? "" : "s",
       why);
}

static void tell_clipping(PlayLog *log, const PlayStatus *status) {
  double peak = 0;
  for (uint32_t i = 0; i < status->channels; i++) {
    if (status->peak[i] > peak) peak = status->peak[i];
  }
  if (peak > 1 && !log->clips) note("%.3f s: the sound clips", status->time);
  log->clips = peak > 1;
}

void play_log_take(PlayLog *log, const PlayStatus *status, double head_radius) {
  tell_strokes(log, status, head_radius);
  tell_preset(log, status);
  tell_count(&log->xruns, status->xruns, status, "gap", "the computer was too slow");
  tell_count(&log->dropped, status->dropped, status, "event",
             "dropped: too many at once, or nothing in play to press or move");
  tell_count(&log->recovered, status->recovered, status, "reset", "the state was not finite");
  tell_count(&log->ignored_notes, status->ignored_notes, status, "note", "not in the MIDI map");
  tell_clipping(log, status);
  log->has_begun = true;
}
