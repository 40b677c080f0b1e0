/* SPDX-License-Identifier: MIT */
#include "render_request.h"

#include <math.h>
#include <string.h>

#include "drum_source.h"
#include "number.h"
#include "suggest.h"

#define DEFAULT_OUTPUT "strike.wav"
#define DEFAULT_ENCODING "pcm24"

const Option render_options[] = {
  {"output", 'o', "FILE",
   "sound file: .wav, .flac or .au; '-' streams AU (default " DEFAULT_OUTPUT ")"},
  {"no-overwrite", 'n', NULL, "fail if the output exists"},
  {"format", 0, "FORMAT", "pcm16, pcm24 or float (default " DEFAULT_ENCODING ")"},
  OPTION_RATE,
  OPTION_QUALITY,
  {"duration", 0, "SECONDS", "length, 0.01 to 3600 (default: until the drum has died away)"},
  OPTION_STRIKE,
  OPTION_SET,
  {"mic", 0, "NAME", "microphone, a channel each (repeatable; default: the preset's first)"},
  {"gain", 0, "DB", "amplification, -120 to 120 (default 0)"},
  {"trace", 0, "FILE", "also write displacements, forces and energy, a row a sample, as CSV"},
  {0},
};

static Outcome read_gain(const Arguments *arguments, RenderRequest *request) {
  static const NumberField field = {"--gain", -120, 120, false};
  const char *const text = arguments_value(arguments, "gain");
  const Outcome outcome = text ? number_read(&field, text, &request->gain_db) : OUTCOME_OK;
  request->gain = pow(10, request->gain_db / 20);
  return outcome;
}

static Outcome read_duration(const Arguments *arguments, RenderRequest *request) {
  static const NumberField field = {"--duration", 0.01, 3600, false};
  const char *const text = arguments_value(arguments, "duration");
  if (!text) return OUTCOME_OK;
  double duration = 0;
  const Outcome outcome = number_read(&field, text, &duration);
  if (outcome != OUTCOME_OK) return outcome;
  request->frames = (uint32_t)llround(duration * request->model.sample_rate);
  const uint32_t last = strokes_last_frame(&request->strokes);
  if (last < request->frames) return OUTCOME_OK;
  return refuse("--duration '%.80s': too short; the last stroke comes at %.10g s", text,
                last / request->model.sample_rate);
}

static const char *mic_name_at(const void *def, size_t index) {
  const TaborDrumDef *const drum = def;
  return index < drum->mic_count ? drum->mic[index].name : NULL;
}

static Outcome add_mic(RenderRequest *request, const char *name) {
  const int mic = tabor_drum_def_find_mic(&request->def, name);
  char hint[96];
  suggest_hint(hint, sizeof hint, name, "", mic_name_at, &request->def);
  if (mic < 0) return refuse("--mic '%.80s': the drum has no such microphone%s", name, hint);
  if (request->audio.channels == MOST_CHANNELS) {
    return refuse("--mic: too many; allowed: up to %d", MOST_CHANNELS);
  }
  request->mics[request->audio.channels++] = (uint32_t)mic;
  return OUTCOME_OK;
}

static Outcome read_mics(const Arguments *arguments, RenderRequest *request) {
  const char *name;
  size_t position = 0;
  while ((name = arguments_next(arguments, "mic", &position)) != NULL) {
    const Outcome outcome = add_mic(request, name);
    if (outcome != OUTCOME_OK) return outcome;
  }
  if (request->audio.channels > 0) return OUTCOME_OK;
  if (request->def.mic_count == 0) return refuse("the drum has no microphone");
  request->audio.channels = 1; /* mics[0] is 0, the first */
  return OUTCOME_OK;
}

/* The extension decides; what is no regular file, as /dev/full, may do without and gets AU. */
static Outcome choose_container(RenderRequest *request) {
  const OutputFile *const output = &request->output;
  if (audio_container(output->name, &request->audio.container)) return OUTCOME_OK;
  request->audio.container = AUDIO_AU;
  if (output->kind != OUTPUT_REPLACED) return OUTCOME_OK;
  return refuse("-o '%s': the name must end in .wav, .flac or .au", output->name);
}

