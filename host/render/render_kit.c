/* SPDX-License-Identifier: MIT */
#include "render/render_kit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/json_output.h"
#include "drums/drum_args.h"
#include "files/audio_file.h"
#include "kit/kit_args.h"
#include "kit/kit_build.h"
#include "kit/kit_options.h"
#include "kit/kit_song.h"
#include "kit/kit_threads.h"
#include "platform/clock.h"
#include "render/render_batch.h"
#include "render/render_options.h"
#include "render/render_outputs.h"
#include "strokes/humanize_options.h"

#define DEFAULT_KIT_OUTPUT "kit.wav"
#define LEAST_TIME 0.5   /* [s] after the last event */
#define MOST_TIME 20.0   /* [s] likewise */
#define ENERGY_FALL 1e-9 /* 90 dB, as for a single drum (sound/ring_out.h) */
#define QUIET 1e-5       /* -100 dBFS: of a block, once the drums have died away */

/* A rendering under way. */
typedef struct KitRendering {
  TaborKitDef def;
  KitMidi midi;
  KitSong song;
  KitSamples samples;
  TaborModelOptions model;
  AudioFormat audio;
  double gain, gain_db;
  uint32_t frames, threads; /* frames: length, or 0 */
  bool split, json, quiet;
  TaborKit *kit;
  KitThreads *kit_threads;
  OutputFile outputs[TABOR_KIT_DRUMS];
  char *names[TABOR_KIT_DRUMS]; /* if split */
  AudioFile files[TABOR_KIT_DRUMS];
  uint32_t output_count;
  float sound[TABOR_KIT_DRUMS][2][AUDIO_BLOCK];
  size_t next_event;
  uint32_t position;
  double peak, computing, loudest;
  float block_peak;
  bool sounding;
} KitRendering;

/* ---- the request ----------------------------------------------------------------------------- */

static Outcome check_options(const Arguments *arguments) {
  static const char *const excluded[] = {"strike", "events", "each",      "replay",   "trace",
                                         "stereo", "mic",    "normalize", "midi-map", "input"};
  for (size_t i = 0; i < sizeof excluded / sizeof excluded[0]; i++) {
    if (!arguments_has(arguments, excluded[i])) continue;
    return refuse("--kit and --%s: a kit plays a MIDI file into its own mix", excluded[i]);
  }
  if (arguments->operand) {
    return refuse("--kit and '%.80s': the kit has the drums", arguments->operand);
  }
  if (arguments_has(arguments, "midi-file")) return OUTCOME_OK;
  return refuse("--kit needs --midi-file, the notes to play");
}

static Outcome read_numbers(const Arguments *arguments, KitRendering *r) {
  static const NumberField gain = {"--gain", -120, 120, false};
  static const NumberField duration = {"--duration", 0.01, 3600, false};
  const char *const encoding = arguments_value(arguments, "format");
  double seconds = 0;
  r->split = arguments_has(arguments, "split");
  r->json = arguments_has(arguments, "json");
  r->quiet = arguments_has(arguments, "quiet");
  Outcome outcome = audio_encoding(encoding ? encoding : DEFAULT_ENCODING, &r->audio.encoding);
  if (outcome == OUTCOME_OK) outcome = arguments_number(arguments, &gain, &r->gain_db);
  if (outcome == OUTCOME_OK) outcome = arguments_number(arguments, &duration, &seconds);
  if (outcome == OUTCOME_OK) outcome = render_threads_read(arguments, &r->threads);
  if (outcome == OUTCOME_OK) {
    outcome = model_options_read(arguments, &r->def.drum[0].def, &r->model);
  }
  r->gain = pow(10, r->gain_db / 20);
  r->audio.rate = (uint32_t)r->model.sample_rate;
  r->audio.channels = 2;
  r->frames = (uint32_t)llround(seconds * r->model.sample_rate);
  return outcome;
}

