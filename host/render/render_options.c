/* SPDX-License-Identifier: MIT */
#include "render/render_options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "base/suggest.h"
#include "drums/drum_args.h"
#include "drums/stereo_pair.h"
#include "kit/kit_args.h"
#include "kit/kit_options.h"
#include "kit/kit_song_input.h"
#include "midi/midi_mask.h"
#include "midi/midi_options.h"
#include "platform/process.h"
#include "render/render_outputs.h"
#include "render/variations.h"
#include "strokes/duration.h"
#include "strokes/humanize_options.h"
#include "strokes/stroke_options.h"

const Option render_options[] = {
  {"output", 'o', "FILE",
   "sound file: .wav, .flac or .au; '-' streams AU (default " DEFAULT_OUTPUT "); or FOLDER/"},
  {"no-overwrite", 'n', NULL, "fail if the output exists"},
  OPTION_FORMAT,
  OPTION_RATE,
  OPTION_QUALITY,
  OPTION_DURATION,
  OPTION_STRIKE,
  OPTION_EVENTS,
  {"replay", 0, "FILE", "play what 'tabor play --log FILE' has written, to the bit; see below"},
  OPTION_MIDI_FILE,
  OPTION_STRICT,
  OPTION_MASK_TIME,
  OPTION_KIT,
  OPTION_MAP,
  OPTION_PLACE_CC,
  OPTION_MIDI_MAP,
  OPTION_MIDI_CHANNEL,
  OPTION_VELOCITY_CURVE,
  OPTION_VELOCITY_RANGE,
  OPTION_HUMANIZE("0"),
  OPTION_SEED,
  OPTION_SET,
  OPTION_VARY,
  OPTION_COUNT,
  {"each", 0, NULL, "a sound for each --events file, in a folder; see below"},
  OPTION_JOBS,
  OPTION_MIC,
  OPTION_STEREO,
  OPTION_INPUT,
  OPTION_INPUT_LEVEL,
  OPTION_INPUT_MIC,
  {"split", 0, NULL,
   "a file for each microphone (default: all) or drum of a kit; take.wav gives take-NAME.wav"},
  OPTION_GAIN,
  {"normalize", 0, NULL, "amplify all channels together to a peak of -1 dBFS"},
  {"trace", 0, "FILE", "also write displacements, forces and energy, a row a sample, as CSV"},
  {"verbose", 'v', NULL, "print more about what was done"},
  {0},
};

Outcome render_threads_read(const Arguments *arguments, uint32_t *count) {
  static const NumberField field = {"--jobs", 1, MOST_JOBS, true};
  const unsigned processors = process_processors();
  double threads = processors > MOST_JOBS ? MOST_JOBS : processors;
  const Outcome outcome = arguments_number(arguments, &field, &threads);
  *count = (uint32_t)threads;
  return outcome;
}

/* A step of reading the command line. */
typedef Outcome ReadFn(const Arguments *arguments, RenderRequest *request);

static Outcome read_gain(const Arguments *arguments, RenderRequest *request) {
  static const NumberField field = {"--gain", -120, 120, false};
  const Outcome outcome = arguments_number(arguments, &field, &request->gain_db);
  request->gain = pow(10, request->gain_db / 20);
  request->normalize = arguments_has(arguments, "normalize");
  if (outcome == OUTCOME_OK && request->normalize && arguments_has(arguments, "gain")) {
    return refuse("--gain and --normalize: both would set the level");
  }
  return outcome;
}

/* A stick may be lifted after the end. */
static Outcome read_duration(const Arguments *arguments, RenderRequest *request) {
  static const NumberField field = {"--duration", 0.01, 3600, false};
  const char *const text = arguments_value(arguments, "duration");
  if (!text) return OUTCOME_OK;
  double duration = 0;
  const Outcome outcome = number_read(&field, text, &duration);
  if (outcome != OUTCOME_OK) return outcome;
  request->frames = (uint32_t)llround(duration * request->model.sample_rate);
  const uint32_t last = render_request_last_stroke(request);
  if (last < request->frames) return OUTCOME_OK;
  return duration_too_short(arguments,
                            arguments_has(arguments, "midi-file") || request->input.count > 0,
                            last / request->model.sample_rate, request->quiet);
}

static bool has_mic(const RenderRequest *request, uint32_t mic) {
  for (uint32_t i = 0; i < request->channels; i++) {
    if (request->mics[i] == mic) return true;
  }
  return false;
}

