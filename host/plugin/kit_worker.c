/* SPDX-License-Identifier: MIT */
#include "plugin/kit_worker.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plugin/model_cache.h"
#include "plugin/model_worker.h"
#include "plugin/sound_file.h"

void kit_voice_destroy(KitVoice *voice) {
  if (!voice) return;
  tabor_kit_destroy(voice->kit);
  for (uint32_t i = 0; i < voice->drum_count; i++) model_cache_give_back(voice->models[i]);
  free(voice);
}

/* ---- beginning and end ---------------------------------------------------------------------- */

void kit_worker_begin(KitWorker *worker, double rate, OwnKit *own, KitWorkerSayFn *say,
                      void *context) {
  memset(worker, 0, sizeof *worker);
  worker->rate = rate;
  worker->own = own;
  worker->say = say;
  worker->context = context;
}

static void free_retired(KitWorker *worker) {
  kit_voice_destroy(atomic_exchange(&worker->retired, NULL));
}

void kit_worker_end(KitWorker *worker) {
  free_retired(worker);
  if (atomic_load(&worker->phase) == KIT_PHASE_ANSWERED) kit_voice_destroy(worker->answer);
  atomic_store(&worker->phase, KIT_PHASE_IDLE);
}

void kit_worker_cancel(KitWorker *worker) { atomic_store(&worker->is_cancelled, true); }

void kit_worker_resume(KitWorker *worker) { atomic_store(&worker->is_cancelled, false); }

/* ---- building ------------------------------------------------------------------------------- */

static bool goes_on(double done, void *context) {
  const KitWorker *const worker = context;
  (void)done;
  return !atomic_load(&worker->is_cancelled) && !atomic_load(&worker->is_outdated);
}

static void say(const KitWorker *worker, const char *what, const TaborError *error) {
  char line[2 * TABOR_TEXT_SIZE];
  (void)snprintf(line, sizeof line, "%s: %s", what, error->message);
  if (worker->say) worker->say(worker->context, line);
}

static TaborStatus out_of_memory(TaborError *error) {
  *error = (TaborError){.status = TABOR_ERROR_MEMORY, .message = "out of memory"};
  return TABOR_ERROR_MEMORY;
}

/* At the quality that was asked for, or the highest one below it that the limits allow. */
static TaborStatus take_model(KitWorker *worker, const TaborDrumDef *def, TaborModel **model,
                              TaborError *error) {
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.sample_rate = worker->rate;
  options.quality = TABOR_QUALITY_DRAFT + (uint32_t)worker->wanted[KIT_KNOB_QUALITY];
  options.most_seconds = MODEL_WORKER_MOST_SECONDS;
  options.most_bytes = MODEL_WORKER_MOST_BYTES;
  options.progress = goes_on;
  options.progress_context = worker;
  for (;; options.quality--) {
    const TaborStatus status = model_cache_take(def, &options, model, error);
    if (status != TABOR_ERROR_LIMIT || options.quality <= TABOR_QUALITY_DRAFT) return status;
    say(worker, "the next lower quality plays", error);
  }
}

static TaborStatus take_models(KitWorker *worker, const TaborKitDef *def, KitVoice *voice,
                               TaborError *error) {
  TaborStatus status = TABOR_OK;
  for (uint32_t i = 0; i < def->drum_count && status == TABOR_OK; i++) {
    TaborDrumDef placed;
    status = tabor_kit_def_place(def, i, &placed, error);
    if (status == TABOR_OK) status = take_model(worker, &placed, &voice->models[i], error);
  }
  return status;
}

static KitMidiSetup setup_of(const float *wanted) {
  const uint32_t notes = (uint32_t)wanted[KIT_KNOB_NOTES];
  KitMidiSetup setup = kit_midi_setup_default;
  setup.response = (MidiResponse){.curve = (MidiCurve)wanted[KIT_KNOB_VELOCITY_CURVE],
                                  .range = (MidiRange)wanted[KIT_KNOB_VELOCITY_RANGE]};
  setup.map = notes > 0 ? &kit_maps[notes - 1u] : NULL;
  return setup;
}

/* The drums of a kit that is tuned, or stands in another room, are those of before. */
static TaborStatus follow(const KitWorker *worker, KitVoice *voice, TaborError *error) {
  uint8_t drums[TABOR_KIT_DRUMS];
  voice->follows = worker->playing != NULL;
  if (!voice->follows) return TABOR_OK;
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) drums[i] = (uint8_t)i;
  return tabor_kit_follow(voice->kit, worker->playing->kit, drums, error);
}

/* A KitSoundFn. A note whose file cannot be read is silent. */
static bool read_sound(void *context, const char *name, KitSound *sound) {
  const KitWorker *const worker = context;
  char message[TABOR_TEXT_SIZE];
  const bool is_read = sound_file_read(name, sound, message, sizeof message);
  if (!is_read && worker->say) worker->say(worker->context, message);
  return true;
}

/* A kit that follows another one has its sounds. */
static TaborStatus load_sounds(KitWorker *worker, KitVoice *voice, TaborError *error) {
  if (voice->follows) return TABOR_OK;
  return kit_samples_load(voice->kit, read_sound, worker, error);
}

static TaborStatus fill_voice(KitWorker *worker, TaborKitDef *def, KitVoice *voice,
                              TaborError *error) {
  const KitMidiSetup setup = setup_of(worker->wanted);
  TaborStatus status = kit_knobs_define(worker->wanted, worker->own, def, error);
  if (status != TABOR_OK) return status;
  voice->drum_count = def->drum_count;
  voice->coupling = def->coupling;
  voice->overheads = def->overheads;
  status = take_models(worker, def, voice, error);
  if (status == TABOR_OK) status = tabor_kit_create(def, voice->models, &voice->kit, error);
  if (status == TABOR_OK) status = follow(worker, voice, error);
  if (status == TABOR_OK) status = load_sounds(worker, voice, error);
  if (status != TABOR_OK) return status;
  kit_midi_begin(&voice->midi, def, &setup);
  return status;
}

static TaborStatus build(KitWorker *worker, TaborError *error) {
  TaborKitDef *const def = malloc(sizeof *def);
  KitVoice *const voice = calloc(1, sizeof *voice);
  const TaborStatus status =
    def && voice ? fill_voice(worker, def, voice, error) : out_of_memory(error);
  free(def);
  worker->answer = status == TABOR_OK ? voice : NULL;
  if (status != TABOR_OK) kit_voice_destroy(voice);
  return status;
}

/* Once: knobs are turned often. */
static void say_held(KitWorker *worker) {
  if (!worker->is_held || worker->has_said_held) return;
  worker->has_said_held = true;
  if (worker->say) worker->say(worker->context, PLUGIN_HELD_LINE);
}

static void say_missing(const KitWorker *worker) {
  if (!kit_knob_is_own(worker->wanted[KIT_KNOB_KIT]) || own_kit_version(worker->own) > 0) return;
  if (worker->say) worker->say(worker->context, "no kit file has been loaded: the usual kit plays");
}

void kit_worker_work(KitWorker *worker) {
  unsigned asked = KIT_PHASE_ASKED;
  TaborError error;
  free_retired(worker);
  if (!atomic_compare_exchange_strong(&worker->phase, &asked, KIT_PHASE_BUILDING)) return;
  say_held(worker);
  say_missing(worker);
  const TaborStatus status = build(worker, &error);
  worker->failed = status != TABOR_OK && status != TABOR_ERROR_CANCELLED;
  if (worker->failed) say(worker, "the kit stays as it is", &error);
  atomic_store(&worker->phase, KIT_PHASE_ANSWERED);
}
