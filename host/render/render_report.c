/* SPDX-License-Identifier: MIT */
#include "render/render_report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/json_output.h"

static double decibels(double factor) { return 20 * log10(factor); }

static double seconds(const OfflinePlayer *player) {
  return player->position / player->request->model.sample_rate;
}

static double real_time_factor(const OfflinePlayer *player) {
  return player->computing / seconds(player);
}

static double newton_mean(const TaborStatistics *statistics) {
  if (statistics->solves == 0) return 0;
  return (double)statistics->newton_iterations / (double)statistics->solves;
}

/* The gain is rounded down to a tenth of a decibel, so that it does avoid the saturation. */
static void warn_of_saturation(const OfflinePlayer *player) {
  const RenderRequest *const request = player->request;
  const double largest = audio_largest(request->audio.encoding);
  if (player->peak <= largest) return;
  const double gain = floor(10 * (request->gain_db - decibels(player->peak / largest))) / 10;
  warn("the peak of %+.1f dBFS saturates; --gain %.1f avoids it", decibels(player->peak), gain);
}

static const double RESIDUAL_HEARD =
  1e-4; /* of the energy put in: less than a thousandth of a decibel */

static void warn_of_drops(const OfflineDrops *drops) {
  if (drops->strokes > 0) {
    warn("%llu strokes were dropped: more than %d strikers at once",
         (unsigned long long)drops->strokes, TABOR_MAX_ACTIVE);
  }
  if (drops->others > 0) {
    warn("%llu events were dropped: a press or a move met no such stick or brush in play, or a "
         "hand found no room on the head",
         (unsigned long long)drops->others);
  }
}

/* Drums that a song changes to may have other shells; a plate, which has none, sounds instead. */
static void warn_of_rims(const RenderRequest *request) {
  unsigned long long strokes = 0;
  if (request->kit || request->song.presets > 0 || request->def.shell.mass > 0.0) return;
  if (request->def.body.kind == TABOR_BODY_PLATE) return;
  for (size_t i = 0; i < request->strokes.count; i++) {
    const TaborEvent *const event = &request->strokes.events[i];
    const bool on_rim =
      event->technique == TABOR_TECHNIQUE_RIM || event->technique == TABOR_TECHNIQUE_CROSS_STICK;
    strokes += event->type == TABOR_EVENT_STRIKE && on_rim;
  }
  if (strokes == 0) return;
  warn(
    "the hoop is silent under %llu stroke%s: the shell of '%s' has no mass (shell.mass), so it is "
    "rigid",
    strokes, strokes == 1 ? "" : "s", request->def.name);
}

static void warn_of_resets(const TaborStatistics *statistics) {
  if (statistics->recovered > 0) {
    warn("the drum was reset %llu times because its state was not finite",
         (unsigned long long)statistics->recovered);
  }
}

/* Contacts too stiff for a quality's iterations lose energy that no term of the ledger stands for.
 */
static void warn_of_residual(const TaborStatistics *statistics, const TaborLedger *ledger) {
  const double given = ledger->injected + fabs(ledger->control);
  if (!(fabs(ledger->residual) > RESIDUAL_HEARD * given)) return;
  warn("%.2g %% of the energy is unaccounted for, %llu contacts being too stiff to be solved; a "
       "better "
       "--quality or softer contacts avoid it",
       100.0 * ledger->residual / given, (unsigned long long)statistics->newton_capped);
}

static json_t *energy_json(const TaborLedger *ledger) {
  const struct {
    const char *name;
    double value;
  } terms[] = {
    {"injected", ledger->injected},       {"control", ledger->control},
    {"stored", ledger->stored},           {"head_loss", ledger->head_loss},
    {"wire_loss", ledger->wire_loss},     {"contact_loss", ledger->contact_loss},
    {"damper_loss", ledger->damper_loss}, {"shell_loss", ledger->shell_loss},
    {"radiated", ledger->radiated},       {"removed", ledger->removed},
    {"residual", ledger->residual},
  };
  json_t *energy = json_object();
  for (size_t i = 0; i < sizeof terms / sizeof terms[0]; i++) {
    energy = json_with_field(energy, terms[i].name, json_number(terms[i].value));
  }
  return energy;
}

/* The name of the file; with --split, which may make several, a list of them. */
static json_t *outputs_json(const RenderRequest *request) {
  if (!request->split) return json_text(request->outputs[0].name);
  json_t *list = json_array();
  for (uint32_t i = 0; i < request->output_count; i++) {
    list = json_with_item(list, json_text(request->outputs[i].name));
  }
  return list;
}

/* What a kit has beyond a drum. */
static json_t *with_kit(json_t *report, const OfflinePlayer *player) {
  const RenderRequest *const request = player->request;
  json_t *drums = json_array(), *unknown = json_array(), *outputs = json_array();
  for (uint32_t i = 0; i < request->kit->drum_count; i++) {
    TaborStatistics own;
    tabor_drum_statistics(tabor_kit_drum(player->kit, i), &own);
    drums = json_with_item(
      drums, json_pack("{s:o, s:I, s:I}", "name", json_text(request->kit->drum[i].name), "strokes",
                       (json_int_t)own.strikes, "dropped", (json_int_t)own.dropped_events));
  }
  for (int note = 0; request->kit_midi && note < MIDI_VALUES; note++) {
    const json_int_t strokes = (json_int_t)request->kit_midi->unknown[note];
    if (strokes == 0) continue;
    unknown = json_with_item(unknown, json_pack("{s:i, s:I}", "note", note, "strokes", strokes));
  }
  for (uint32_t i = 0; i < request->output_count; i++) {
    outputs = json_with_item(outputs, json_text(request->outputs[i].name));
  }
  report = json_with_field(report, "kit", json_text(request->kit->name));
  report = json_with_field(report, "drums", drums);
  report = json_with_field(report, "unknown_notes", unknown);
  return json_with_field(report, "outputs", outputs);
}