static Outcome read_song(const Arguments *arguments, KitRendering *r) {
  const char *const name = arguments_value(arguments, "midi-file");
  KitMidiSetup setup;
  Humanizer humanizer;
  Outcome outcome = kit_midi_setup_read(arguments, &setup);
  if (outcome == OUTCOME_OK) outcome = humanize_read(arguments, 0, &humanizer);
  if (outcome != OUTCOME_OK) return outcome;
  kit_midi_begin(&r->midi, &r->def, &setup);
  for (int i = 0; i < MIDI_VALUES; i++) r->midi.has_sample[i] = r->samples.notes[i].path != NULL;
  outcome = kit_song_read(name, &r->midi, humanizer, r->model.sample_rate, &r->song);
  const bool ends = r->frames > 0 && r->song.last_frame >= r->frames;
  if (outcome != OUTCOME_OK || !ends) return outcome;
  return refuse("--duration: too short; the last event comes at %.10g s",
                r->song.last_frame / r->model.sample_rate);
}

/* ---- files ----------------------------------------------------------------------------------- */

static Outcome refuse_extension(const char *name) {
  return refuse("-o '%s': the name must end in .wav, .flac or .au, with something before it", name);
}

/* "take-snare.wav" of "take.wav". */
static char *split_name(const char *name, const char *drum) {
  const char *const extension = strrchr(name, '.');
  const size_t size = strlen(name) + strlen(drum) + 2;
  char *const text = malloc(size);
  if (text) (void)snprintf(text, size, "%.*s-%s%s", (int)(extension - name), name, drum, extension);
  return text;
}

static Outcome protect(const Arguments *arguments, const OutputFile *output) {
  static const char *const inputs[] = {"midi-file", "kit"};
  for (size_t i = 0; i < sizeof inputs / sizeof inputs[0]; i++) {
    const char *const name = arguments_value(arguments, inputs[i]);
    if (output_overwrites(output, name)) {
      return refuse("the output would overwrite '%s', which --%s reads", name, inputs[i]);
    }
  }
  return OUTCOME_OK;
}

static Outcome plan_file(const Arguments *arguments, const char *name, KitRendering *r) {
  OutputFile *const output = &r->outputs[r->output_count++];
  const Outcome outcome = output_plan(output, name, arguments_has(arguments, "no-overwrite"));
  return outcome == OUTCOME_OK ? protect(arguments, output) : outcome;
}

static Outcome plan_split(const Arguments *arguments, const char *name, KitRendering *r) {
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; i < r->def.drum_count && outcome == OUTCOME_OK; i++) {
    r->names[i] = split_name(name, r->def.drum[i].name);
    outcome = r->names[i] ? plan_file(arguments, r->names[i], r) : fail_memory();
  }
  return outcome;
}

static Outcome plan_outputs(const Arguments *arguments, KitRendering *r) {
  const char *const given = arguments_value(arguments, "output");
  const char *const name = given ? given : DEFAULT_KIT_OUTPUT;
  const bool streams = strcmp(name, "-") == 0;
  if (!*name) return refuse("-o needs the name of a file");
  if (streams && (r->split || r->json)) {
    return refuse("-o -: standard output takes one sound only, and nothing else");
  }
  if (streams && isatty(STDOUT_FILENO)) {
    return refuse("-o -: standard output is a terminal; send it to a pipe or a file");
  }
  r->audio.container = AUDIO_AU;
  if (!streams && !audio_container(name, &r->audio.container)) return refuse_extension(name);
  Outcome outcome = audio_format_check(&r->audio);
  if (outcome != OUTCOME_OK) return outcome;
  return r->split ? plan_split(arguments, name, r) : plan_file(arguments, name, r);
}

static Outcome open_outputs(KitRendering *r) {
  const uint32_t most = r->song.last_frame + (uint32_t)ceil(MOST_TIME * r->model.sample_rate);
  Outcome outcome = OUTCOME_OK;
  r->audio.most_frames = r->frames > 0 ? r->frames : most;
  for (uint32_t i = 0; i < r->output_count && outcome == OUTCOME_OK; i++) {
    outcome = output_open(&r->outputs[i], r->audio.container != AUDIO_AU);
    if (outcome == OUTCOME_OK) outcome = audio_file_open(&r->files[i], &r->audio, &r->outputs[i]);
  }
  return outcome;
}

static Outcome deliver(KitRendering *r) {
  OutputFile *outputs[TABOR_KIT_DRUMS];
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; i < r->output_count && outcome == OUTCOME_OK; i++) {
    outcome = audio_file_finish(&r->files[i]);
    if (outcome == OUTCOME_OK) outcome = output_complete(&r->outputs[i]);
    outputs[i] = &r->outputs[i];
  }
  return outcome == OUTCOME_OK ? output_deliver(outputs, r->output_count) : outcome;
}

