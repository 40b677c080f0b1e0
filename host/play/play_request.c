/* SPDX-License-Identifier: MIT */
#include "play/play_request.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/suggest.h"
#include "drums/drum_args.h"
#include "drums/stereo_pair.h"
#include "kit/kit_args.h"
#include "kit/kit_options.h"
#include "midi/midi_input.h"
#include "midi/midi_mask.h"
#include "midi/midi_options.h"
#include "render/render_options.h"
#include "strokes/humanize_options.h"
#include "strokes/stroke_options.h"

const Option play_options[] = {
  {"backend", 0, "NAME", "portaudio, null or file (default portaudio; null is not heard)"},
  {"device", 0, "NAME", "output as 'tabor devices' lists it (default: the system's)"},
  {"rate", 0, "HZ", "sample rate, 22050 to 192000 (default: the device's, else 48000)"},
  {"buffer", 0, "FRAMES", "frames computed at once, 16 to 4096 (default 128)"},
  {"duration", 0, "SECONDS", "stop after so long, 0.01 to 86400 (default: when told to)"},
  {"record", 0, "FILE", "also write everything to a sound file, .wav or .au"},
  {"format", 0, "FORMAT", "of it: pcm16, pcm24 or float (default " DEFAULT_ENCODING ")"},
  {"log", 0, "FILE", "also write what was played, for 'tabor render --replay FILE'"},
  {"no-overwrite", 'n', NULL, "fail if one of these files exists"},
  OPTION_QUALITY,
  OPTION_SET,
  OPTION_EVENTS,
  OPTION_MIDI_FILE,
  OPTION_STRICT,
  OPTION_MASK_TIME,
  OPTION_KIT,
  OPTION_MIDI_IN,
  OPTION_MAP,
  OPTION_PLACE_CC,
  OPTION_MIDI_MAP,
  OPTION_MIDI_CHANNEL,
  OPTION_VELOCITY_CURVE,
  OPTION_VELOCITY_RANGE,
  OPTION_HUMANIZE(HUMANIZE_LIVE_TEXT),
  OPTION_SEED,
  {"keys", 0, "FILE", "what the keys of the keyboard do; see docs/keyboard.md"},
  {"mic", 0, "NAME",
   "microphone, a channel each (repeatable; default: the preset's first, everywhere)"},
  OPTION_STEREO,
  {"gain", 0, "DB", "amplification, -120 to 120 (default 0)"},
  {"jobs", 'j', "N", "threads that compute a kit, 1 to 256 (default: the number of processors)"},
  {"no-ui", 0, NULL, "no screen: print lines instead"},
  {0},
};

static Outcome read_flags(const Arguments *arguments, PlayRequest *request) {
  request->arguments = arguments;
  request->json = arguments_has(arguments, "json");
  request->quiet = arguments_has(arguments, "quiet");
  request->no_ui = arguments_has(arguments, "no-ui");
  return OUTCOME_OK;
}

static Outcome read_numbers(const Arguments *arguments, PlayRequest *request) {
  static const NumberField gain = {"--gain", -120, 120, false};
  static const NumberField duration = {"--duration", 0.01, 86400, false};
  double gain_db = 0;
  Outcome outcome = arguments_number(arguments, &gain, &gain_db);
  if (outcome == OUTCOME_OK) outcome = arguments_number(arguments, &duration, &request->duration);
  if (outcome == OUTCOME_OK) {
    outcome = humanize_read(arguments, HUMANIZE_LIVE, &request->humanizer);
  }
  if (outcome == OUTCOME_OK) outcome = render_threads_read(arguments, &request->threads);
  request->gain = pow(10, gain_db / 20);
  return outcome;
}

static Outcome read_keys(const Arguments *arguments, PlayRequest *request) {
  const char *const path = arguments_value(arguments, "keys");
  keymap_default(&request->keymap);
  return path ? keymap_read(path, &request->keymap) : OUTCOME_OK;
}

static Outcome read_kit(const Arguments *arguments, PlayRequest *request) {
  static const char *const excluded[] = {"midi-map", "mic"};
  Outcome outcome = kit_refuse_options(arguments, excluded, sizeof excluded / sizeof *excluded,
                                       "a kit has notes for its drums, and a mix of its own");
  if (outcome != OUTCOME_OK) return outcome;
  request->kit = malloc(sizeof *request->kit);
  if (!request->kit) return fail_memory();
  outcome = kit_load(arguments, request->kit);
  if (outcome != OUTCOME_OK) return outcome;
  request->preset = request->kit->name;
  request->def = request->kit->drum[0].def;
  return kit_midi_setup_read(arguments, &request->kit_midi);
}

static Outcome read_drum(const Arguments *arguments, PlayRequest *request) {
  if (arguments_has(arguments, "kit")) return read_kit(arguments, request);
  const Outcome outcome = kit_options_refuse(arguments);
  if (outcome != OUTCOME_OK) return outcome;
  request->preset = preset_argument(arguments);
  return drum_load(arguments, &request->def);
}

static Outcome read_midi(const Arguments *arguments, PlayRequest *request) {
  const char *const wanted = arguments_value(arguments, "midi-in");
  if (wanted && !*wanted) return refuse("--midi-in needs a part of a name");
  Outcome outcome = midi_mask_read(arguments, &request->mask_time);
  if (request->kit) return outcome; /* its song is read at the device's rate */
  if (outcome == OUTCOME_OK) outcome = midi_map_read(arguments, &request->def, &request->midi_map);
  if (outcome == OUTCOME_OK) {
    outcome = midi_song_read(arguments, &request->midi_map, &request->def,
                             request->model.sample_rate, &request->song);
  }
  if (outcome == OUTCOME_OK && !request->quiet) midi_song_note(arguments, &request->song);
  return outcome;
}

