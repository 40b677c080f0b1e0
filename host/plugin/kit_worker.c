/* SPDX-License-Identifier: MIT */
#include "plugin/kit_worker.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plugin/model_cache.h"
#include "plugin/sound_file.h"

void kit_voice_destroy(KitVoice *voice) {
  if (!voice) return;
  tabor_kit_destroy(voice->kit);
  for (uint32_t i = 0; i < voice->drum_count; i++) model_cache_give_back(voice->models[i]);
  free(voice);
}

/* ---- beginning and end ---------------------------------------------------------------------- */

void kit_worker_begin(KitWorker *worker, double rate, OwnKit *own, KitThreads *threads,
                      BuilderSayFn *say, void *context) {
  memset(worker, 0, sizeof *worker);
  builder_begin(&worker->builder, rate, say, context);
  worker->own = own;
  worker->threads = threads;
}

static void free_retired(KitWorker *worker) {
  kit_voice_destroy(atomic_exchange(&worker->retired, NULL));
}

void kit_worker_end(KitWorker *worker) {
  free_retired(worker);
  if (builder_is(&worker->builder, BUILDER_ANSWERED)) kit_voice_destroy(worker->answer);
  builder_accept(&worker->builder);
}

/* ---- building ------------------------------------------------------------------------------- */

static TaborStatus take_models(KitWorker *worker, const TaborKitDef *def, KitVoice *voice,
                               TaborError *error) {
  const uint32_t quality = TABOR_QUALITY_DRAFT + (uint32_t)worker->wanted[KIT_KNOB_QUALITY];
  TaborStatus status = TABOR_OK;
  for (uint32_t i = 0; i < def->drum_count && status == TABOR_OK; i++) {
    TaborDrumDef placed;
    if (atomic_load(&worker->builder.is_outdated)) return TABOR_ERROR_CANCELLED;
    status = tabor_kit_def_place(def, i, &placed, error);
    if (status == TABOR_OK)
      status = builder_model(&worker->builder, &placed, quality, &voice->models[i], error);
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
  if (!is_read) builder_say_line(&worker->builder, message);
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
  kit_threads_serve(worker->threads, voice->kit);
  kit_midi_begin(&voice->midi, def, &setup);
  return status;
}

static TaborStatus build(KitWorker *worker, TaborError *error) {
  TaborKitDef *const def = malloc(sizeof *def);
  KitVoice *const voice = calloc(1, sizeof *voice);
  const TaborStatus status =
    def && voice ? fill_voice(worker, def, voice, error) : builder_out_of_memory(error);
  free(def);
  worker->answer = status == TABOR_OK ? voice : NULL;
  if (status != TABOR_OK) kit_voice_destroy(voice);
  return status;
}

static void say_missing(const KitWorker *worker) {
  if (!kit_knob_is_own(worker->wanted[KIT_KNOB_KIT]) || own_kit_version(worker->own) > 0) return;
  builder_say_line(&worker->builder, "no kit file has been loaded: the usual kit plays");
}

void kit_worker_work(KitWorker *worker) {
  TaborError error;
  free_retired(worker);
  if (!builder_take(&worker->builder)) return;
  if (worker->is_held) builder_say_held(&worker->builder);
  say_missing(worker);
  const TaborStatus status = build(worker, &error);
  worker->failed = status != TABOR_OK && status != TABOR_ERROR_CANCELLED;
  if (worker->failed) builder_say(&worker->builder, "the kit stays as it is", &error);
  builder_answer(&worker->builder);
}