/* ---- sound ----------------------------------------------------------------------------------- */

/* Of the events up to a frame those of drums, which stay together, from `first` on; returns their number. Samples begin. */
static uint32_t take_events(KitRendering *r, size_t first, uint64_t end) {
  uint32_t count = 0;
  for (; r->next_event < r->song.count; r->next_event++) {
    TaborKitEvent event = r->song.events[r->next_event];
    if (event.event.frame >= end) break;
    event.event.frame -= r->position;
    if (event.drum >= KIT_MIDI_SAMPLE) {
      kit_samples_take(&r->samples, event.drum - KIT_MIDI_SAMPLE, &event.event, event.event.frame);
    } else {
      r->song.events[first + count++] = event;
    }
  }
  return count;
}

static void compute(KitRendering *r, uint32_t frames) {
  TaborKitOutputs outputs = {0};
  const size_t first = r->next_event;
  for (uint32_t i = 0; i < r->output_count; i++) {
    float **const pair = r->split ? outputs.drum[i] : outputs.stereo;
    pair[0] = r->sound[i][0];
    pair[1] = r->sound[i][1];
  }
  const uint32_t count = take_events(r, first, (uint64_t)r->position + frames);
  const double start = stopwatch_seconds(CLOCK_MONOTONIC);
  tabor_kit_process(r->kit, r->song.events + first, count, &outputs, frames);
  if (!r->split) kit_samples_add(&r->samples, r->sound[0][0], r->sound[0][1], frames);
  r->computing += stopwatch_seconds(CLOCK_MONOTONIC) - start;
  r->position += frames;
}

static Outcome write_block(KitRendering *r, uint32_t frames) {
  double samples[2 * AUDIO_BLOCK];
  Outcome outcome = OUTCOME_OK;
  r->block_peak = 0;
  for (uint32_t file = 0; file < r->output_count && outcome == OUTCOME_OK; file++) {
    for (uint32_t i = 0; i < 2 * frames; i++) {
      const float sample = r->sound[file][i % 2][i / 2];
      samples[i] = r->gain * (double)sample;
      r->block_peak = fmaxf(r->block_peak, fabsf(sample));
      r->peak = fmax(r->peak, fabs(samples[i]));
    }
    outcome = audio_file_write(&r->files[file], samples, frames);
  }
  return outcome;
}

/* As for a single drum: 90 dB down, but 0.5 s after the last event at least and 20 s at most. */
static bool is_over(KitRendering *r) {
  const double since = ((double)r->position - r->song.last_frame) / r->model.sample_rate;
  double stored = 0;
  if (r->frames > 0) return r->position >= r->frames;
  if (since <= 0) return false;
  for (uint32_t i = 0; i < r->def.drum_count; i++) {
    TaborLedger ledger;
    tabor_drum_ledger(tabor_kit_drum(r->kit, i), &ledger);
    stored += ledger.stored;
  }
  r->loudest = fmax(r->loudest, stored);
  const bool silent = stored <= ENERGY_FALL * r->loudest && (double)r->block_peak < QUIET &&
                      (r->split || kit_samples_are_silent(&r->samples));
  r->sounding = !silent;
  return (since >= LEAST_TIME && silent) || since >= MOST_TIME;
}

static Outcome play(KitRendering *r) {
  Outcome outcome = OUTCOME_OK;
  do {
    const uint32_t left = (uint32_t)r->audio.most_frames - r->position;
    const uint32_t frames = left < AUDIO_BLOCK ? left : AUDIO_BLOCK;
    compute(r, frames);
    outcome = write_block(r, frames);
  } while (outcome == OUTCOME_OK && !is_over(r) && r->position < r->audio.most_frames);
  return outcome;
}

/* ---- the report ------------------------------------------------------------------------------ */

static uint64_t dropped(const KitRendering *r, uint32_t drum) {
  TaborStatistics statistics;
  tabor_drum_statistics(tabor_kit_drum(r->kit, drum), &statistics);
  return statistics.dropped_events;
}