static Outcome add_mic(RenderRequest *request, const char *name) {
  const int mic = tabor_drum_def_find_mic(&request->def, name);
  char hint[512];
  suggest_choice(hint, sizeof hint, name, "", drum_mic_name, &request->def);
  if (mic < 0) return refuse("--mic '%.80s': the drum has no such microphone%s", name, hint);
  if (request->split && has_mic(request, (uint32_t)mic)) {
    return refuse("--mic '%.80s': given twice, but --split makes one file of it", name);
  }
  if (request->channels == MOST_CHANNELS) {
    return refuse("--mic: too many; allowed: up to %d", MOST_CHANNELS);
  }
  request->mics[request->channels++] = (uint32_t)mic;
  return OUTCOME_OK;
}

/* A log has the microphones that were played. Otherwise the first is taken, with --split all. */
static Outcome take_default_mics(RenderRequest *request) {
  const LogStart *const start = &request->replay.start;
  const uint32_t count = request->def.mic_count;
  if (count == 0) return refuse("the drum has no microphone");
  if (request->replays && !request->split) {
    request->channels = start->channels;
    memcpy(request->mics, start->mics, start->channels * sizeof *start->mics);
    return OUTCOME_OK;
  }
  request->channels = request->split ? count : 1;
  for (uint32_t mic = 0; mic < request->channels; mic++) request->mics[mic] = mic;
  return OUTCOME_OK;
}

static Outcome take_pair(const Arguments *arguments, RenderRequest *request) {
  request->channels = 2;
  const double gain = request->gain;
  const Outcome outcome = stereo_pair_take(arguments, &request->def, request->mics, &request->gain);
  if (request->normalize) request->gain = gain; /* the peak decides */
  return outcome;
}

/* The mix, or each drum's part of it. */
static Outcome read_kit_outputs(const Arguments *arguments, RenderRequest *request) {
  if (arguments_has(arguments, "mic"))
    return refuse("--mic: a kit is heard in its own mix; --split gives each drum's part of it");
  request->split = arguments_has(arguments, "split");
  request->audio.channels = 2;
  request->channels = request->split ? 2 * request->kit->drum_count : 2;
  for (uint32_t i = 0; i < request->channels; i++) request->mics[i] = request->split ? 2 + i : i;
  return OUTCOME_OK;
}

static Outcome read_mics(const Arguments *arguments, RenderRequest *request) {
  if (request->kit) return read_kit_outputs(arguments, request);
  request->split = arguments_has(arguments, "split");
  const char *name;
  size_t position = 0;
  Outcome outcome = OUTCOME_OK;
  if (arguments_has(arguments, "stereo")) outcome = take_pair(arguments, request);
  while (outcome == OUTCOME_OK && (name = arguments_next(arguments, "mic", &position))) {
    outcome = add_mic(request, name);
  }
  if (outcome == OUTCOME_OK && request->channels == 0) outcome = take_default_mics(request);
  request->audio.channels = request->split ? 1 : request->channels;
  return outcome;
}

static Outcome read_encoding(const Arguments *arguments, RenderRequest *request) {
  const char *const name = arguments_value(arguments, "format");
  return audio_encoding(name ? name : DEFAULT_ENCODING, &request->audio.encoding);
}

static Outcome read_flags(const Arguments *arguments, RenderRequest *request) {
  request->json = arguments_has(arguments, "json");
  request->quiet = arguments_has(arguments, "quiet");
  request->verbose = arguments_has(arguments, "verbose") && !request->quiet;
  return OUTCOME_OK;
}

static Outcome read_kit(const Arguments *arguments, RenderRequest *request) {
  static const char *const excluded[] = {"trace", "midi-map",    "mic",
                                         "input", "input-level", "input-mic"};
  Outcome outcome =
    kit_refuse_options(arguments, excluded, sizeof excluded / sizeof *excluded,
                       "not together; a kit has notes for its drums, and a mix of its own");
  if (outcome != OUTCOME_OK) return outcome;
  if (!arguments_has(arguments, "midi-file") && !arguments_has(arguments, "events") &&
      !arguments_has(arguments, "strike")) {
    return refuse("--kit needs what to play: --midi-file, --events or --strike");
  }
  request->own_kit = malloc(sizeof *request->own_kit);
  if (!request->own_kit) return fail_memory();
  outcome = kit_load(arguments, request->own_kit);
  if (outcome != OUTCOME_OK) return outcome;
  render_request_set_kit(request, request->own_kit);
  return render_threads_read(arguments, &request->threads);
}

