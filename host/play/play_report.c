/* SPDX-License-Identifier: MIT */
#include "play/play_report.h"

#include <math.h>
#include <stdio.h>

#include "base/json_output.h"

typedef unsigned long long Count; /* for printf */

static double decibels(double factor) { return 20 * log10(factor); }

void play_report_gaps(uint64_t gaps, double worst) {
  if (gaps == 0 || !(worst > 1)) return;
  warn(
    "the output ran dry %llu time%s: a block took up to %.0f %% of its time; a larger --buffer or "
    "--quality draft avoids it",
    (Count)gaps, gaps == 1 ? "" : "s", 100 * worst);
}

static void warn_of_losses(const PlayStatus *status, double worst) {
  if (status->clipped > 0) {
    warn("%llu samples were clipped: the peak was %+.1f dBFS; --gain %.1f avoids it",
         (Count)status->clipped, decibels(status->loudest),
         floor(10 * decibels(status->gain / status->loudest)) / 10);
  }
  play_report_gaps(status->xruns, worst);
  if (status->dropped > 0) {
    warn("%llu events were dropped: too many at once, or a press or a move met nothing in play",
         (Count)status->dropped);
  }
  if (status->lost_frames > 0) {
    warn("the recording has %llu frames of silence where the disk was too slow",
         (Count)status->lost_frames);
  }
  if (status->recovered > 0) {
    warn("the drum was reset %llu times because its state was not finite",
         (Count)status->recovered);
  }
}

static json_t *recording_json(const LiveSession *session, const PlayStatus *status) {
  const PlayRequest *const request = session->request;
  if (!request->record.records) return json_null();
  return json_pack("{s:o, s:I}", "file", json_text(request->record.output.name), "lost_frames",
                   (json_int_t)(status->lost_frames + session->unwritten));
}

static void warn_of_lost_messages(const LiveSession *session) {
  const uint64_t lost = player_log_lost(session->player);
  if (lost == 0) return;
  warn("the log lacks %llu messages: too many came at once", (Count)lost);
}

static json_t *log_json(const LiveSession *session) {
  const PlayRequest *const request = session->request;
  if (!request->logs) return json_null();
  return json_pack("{s:o, s:I}", "file", json_text(request->log.name), "lost_messages",
                   (json_int_t)player_log_lost(session->player));
}

/* What a kit has beyond a drum. */
static json_t *with_kit(json_t *report, const LiveSession *session, const PlayStatus *status) {
  const TaborKitDef *const kit = session->request->kit;
  if (!kit) return report;
  json_t *drums = json_array();
  for (uint32_t i = 0; i < kit->drum_count; i++) {
    TaborStatistics statistics;
    tabor_drum_statistics(tabor_kit_drum(session->kit, i), &statistics);
    drums = json_with_item(drums, json_pack("{s:o, s:I}", "name", json_text(kit->drum[i].name),
                                            "strokes", (json_int_t)statistics.strikes));
  }
  json_t *const more =
    json_pack("{s:o, s:o, s:I, s:o}", "kit", json_text(kit->name), "seconds",
              json_number(status->time), "gaps", (json_int_t)status->xruns, "drums", drums);
  (void)json_object_update(report, more);
  json_decref(more);
  return report;
}

static json_t *report_json(const LiveSession *session, const PlayStatus *status) {
  double median, worst;
  player_load(session->player, &median, &worst);
  json_t *const load =
    json_pack("{s:o, s:o}", "median", json_number(median), "worst", json_number(worst));
  json_t *const newton =
    json_pack("{s:o, s:I, s:I}", "mean", json_number(status->newton_mean), "max",
              (json_int_t)status->newton_max, "capped", (json_int_t)status->newton_capped);
  const uint64_t ignored = status->ignored_notes + session->song_ignored;
  json_t *const device =
    json_pack("{s:s, s:o, s:o, s:I, s:o, s:b}", "backend", session->request->backend->name, "name",
              json_text(status->device), "rate", json_number(status->rate), "buffer",
              (json_int_t)status->buffer, "latency", json_number(status->latency), "real_time",
              session->is_urgent);
  return json_pack(
    "{s:o, s:o, s:I, s:I, s:I, s:I, s:I, s:I, s:o, s:I, s:I, s:I, s:o, s:o, s:o, s:o}", "preset",
    json_text(status->preset), "device", device, "frames",
    (json_int_t)player_position(session->player), "channels", (json_int_t)status->channels,
    "strokes", (json_int_t)status->strokes, "late", (json_int_t)status->late, "dropped",
    (json_int_t)status->dropped, "ignored_notes", (json_int_t)ignored, "peak",
    json_number(status->loudest), "clipped", (json_int_t)status->clipped, "xruns",
    (json_int_t)status->xruns, "recovered", (json_int_t)status->recovered, "load", load, "newton",
    newton, "recording", recording_json(session, status), "log", log_json(session));
}

/* How the device was served; of no meaning where sound waits. */
static void describe_load(const LiveSession *session, const PlayStatus *status, char *text,
                          size_t size) {
  double median, worst;
  text[0] = '\0';
  if (session->request->backend->waits) return;
  player_load(session->player, &median, &worst);
  (void)snprintf(text, size, "; load %.0f %%, at most %.0f %%; %llu gap%s", 100 * median,
                 100 * worst, (Count)status->xruns, status->xruns == 1 ? "" : "s");
}

static void note_summary(const LiveSession *session, const PlayStatus *status) {
  const PlayRequest *const request = session->request;
  const bool recorded = request->record.records && session->unwritten == 0;
  if (status->ignored_notes > 0) {
    note("%llu note%s not in the MIDI map and passed over", (Count)status->ignored_notes,
         status->ignored_notes == 1 ? " was" : "s were");
  }
  char load[100];
  describe_load(session, status, load, sizeof load);
  note("%.1f s, %llu stroke%s%s%s%s", status->time, (Count)status->strokes,
       status->strokes == 1 ? "" : "s", load, recorded ? "; recorded in " : "",
       recorded ? request->record.output.name : "");
}

Outcome play_report(LiveSession *session) {
  PlayStatus status;
  double median, worst;
  live_session_status(session, &status);
  player_load(session->player, &median, &worst);
  warn_of_losses(&status, worst);
  warn_of_lost_messages(session);
  if (session->request->json)
    return json_print(with_kit(report_json(session, &status), session, &status));
  if (!session->request->quiet) note_summary(session, &status);
  return OUTCOME_OK;
}