static Outcome print_json(const KitRendering *r) {
  json_t *drums = json_array(), *unknown = json_array(), *outputs = json_array();
  for (uint32_t i = 0; i < r->def.drum_count; i++) {
    drums = json_with_item(
      drums, json_pack("{s:o, s:I, s:I}", "name", json_text(r->def.drum[i].name), "strokes",
                       (json_int_t)r->midi.strokes[i], "dropped", (json_int_t)dropped(r, i)));
  }
  for (int note = 0; note < MIDI_VALUES; note++) {
    if (r->midi.unknown[note] == 0) continue;
    unknown = json_with_item(
      unknown, json_pack("{s:i, s:I}", "note", note, "strokes", (json_int_t)r->midi.unknown[note]));
  }
  for (uint32_t i = 0; i < r->output_count; i++) {
    outputs = json_with_item(outputs, json_text(r->outputs[i].name));
  }
  return json_print(json_pack(
    "{s:o, s:I, s:I, s:o, s:o, s:o, s:o, s:o}", "kit", json_text(r->def.name), "rate",
    (json_int_t)r->audio.rate, "frames", (json_int_t)r->position, "peak", json_number(r->peak),
    "real_time_factor", json_number(r->computing * r->audio.rate / r->position), "drums", drums,
    "unknown_notes", unknown, "outputs", outputs));
}

static Outcome report(const KitRendering *r) {
  const double largest = audio_largest(r->audio.encoding);
  uint64_t lost = tabor_kit_dropped(r->kit);
  for (uint32_t i = 0; i < r->def.drum_count; i++) lost += dropped(r, i);
  if (r->peak > largest) {
    warn("the peak of %+.1f dBFS saturates; --gain %.1f avoids it", 20 * log10(r->peak),
         floor(10 * (r->gain_db - 20 * log10(r->peak / largest))) / 10);
  }
  if (lost > 0) warn("%llu events were dropped", (unsigned long long)lost);
  if (r->json) return print_json(r);
  if (r->quiet) return OUTCOME_OK;
  if (r->sounding && r->frames == 0) {
    note("the kit still sounds where the file ends, %g s after the last event", MOST_TIME);
  }
  note("%s%s%s: kit %s, %.2f s, %u Hz, 2 channels, peak %.1f dBFS",
       strcmp(r->outputs[0].name, "-") == 0 ? "standard output" : r->outputs[0].name,
       r->output_count > 1 ? " ... " : "",
       r->output_count > 1 ? r->outputs[r->output_count - 1].name : "", r->def.name,
       r->position / (double)r->audio.rate, (unsigned)r->audio.rate, 20 * log10(r->peak));
  note("%.2f of real time", r->computing * r->audio.rate / r->position);
  return OUTCOME_OK;
}

/* ---- all of it ------------------------------------------------------------------------------- */

static Outcome render(const Arguments *arguments, KitRendering *r) {
  Outcome outcome = check_options(arguments);
  if (outcome == OUTCOME_OK) outcome = kit_load(arguments, &r->def, &r->samples);
  if (outcome == OUTCOME_OK) outcome = read_numbers(arguments, r);
  if (outcome == OUTCOME_OK) outcome = read_song(arguments, r);
  if (outcome == OUTCOME_OK) outcome = plan_outputs(arguments, r);
  if (outcome == OUTCOME_OK) outcome = kit_samples_load(&r->samples, r->model.sample_rate);
  if (outcome == OUTCOME_OK && !r->quiet) {
    kit_song_note(arguments_value(arguments, "midi-file"), &r->midi);
  }
  if (outcome == OUTCOME_OK) outcome = kit_build(&r->def, &r->model, r->threads, &r->kit);
  if (outcome == OUTCOME_OK) r->kit_threads = kit_threads_begin(r->kit, r->threads);
  if (outcome == OUTCOME_OK) outcome = open_outputs(r);
  if (outcome == OUTCOME_OK) outcome = play(r);
  if (outcome == OUTCOME_OK) outcome = deliver(r);
  return outcome == OUTCOME_OK ? report(r) : outcome;
}

static void free_all(KitRendering *r) {
  kit_threads_end(r->kit_threads, r->kit);
  tabor_kit_destroy(r->kit);
  kit_song_free(&r->song);
  kit_samples_free(&r->samples);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    audio_file_free(&r->files[i]);
    output_discard(&r->outputs[i]);
    free(r->names[i]);
  }
  free(r);
}

Outcome render_kit(const Arguments *arguments) {
  KitRendering *const r = calloc(1, sizeof *r);
  if (!r) return fail_memory();
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) r->outputs[i] = OUTPUT_FILE_NONE;
  const Outcome outcome = render(arguments, r);
  free_all(r);
  return outcome;
}