/* Only one thing can come from there. */
static Outcome check_standard_input(const Arguments *arguments) {
  const char *const song = arguments_value(arguments, "midi-file");
  const char *events;
  size_t position = 0;
  if (!song || strcmp(song, "-") != 0) return OUTCOME_OK;
  while ((events = arguments_next(arguments, "events", &position))) {
    if (strcmp(events, "-") == 0)
      return refuse("--events - and --midi-file -: allowed: one of them");
  }
  return OUTCOME_OK;
}

static Outcome read_kit_song(const Arguments *arguments, RenderRequest *request) {
  KitMidiSetup setup;
  Humanizer humanizer;
  Outcome outcome = kit_midi_setup_read(arguments, &setup);
  if (outcome == OUTCOME_OK) outcome = humanize_read(arguments, 0, &humanizer);
  if (outcome != OUTCOME_OK) return outcome;
  KitMidi *const midi = request->kit_midi = malloc(sizeof *midi);
  if (!midi) return fail_memory();
  kit_midi_begin(midi, request->kit, &setup);
  outcome = check_standard_input(arguments);
  if (outcome != OUTCOME_OK) return outcome;
  return kit_song_read(arguments, request->kit, midi, humanizer, request->model.sample_rate,
                       &request->kit_song);
}

static Outcome note_kit_song(const Arguments *arguments, RenderRequest *request) {
  const char *const name = arguments_value(arguments, "midi-file");
  if (name && !request->quiet) kit_song_note(name, request->kit_midi);
  return OUTCOME_OK;
}

static Outcome read_drum(const Arguments *arguments, RenderRequest *request) {
  const Outcome outcome = kit_options_refuse(arguments);
  request->preset = preset_argument(arguments);
  return outcome == OUTCOME_OK ? drum_load(arguments, &request->def) : outcome;
}

static Outcome read_model(const Arguments *arguments, RenderRequest *request) {
  const Outcome outcome = model_options_read(arguments, &request->def, &request->model);
  request->audio.rate = (uint32_t)request->model.sample_rate;
  return outcome;
}

static Outcome read_strokes(const Arguments *arguments, RenderRequest *request) {
  const Outcome outcome = check_standard_input(arguments);
  if (outcome != OUTCOME_OK) return outcome;
  return strokes_read(arguments, &request->def, request->model.sample_rate, &request->strokes);
}

static Outcome read_input(const Arguments *arguments, RenderRequest *request) {
  return sound_input_read(arguments, &request->def, request->model.sample_rate, &request->input);
}

/* Its events join the strokes. */
static Outcome read_song(const Arguments *arguments, RenderRequest *request) {
  MidiMap map;
  TaborEvent *events = NULL;
  size_t count = 0;
  Outcome outcome = midi_map_read(arguments, &request->def, &map);
  if (outcome != OUTCOME_OK || !arguments_has(arguments, "midi-file")) return outcome;
  outcome =
    midi_song_read(arguments, &map, &request->def, request->model.sample_rate, &request->song);
  if (outcome == OUTCOME_OK) outcome = midi_song_take_events(&request->song, &events, &count);
  if (outcome == OUTCOME_OK) outcome = strokes_merge(&request->strokes, events, count);
  free(events);
  if (outcome == OUTCOME_OK && !request->quiet) midi_song_note(arguments, &request->song);
  return outcome;
}

/* Strokes are in order of time by now, so that the order in which they were given does not matter;
   each falls on the drum that the song has put there. */
static Outcome scatter_strokes(const Arguments *arguments, RenderRequest *request) {
  const MidiSong *const song = &request->song;
  Humanizer player;
  size_t next = 0;
  double head_radius = request->def.shell.radius;
  const Outcome outcome = humanize_read(arguments, 0, &player);
  if (outcome != OUTCOME_OK) return outcome;
  for (size_t i = 0; i < request->strokes.count; i++) {
    TaborEvent *const event = &request->strokes.events[i];
    for (; next < song->count && song->items[next].frame <= event->frame; next++) {
      const MidiSongItem *const item = &song->items[next];
      if (item->action.type == MIDI_ACTION_PRESET) head_radius = item->head_radius;
    }
    humanize(&player, head_radius, event);
  }
  return OUTCOME_OK;
}

