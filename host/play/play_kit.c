/* SPDX-License-Identifier: MIT */
#include "play/play_kit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/interrupt.h"
#include "base/json_output.h"
#include "drums/drum_args.h"
#include "kit/kit_args.h"
#include "kit/kit_build.h"
#include "kit/kit_options.h"
#include "kit/kit_player.h"
#include "kit/kit_song_input.h"
#include "midi/midi_input.h"
#include "midi/midi_mask.h"
#include "platform/clock.h"
#include "platform/process.h"
#include "play/backend.h"
#include "play/play_report.h"
#include "play/record_request.h"
#include "play/take_writer.h"
#include "strokes/humanize_options.h"

#define TURN 0.05     /* [s] between two looks at signals and the device */
#define SIGNALLED 128 /* exit status of a program that a signal ended, less its number */

/* A kit on a device. */
typedef struct KitSession {
  TaborKitDef def;
  TaborModelOptions model;
  KitMidi song_midi, live_midi; /* of the file; of the thread that receives */
  KitSong song;
  KitSamples samples;
  Humanizer song_scatter, live_scatter;
  MidiMask mask;
  KitMidiSetup midi;
  double gain, duration;
  bool quiet, json;
  const Backend *backend;
  BackendRequest device;
  RecordRequest record;
  TakeWriter *writer;
  BackendStream *stream;
  BackendFacts facts;
  uint64_t recorded; /* frames in the file */
  MidiInput *input;
  TaborKit *kit;
  KitPlayer player;
} KitSession;

/* ---- the request ----------------------------------------------------------------------------- */

static Outcome check_options(const Arguments *arguments) {
  static const char *const excluded[] = {"log", "events", "midi-map", "keys", "mic", "stereo"};
  return kit_refuse_options(arguments, excluded, sizeof excluded / sizeof *excluded,
                            "a kit is played by MIDI, and heard in its own mix");
}

static Outcome read_device(const Arguments *arguments, KitSession *s) {
  s->device.channels = 2;
  if (arguments_has(arguments, "rate")) s->device.rate = s->model.sample_rate;
  const Outcome outcome = backend_read(arguments, &s->backend, &s->device);
  if (outcome != OUTCOME_OK || !s->backend->waits || s->duration > 0) return outcome;
  return refuse("--kit and --backend file need --duration");
}

/* The recording may replace nothing that is read. */
static Outcome protect_inputs(const Arguments *arguments, const KitSession *s) {
  static const char *const files[] = {"kit", "midi-file"};
  for (size_t i = 0; s->record.records && i < sizeof files / sizeof *files; i++) {
    const char *const name = arguments_value(arguments, files[i]);
    if (!name || !output_overwrites(&s->record.output, name)) continue;
    return refuse("the recording would overwrite --%s '%s'", files[i], name);
  }
  return OUTCOME_OK;
}

static Outcome read_numbers(const Arguments *arguments, KitSession *s) {
  static const NumberField gain = {"--gain", -120, 120, false};
  static const NumberField duration = {"--duration", 0.01, 86400, false};
  double gain_db = 0;
  s->quiet = arguments_has(arguments, "quiet");
  s->json = arguments_has(arguments, "json");
  Outcome outcome = arguments_number(arguments, &gain, &gain_db);
  if (outcome == OUTCOME_OK) outcome = arguments_number(arguments, &duration, &s->duration);
  if (outcome == OUTCOME_OK) outcome = humanize_read(arguments, 0.3, &s->live_scatter);
  if (outcome == OUTCOME_OK) outcome = kit_midi_setup_read(arguments, &s->midi);
  if (outcome == OUTCOME_OK) outcome = midi_mask_read(arguments, &s->mask.time);
  if (outcome == OUTCOME_OK) {
    outcome = model_options_read(arguments, &s->def.drum[0].def, &s->model);
  }
  s->song_scatter = s->live_scatter;
  s->gain = pow(10, gain_db / 20);
  return outcome;
}

/* ---- opening --------------------------------------------------------------------------------- */

static Outcome open_device(KitSession *s) {
  const Outcome outcome = s->backend->open(&s->device, &s->stream, &s->facts);
  s->model.sample_rate = s->facts.rate;
  return outcome;
}