static json_t *report_json(const OfflinePlayer *player, const TaborStatistics *statistics,
                           const TaborLedger *ledger) {
  const RenderRequest *const request = player->request;
  json_t *const newton =
    json_pack("{s:o, s:I, s:I}", "mean", json_number(newton_mean(statistics)), "max",
              (json_int_t)statistics->newton_max, "capped", (json_int_t)statistics->newton_capped);
  json_t *const report =
    json_pack("{s:o, s:I, s:I, s:I, s:o, s:o, s:o, s:o, s:o, s:o}", "preset",
              json_text(request->preset), "rate", (json_int_t)request->audio.rate, "frames",
              (json_int_t)player->position, "channels", (json_int_t)request->channels, "peak",
              json_number(player->peak), "real_time_factor", json_number(real_time_factor(player)),
              "newton", newton, "energy", energy_json(ledger), "output", outputs_json(request),
              "trace", request->has_trace ? json_text(request->trace.name) : json_null());
  return request->kit ? with_kit(report, player) : report;
}

static void note_summary(const OfflinePlayer *player) {
  const RenderRequest *const request = player->request;
  const OutputFile *const first = &request->outputs[0];
  const OutputFile *const last = &request->outputs[request->output_count - 1];
  const uint32_t channels = request->kit ? request->audio.channels : request->channels;
  char peak[32] = "silent";
  if (player->peak > 0) {
    (void)snprintf(peak, sizeof peak, "peak %.1f dBFS", decibels(player->peak));
  }
  note("%s%s%s: %s%s, %.2f s, %u Hz, %u channel%s, %s",
       strcmp(first->name, "-") == 0 ? "standard output" : first->name,
       first == last ? "" : " ... ", first == last ? "" : last->name, request->kit ? "kit " : "",
       request->preset, seconds(player), (unsigned)request->audio.rate, (unsigned)channels,
       channels == 1 ? "" : "s", peak);
  if (request->kit) note("took %.2f times as long as it lasts", real_time_factor(player));
}

static void warn_of_silence(const OfflinePlayer *player) {
  const RenderRequest *const request = player->request;
  if (request->normalize && player->peak == 0) {
    warn("the sound is silent; --normalize has nothing to amplify");
  }
  if (player->peak > 0 && player->peak < audio_least(request->audio.encoding)) {
    warn("the peak of %+.1f dBFS is below half a step of the format: the file is silent",
         decibels(player->peak));
  }
}

static void note_model(const OfflinePlayer *player) {
  TaborModelInfo info;
  tabor_model_info(tabor_drum_model(player->drum), &info);
  note("%u modes up to %.0f Hz, %u wire%s with %u contact points", (unsigned)info.mode_count,
       info.two_way_bandwidth, (unsigned)info.wire_count, info.wire_count == 1 ? "" : "s",
       (unsigned)info.contact_points);
}

static void note_details(const OfflinePlayer *player, const TaborStatistics *statistics,
                         const TaborLedger *ledger) {
  if (player->drum) note_model(player);
  note("%.3f of real time; Newton iterations: mean %.2f, most %u, %llu capped",
       real_time_factor(player), newton_mean(statistics), (unsigned)statistics->newton_max,
       (unsigned long long)statistics->newton_capped);
  note("energy in J: injected %.4g, control %.3g, stored %.3g, head %.3g, wires %.3g, contacts "
       "%.3g, dampers "
       "%.3g, shell %.3g, radiated %.3g, removed %.3g, residual %.2g",
       ledger->injected, ledger->control, ledger->stored, ledger->head_loss, ledger->wire_loss,
       ledger->contact_loss, ledger->damper_loss, ledger->shell_loss, ledger->radiated,
       ledger->removed, ledger->residual);
  if (player->request->normalize) note("normalized by %+.2f dB", player->request->gain_db);
}

Outcome render_report(const OfflinePlayer *player, json_t **report) {
  TaborStatistics statistics;
  TaborLedger ledger;
  drum_player_statistics(&player->core, &statistics);
  drum_player_ledger(&player->core, &ledger);
  const OfflineDrops drops = offline_player_drops(player);
  warn_of_saturation(player);
  warn_of_silence(player);
  warn_of_drops(&drops);
  warn_of_rims(player->request);
  warn_of_resets(&statistics);
  warn_of_residual(&statistics, &ledger);
  if (player->request->verbose) note_details(player, &statistics, &ledger);
  if (player->request->json) {
    *report = report_json(player, &statistics, &ledger);
    return *report ? OUTCOME_OK : fail_memory();
  }
  if (!player->request->quiet) note_summary(player);
  return OUTCOME_OK;
}