static Outcome read_model(const Arguments *arguments, PlayRequest *request) {
  const Outcome outcome = model_options_read(arguments, &request->def, &request->model);
  if (arguments_has(arguments, "rate")) request->device.rate = request->model.sample_rate;
  return outcome;
}

static Outcome read_mics(const Arguments *arguments, PlayRequest *request) {
  const char *name;
  size_t position = 0;
  if (request->kit) {
    request->channels = request->device.channels = 2;
    request->mics[1] = 1;
    return OUTCOME_OK;
  }
  if (request->def.mic_count == 0) return refuse("the drum has no microphone");
  if (arguments_has(arguments, "stereo")) {
    request->channels = request->device.channels = 2;
    return stereo_pair_take(arguments, &request->def, request->mics, &request->gain);
  }
  while ((name = arguments_next(arguments, "mic", &position)) != NULL) {
    const int mic = tabor_drum_def_find_mic(&request->def, name);
    char hint[512];
    suggest_choice(hint, sizeof hint, name, "", drum_mic_name, &request->def);
    if (mic < 0) return refuse("--mic '%.80s': the drum has no such microphone%s", name, hint);
    if (request->channels == TABOR_MAX_MICS) {
      return refuse("--mic: too many; allowed: up to %d", TABOR_MAX_MICS);
    }
    request->mics[request->channels++] = (uint32_t)mic;
  }
  if (request->channels == 0) request->channels = 1; /* the first, which is index 0 */
  request->device.channels = request->channels;
  return OUTCOME_OK;
}

static Outcome read_backend(const Arguments *arguments, PlayRequest *request) {
  return backend_read(arguments, &request->backend, &request->device);
}

static Outcome read_record(const Arguments *arguments, PlayRequest *request) {
  return record_request_read(arguments, request->channels, &request->record);
}

static Outcome read_log(const Arguments *arguments, PlayRequest *request) {
  const char *const name = arguments_value(arguments, "log");
  if (!name) return OUTCOME_OK;
  if (!*name || strcmp(name, "-") == 0) {
    return refuse("--log '%s': allowed: the name of a file, as take.log", name);
  }
  request->logs = true;
  const Outcome outcome =
    output_plan(&request->log, name, arguments_has(arguments, "no-overwrite"));
  if (outcome != OUTCOME_OK || !request->record.records ||
      !output_same(&request->log, &request->record.output)) {
    return outcome;
  }
  return refuse("--record and --log: both name the file '%s'", name);
}

static Outcome protect_samples(const OutputFile *output, const char *kind, const TaborKitDef *kit) {
  for (int note = 0; kit && note < TABOR_KIT_NOTES; note++) {
    const char *const path = kit->note[note].sample;
    if (*path && output_overwrites(output, path)) {
      return refuse("the %s would overwrite the sample '%s'", kind, path);
    }
  }
  return OUTCOME_OK;
}

/* @p output, which is @p kind, may replace nothing that is read. */
static Outcome protect_from(const OutputFile *output, const char *kind,
                            const PlayRequest *request) {
  const Arguments *const arguments = request->arguments;
  static const struct {
    const char *option, *what;
  } files[] = {
    {"keys", "keys"}, {"midi-file", "MIDI file"}, {"midi-map", "MIDI map"}, {"kit", "kit"}};
  char room[USER_PRESET_PATH];
  const char *name;
  size_t position = 0;
  const char *const file = request->kit ? NULL : preset_file(request->preset, room);
  if (file && output_overwrites(output, file)) {
    return refuse("the %s would overwrite the preset '%s'", kind, file);
  }
  for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
    name = arguments_value(arguments, files[i].option);
    if (name && output_overwrites(output, name)) {
      return refuse("the %s would overwrite the %s '%s'", kind, files[i].what, name);
    }
  }
  while ((name = arguments_next(arguments, "events", &position)) != NULL) {
    if (output_overwrites(output, name)) {
      return refuse("the %s would overwrite the events '%s'", kind, name);
    }
  }
  return protect_samples(output, kind, request->kit);
}

static Outcome protect_inputs(const Arguments *arguments, PlayRequest *request) {
  Outcome outcome = OUTCOME_OK;
  (void)arguments;
  if (request->record.records)
    outcome = protect_from(&request->record.output, "recording", request);
  if (outcome != OUTCOME_OK || !request->logs) return outcome;
  return protect_from(&request->log, "log", request);
}

Outcome play_request_read(const Arguments *arguments, PlayRequest *request) {
  static Outcome (*const steps[])(const Arguments *, PlayRequest *) = {
    read_flags, read_numbers, read_keys,   read_drum, read_model,     read_midi,
    read_mics,  read_backend, read_record, read_log,  protect_inputs,
  };
  memset(request, 0, sizeof *request);
  record_request_begin(&request->record);
  request->log = OUTPUT_FILE_NONE;
  Outcome outcome = OUTCOME_OK;
  for (size_t i = 0; outcome == OUTCOME_OK && i < sizeof steps / sizeof steps[0]; i++) {
    outcome = steps[i](arguments, request);
  }
  return outcome;
}

void play_request_kit_midi(const PlayRequest *request, KitMidi *midi) {
  kit_midi_begin(midi, request->kit, &request->kit_midi);
}

void play_request_free(PlayRequest *request) {
  record_request_free(&request->record);
  free(request->kit);
  output_discard(&request->log);
  midi_song_free(&request->song);
}