static Outcome read_song(const Arguments *arguments, KitSession *s) {
  const char *const name = arguments_value(arguments, "midi-file");
  kit_midi_begin(&s->song_midi, &s->def, &s->midi);
  kit_midi_begin(&s->live_midi, &s->def, &s->midi);
  for (int i = 0; i < MIDI_VALUES; i++) {
    s->song_midi.has_sample[i] = s->live_midi.has_sample[i] = s->samples.notes[i].path != NULL;
  }
  if (!name) return OUTCOME_OK;
  const Outcome outcome =
    kit_song_read(arguments, &s->song_midi, s->song_scatter, s->model.sample_rate, &s->song);
  if (outcome == OUTCOME_OK && !s->quiet) kit_song_note(name, &s->song_midi);
  return outcome;
}

static Outcome create_player(KitSession *s) {
  const KitPlayerSetup setup = {.kit = s->kit,
                                .song = &s->song,
                                .samples = &s->samples,
                                .rate = s->model.sample_rate,
                                .gain = s->gain,
                                .width = s->facts.width,
                                .buffer = s->facts.buffer,
                                .end = (uint64_t)llround(s->duration * s->model.sample_rate),
                                .records = s->record.records};
  return kit_player_begin(&s->player, &setup);
}

static Outcome start_recorder(KitSession *s) {
  RecordRequest *const record = &s->record;
  if (!record->records) return OUTCOME_OK;
  record->audio.rate = (uint32_t)lround(s->facts.rate);
  record->audio.most_frames = s->player.setup.end > 0 ? s->player.setup.end : UINT64_MAX;
  return take_writer_start(&record->audio, &record->output, &s->player.recording, &s->writer);
}

/* A MidiInputFn. */
static void receive(void *context, double time, const MidiMessage *message) {
  KitSession *const s = context;
  TaborKitEvent events[KIT_MIDI_MOST_EVENTS];
  if (!midi_mask_passes(&s->mask, message, time)) return;
  const uint32_t count = kit_midi_take(&s->live_midi, message, events);
  for (uint32_t i = 0; i < count; i++) {
    if (events[i].drum < s->def.drum_count) {
      humanize(&s->live_scatter, s->live_midi.head_radius[events[i].drum], &events[i].event);
    }
    kit_player_send(&s->player, time, &events[i]);
  }
}

static Outcome open_all(const Arguments *arguments, KitSession *s) {
  Outcome outcome = open_device(s);
  if (outcome == OUTCOME_OK) outcome = read_song(arguments, s);
  if (outcome == OUTCOME_OK) outcome = kit_samples_load(&s->samples, s->model.sample_rate);
  if (outcome == OUTCOME_OK) {
    outcome = kit_build(&s->def, &s->model, process_processors(), &s->kit);
  }
  if (outcome == OUTCOME_OK) outcome = create_player(s);
  if (outcome == OUTCOME_OK) outcome = start_recorder(s);
  if (outcome != OUTCOME_OK || s->backend->waits) return outcome;
  return midi_input_open(arguments_value(arguments, "midi-in"), s->quiet, receive, s, &s->input);
}

/* ---- playing --------------------------------------------------------------------------------- */

static bool process(void *context, float *samples, uint32_t frames, double now, bool gap) {
  KitSession *const s = context;
  return kit_player_process(&s->player, samples, frames, now, gap);
}

/* Nothing is in a hurry here: the block waits for the disk. */
static bool prepare(void *context, uint32_t frames) {
  const KitSession *const s = context;
  take_writer_wait(s->writer, frames);
  return true;
}

static void announce(const KitSession *s) {
  if (s->quiet || s->backend->waits) return;
  note("kit %s on '%s': %.10g Hz, %u frames at once, %.1f ms from a stroke to its sound",
       s->def.name, s->facts.device, s->facts.rate, (unsigned)s->facts.buffer,
       1000 * (s->facts.buffer / s->facts.rate + s->facts.latency));
}

