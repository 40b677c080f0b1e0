/* SPDX-License-Identifier: MIT */
#include "render/render_kit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/json_output.h"
#include "drums/drum_args.h"
#include "kit/kit_args.h"
#include "kit/kit_build.h"
#include "kit/kit_options.h"
#include "kit/kit_song_input.h"
#include "kit/kit_threads.h"
#include "render/kit_take.h"
#include "render/render_batch.h"
#include "render/render_options.h"
#include "render/render_outputs.h"
#include "strokes/humanize_options.h"

#define DEFAULT_KIT_OUTPUT "kit.wav"

/* A rendering under way. */
typedef struct KitRendering {
  TaborKitDef def;
  KitMidi midi;
  KitSamples samples;
  TaborModelOptions model;
  uint32_t threads;
  bool json, quiet;
  KitThreads *kit_threads;
  char *names[TABOR_KIT_DRUMS]; /* if split */
  KitTake take;
} KitRendering;

/* ---- the request ----------------------------------------------------------------------------- */

static Outcome check_options(const Arguments *arguments) {
  static const char *const excluded[] = {"strike", "events", "each",      "replay",   "trace",
                                         "stereo", "mic",    "normalize", "midi-map", "input"};
  const Outcome outcome =
    kit_refuse_options(arguments, excluded, sizeof excluded / sizeof *excluded,
                       "not together; a kit plays a MIDI file into its own mix");
  if (outcome != OUTCOME_OK) return outcome;
  if (arguments_has(arguments, "midi-file")) return OUTCOME_OK;
  return refuse("--kit needs --midi-file, the notes to play");
}

static Outcome read_numbers(const Arguments *arguments, KitRendering *r) {
  r->take.split = arguments_has(arguments, "split");
  r->json = arguments_has(arguments, "json");
  r->quiet = arguments_has(arguments, "quiet");
  const Outcome outcome = kit_format_read(arguments, &r->def, &r->model, &r->take.format);
  return outcome == OUTCOME_OK ? render_threads_read(arguments, &r->threads) : outcome;
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
  outcome = kit_song_read(arguments, &r->midi, humanizer, r->model.sample_rate, &r->take.song);
  const bool ends = r->take.format.frames > 0 && r->take.song.last_frame >= r->take.format.frames;
  if (outcome == OUTCOME_OK && ends && !r->quiet) {
    note("'%s' goes on until %.10g s; the sound stops at --duration", name,
         r->take.song.last_frame / r->model.sample_rate);
  }
  return outcome;
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
  OutputFile *const output = &r->take.outputs[r->take.output_count++];
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
  if (streams && (r->take.split || r->json)) {
    return refuse("-o -: standard output takes one sound only, and nothing else");
  }
  if (streams && isatty(STDOUT_FILENO)) {
    return refuse("-o -: standard output is a terminal; send it to a pipe or a file");
  }
  r->take.format.audio.container = AUDIO_AU;
  if (!streams && !audio_container(name, &r->take.format.audio.container))
    return refuse_extension(name);
  Outcome outcome = audio_format_check(&r->take.format.audio);
  if (outcome != OUTCOME_OK) return outcome;
  return r->take.split ? plan_split(arguments, name, r) : plan_file(arguments, name, r);
}

/* ---- the report ------------------------------------------------------------------------------ */

static double real_time_factor(const KitTake *take) {
  return take->computing * take->format.audio.rate / take->position;
}

static Outcome print_json(const KitRendering *r) {
  json_t *drums = json_array(), *unknown = json_array(), *outputs = json_array();
  for (uint32_t i = 0; i < r->def.drum_count; i++) {
    const TaborStatistics statistics = kit_take_statistics(&r->take, i);
    drums =
      json_with_item(drums, json_pack("{s:o, s:I, s:I}", "name", json_text(r->def.drum[i].name),
                                      "strokes", (json_int_t)statistics.strikes, "dropped",
                                      (json_int_t)statistics.dropped_events));
  }
  for (int note = 0; note < MIDI_VALUES; note++) {
    if (r->midi.unknown[note] == 0) continue;
    unknown = json_with_item(
      unknown, json_pack("{s:i, s:I}", "note", note, "strokes", (json_int_t)r->midi.unknown[note]));
  }
  for (uint32_t i = 0; i < r->take.output_count; i++) {
    outputs = json_with_item(outputs, json_text(r->take.outputs[i].name));
  }
  return json_print(json_pack(
    "{s:o, s:I, s:I, s:o, s:o, s:o, s:o, s:o}", "kit", json_text(r->def.name), "rate",
    (json_int_t)r->take.format.audio.rate, "frames", (json_int_t)r->take.position, "peak",
    json_number(r->take.peak), "real_time_factor", json_number(real_time_factor(&r->take)), "drums",
    drums, "unknown_notes", unknown, "outputs", outputs));
}

static Outcome report(const KitRendering *r) {
  const KitTake *const take = &r->take;
  const OutputFile *const outputs = take->outputs;
  kit_take_warn(take);
  if (r->json) return print_json(r);
  if (r->quiet) return OUTCOME_OK;
  if (take->sounding && take->format.frames == 0) {
    note("the kit still sounds where the file ends, %g s after the last event", KIT_TAKE_MOST_TIME);
  }
  note("%s%s%s: kit %s, %.2f s, %u Hz, 2 channels, peak %.1f dBFS",
       strcmp(outputs[0].name, "-") == 0 ? "standard output" : outputs[0].name,
       take->output_count > 1 ? " ... " : "",
       take->output_count > 1 ? outputs[take->output_count - 1].name : "", r->def.name,
       take->position / (double)take->format.audio.rate, (unsigned)take->format.audio.rate,
       20 * log10(take->peak));
  note("computed in %.2f of real time", real_time_factor(take));
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
  if (outcome == OUTCOME_OK) outcome = kit_build(&r->def, &r->model, r->threads, &r->take.kit);
  if (outcome == OUTCOME_OK) r->kit_threads = kit_threads_begin(r->take.kit, r->threads);
  if (outcome == OUTCOME_OK) outcome = kit_take_write(&r->take, NULL, NULL);
  return outcome == OUTCOME_OK ? report(r) : outcome;
}

static void free_all(KitRendering *r) {
  kit_threads_end(r->kit_threads, r->take.kit);
  kit_take_free(&r->take);
  kit_samples_free(&r->samples);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) free(r->names[i]);
  free(r);
}

Outcome render_kit(const Arguments *arguments) {
  KitRendering *const r = calloc(1, sizeof *r);
  if (!r) return fail_memory();
  kit_take_begin(&r->take);
  r->take.samples = &r->samples;
  const Outcome outcome = render(arguments, r);
  free_all(r);
  return outcome;
}