/* ---- a log ---- */

/* What a log has of its own. */
static Outcome check_replay(const Arguments *arguments) {
  static const char *const excluded[] = {
    "strike",         "events",         "midi-file", "midi-map", "midi-channel",
    "velocity-curve", "velocity-range", "humanize",  "seed",     "set",
    "rate",           "quality",        "gain",      "stereo",   "input",
    "input-level",    "input-mic",      "mask-time", "strict",   "kit",
  };
  for (size_t i = 0; i < sizeof excluded / sizeof excluded[0]; i++) {
    if (!arguments_has(arguments, excluded[i])) continue;
    return refuse("--replay and --%s: the log has what is played, and how", excluded[i]);
  }
  if (!arguments->operand) return OUTCOME_OK;
  return refuse("--replay and '%.80s': the log has the drum", arguments->operand);
}

static void note_replay(const char *name, const RenderRequest *request) {
  const Replay *const replay = &request->replay;
  if (replay->lost > 0) {
    warn("'%s' lacks %llu messages; the sound is not the one that was played", name,
         (unsigned long long)replay->lost);
  }
  if (replay->is_cut) {
    warn(INPUT " ends after %.1f s without its end; the sound stops there", INPUT_OF(name),
         replay->frames / replay->start.rate);
  }
  if (request->quiet || strcmp(replay->start.program, tabor_version()) == 0) return;
  note("'%s' was written by version %s; this is %s, and may sound different", name,
       replay->start.program, tabor_version());
}

static Outcome read_replay(const Arguments *arguments, RenderRequest *request) {
  const char *const name = arguments_value(arguments, "replay");
  Replay *const replay = &request->replay;
  Outcome outcome = check_replay(arguments);
  if (outcome == OUTCOME_OK) outcome = replay_read(name, replay);
  if (outcome != OUTCOME_OK) return outcome;
  request->replays = true;
  request->def = replay->drum->def;
  if (replay->kit) {
    render_request_set_kit(request, replay->kit);
    outcome = render_threads_read(arguments, &request->threads);
  }
  request->preset = replay->drum->preset;
  tabor_model_options_default(&request->model);
  request->model.sample_rate = replay->start.rate;
  request->model.quality = replay->drum->quality;
  request->audio.rate = (uint32_t)lround(replay->start.rate);
  request->gain = replay->start.gain;
  request->frames = replay->frames;
  note_replay(name, request);
  return outcome;
}

/* ---- all of it ---- */

Outcome render_request_read(const Arguments *arguments, RenderRequest *request) {
  /* each step relies on those before; files come last, so that a wrong request touches none */
  static ReadFn *const strokes[] = {
    read_encoding, read_flags,          read_gain,  read_drum,       read_model,
    read_strokes,  read_song,           read_input, scatter_strokes, read_duration,
    read_mics,     render_outputs_plan, NULL,
  };
  static ReadFn *const replay[] = {
    read_encoding, read_flags, read_gain,           read_replay,
    read_duration, read_mics,  render_outputs_plan, NULL,
  };
  static ReadFn *const kit[] = {
    read_encoding, read_flags, read_gain,           read_kit,      read_model, read_kit_song,
    read_duration, read_mics,  render_outputs_plan, note_kit_song, NULL,
  };
  ReadFn *const *step = strokes;
  if (arguments_has(arguments, "kit")) step = kit;
  if (arguments_has(arguments, "replay")) step = replay;
  render_request_clear(request);
  Outcome outcome = OUTCOME_OK;
  for (; outcome == OUTCOME_OK && *step; step++) outcome = (*step)(arguments, request);
  return outcome;
}

Outcome render_kit_format_read(const Arguments *arguments, const TaborKitDef *kit,
                               RenderRequest *request) {
  static ReadFn *const steps[] = {
    read_encoding, read_flags, read_gain, read_model, read_duration, read_mics, NULL,
  };
  Outcome outcome = OUTCOME_OK;
  render_request_set_kit(request, kit);
  for (ReadFn *const *step = steps; outcome == OUTCOME_OK && *step; step++) {
    outcome = (*step)(arguments, request);
  }
  return outcome == OUTCOME_OK ? audio_format_check(&request->audio) : outcome;
}