static Outcome run(KitSession *s) {
  const BackendClient client = {.process = process, .prepare = prepare, .context = s};
  interrupt_catch();
  announce(s);
  const Outcome outcome = s->backend->start(s->stream, &client);
  if (outcome != OUTCOME_OK) return outcome;
  while (!kit_player_is_over(&s->player)) {
    if (interrupt_caught() != 0) return (Outcome)(SIGNALLED + interrupt_caught());
    if (!s->backend->is_running(s->stream) && !kit_player_is_over(&s->player)) {
      return fail("'%s' is gone: it asks for no more sound", s->facts.device);
    }
    clock_sleep_until(stopwatch_seconds(CLOCK_MONOTONIC) + TURN);
  }
  return OUTCOME_OK;
}

/* Once no block is asked for any more. */
static Outcome finish_recording(KitSession *s) {
  TakeWriter *const writer = s->writer;
  s->writer = NULL;
  if (!writer) return OUTCOME_OK;
  s->backend->close(s->stream);
  s->stream = NULL;
  recording_hand_over(&s->player.recording);
  return take_writer_finish(writer, &s->recorded);
}

/* ---- the report ------------------------------------------------------------------------------ */

static Outcome print_json(KitSession *s, const KitPlayerStatus *status) {
  json_t *drums = json_array();
  for (uint32_t i = 0; i < s->def.drum_count; i++) {
    TaborStatistics statistics;
    tabor_drum_statistics(tabor_kit_drum(s->kit, i), &statistics);
    drums = json_with_item(drums, json_pack("{s:o, s:I}", "name", json_text(s->def.drum[i].name),
                                            "strokes", (json_int_t)statistics.strikes));
  }
  return json_print(json_pack("{s:o, s:o, s:o, s:I, s:I, s:o}", "kit", json_text(s->def.name),
                              "seconds", json_number(status->seconds), "peak",
                              json_number(status->peak), "gaps", (json_int_t)status->gaps,
                              "dropped", (json_int_t)status->dropped, "drums", drums));
}

static Outcome report(KitSession *s) {
  KitPlayerStatus status;
  kit_player_status(&s->player, &status);
  if (status.clipped > 0) {
    warn("%llu samples were clipped: the peak was %+.1f dBFS", (unsigned long long)status.clipped,
         20 * log10(status.peak));
  }
  play_report_gaps(status.gaps, status.worst_load);
  if (status.dropped > 0) {
    warn("%llu events were dropped: too many at once", (unsigned long long)status.dropped);
  }
  const uint64_t lost = atomic_load(&s->player.recording.lost);
  if (lost > 0) {
    warn("the recording has %llu frames of silence where the disk was too slow",
         (unsigned long long)lost);
  }
  if (s->json) return print_json(s, &status);
  if (!s->quiet) {
    note("%.2f s played, %.2f of real time%s%s", status.seconds, status.load,
         s->recorded > 0 ? "; recorded in " : "", s->recorded > 0 ? s->record.output.name : "");
  }
  return OUTCOME_OK;
}

static void close_all(KitSession *s) {
  (void)finish_recording(s); /* nothing, unless opening failed */
  midi_input_close(s->input);
  if (s->backend && s->stream) s->backend->close(s->stream);
  record_request_free(&s->record);
  kit_player_end(&s->player);
  tabor_kit_destroy(s->kit);
  kit_song_free(&s->song);
  kit_samples_free(&s->samples);
  free(s);
}

Outcome play_kit(const Arguments *arguments) {
  KitSession *const s = calloc(1, sizeof *s);
  if (!s) return fail_memory();
  record_request_begin(&s->record);
  Outcome outcome = check_options(arguments);
  if (outcome == OUTCOME_OK) outcome = kit_load(arguments, &s->def, &s->samples);
  if (outcome == OUTCOME_OK) outcome = read_numbers(arguments, s);
  if (outcome == OUTCOME_OK) outcome = record_request_read(arguments, 2, &s->record);
  if (outcome == OUTCOME_OK) outcome = protect_inputs(arguments, s);
  if (outcome == OUTCOME_OK) outcome = read_device(arguments, s);
  if (outcome == OUTCOME_OK) outcome = open_all(arguments, s);
  if (outcome == OUTCOME_OK) {
    outcome = run(s);
    const Outcome recorded = finish_recording(s), said = report(s);
    if (outcome == OUTCOME_OK) outcome = recorded;
    if (outcome == OUTCOME_OK) outcome = said;
  }
  close_all(s);
  return outcome;
}