static Outcome plan_output(const Arguments *arguments, RenderRequest *request) {
  const char *const name = arguments_value(arguments, "output");
  if (name && !*name) return refuse("-o needs the name of a file");
  Outcome outcome = output_plan(&request->output, name ? name : DEFAULT_OUTPUT,
                                arguments_has(arguments, "no-overwrite"));
  if (outcome == OUTCOME_OK) outcome = choose_container(request);
  if (outcome != OUTCOME_OK) return outcome;
  if (request->json && strcmp(request->output.name, "-") == 0) {
    return refuse("--json and -o -: both would go to standard output");
  }
  return OUTCOME_OK;
}

static Outcome plan_trace(const Arguments *arguments, RenderRequest *request) {
  const char *const name = arguments_value(arguments, "trace");
  if (!name) return OUTCOME_OK;
  if (!*name || strcmp(name, "-") == 0) return refuse("--trace needs the name of a file");
  request->has_trace = true;
  const Outcome outcome =
    output_plan(&request->trace, name, arguments_has(arguments, "no-overwrite"));
  if (outcome != OUTCOME_OK) return outcome;
  if (output_same(&request->output, &request->trace)) {
    return refuse("-o and --trace: both name the file '%s'", name);
  }
  return OUTCOME_OK;
}

static Outcome protect_preset(const RenderRequest *request) {
  const char *const preset = request->preset;
  if (!preset_is_file(preset)) return OUTCOME_OK;
  if (output_overwrites(&request->output, preset) ||
      (request->has_trace && output_overwrites(&request->trace, preset))) {
    return refuse("the output would overwrite the preset '%s'", preset);
  }
  return OUTCOME_OK;
}

static Outcome read_encoding(const Arguments *arguments, RenderRequest *request) {
  const char *const name = arguments_value(arguments, "format");
  return audio_encoding(name ? name : DEFAULT_ENCODING, &request->audio.encoding);
}

static Outcome read_drum(const Arguments *arguments, RenderRequest *request) {
  request->preset = preset_argument(arguments);
  request->json = arguments_has(arguments, "json");
  request->quiet = arguments_has(arguments, "quiet");
  request->verbose = arguments_has(arguments, "verbose") && !request->quiet;
  return drum_load(arguments, &request->def);
}

static Outcome read_model(const Arguments *arguments, RenderRequest *request) {
  const Outcome outcome = model_options_read(arguments, &request->model);
  request->audio.rate = (uint32_t)request->model.sample_rate;
  return outcome;
}

static Outcome read_strokes(const Arguments *arguments, RenderRequest *request) {
  return strokes_read(arguments, &request->def, request->model.sample_rate, &request->strokes);
}

static Outcome check_format(const Arguments *arguments, RenderRequest *request) {
  (void)arguments;
  return audio_format_check(&request->audio);
}

static Outcome check_preset(const Arguments *arguments, RenderRequest *request) {
  (void)arguments;
  return protect_preset(request);
}

Outcome render_request_read(const Arguments *arguments, RenderRequest *request) {
  /* each step relies on those before; files come last, so that a wrong request touches none */
  static Outcome (*const steps[])(const Arguments *, RenderRequest *) = {
    read_encoding, read_gain,   read_drum,    read_model, read_strokes, read_duration,
    read_mics,     plan_output, check_format, plan_trace, check_preset,
  };
  memset(request, 0, sizeof *request);
  request->output = request->trace = OUTPUT_FILE_NONE;
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; outcome == OUTCOME_OK && i < sizeof steps / sizeof steps[0]; i++) {
    outcome = steps[i](arguments, request);
  }
  return outcome;
}

void render_request_free(RenderRequest *request) {
  output_discard(&request->output);
  output_discard(&request->trace);
  strokes_free(&request->strokes);
}
