/* SPDX-License-Identifier: MIT */
#include "render/kit_take.h"

#include <math.h>

#include "drums/drum_args.h"
#include "platform/clock.h"
#include "render/render_options.h"

#define LEAST_TIME 0.5   /* [s] after the last event */
#define ENERGY_FALL 1e-9 /* 90 dB, as for a single drum (sound/ring_out.h) */
#define QUIET 1e-5       /* -100 dBFS: of a block, once the drums have died away */

static uint32_t drums_of(const KitTake *take) {
  return tabor_kit_definition(take->kit)->drum_count;
}

/* ---- files ---- */

static Outcome open_files(KitTake *take) {
  const double most = take->song.last_frame + ceil(KIT_TAKE_MOST_TIME * take->format.audio.rate);
  Outcome outcome = OUTCOME_OK;
  take->format.audio.most_frames = take->format.frames > 0 ? take->format.frames : (uint64_t)most;
  for (uint32_t i = 0; i < take->output_count && outcome == OUTCOME_OK; i++) {
    outcome = output_open(&take->outputs[i], take->format.audio.container != AUDIO_AU);
    if (outcome == OUTCOME_OK) {
      outcome = audio_file_open(&take->files[i], &take->format.audio, &take->outputs[i]);
    }
  }
  return outcome;
}

static Outcome deliver(KitTake *take) {
  OutputFile *outputs[TABOR_KIT_DRUMS];
  Outcome outcome = OUTCOME_OK;
  for (uint32_t i = 0; i < take->output_count && outcome == OUTCOME_OK; i++) {
    outcome = audio_file_finish(&take->files[i]);
    if (outcome == OUTCOME_OK) outcome = output_complete(&take->outputs[i]);
    outputs[i] = &take->outputs[i];
  }
  return outcome == OUTCOME_OK ? output_deliver(outputs, take->output_count) : outcome;
}

/* ---- sound ---- */

/* Of the events up to a frame those of drums, which stay together, from `first` on; returns their number. Samples begin. */
static uint32_t take_events(KitTake *take, size_t first, uint64_t end) {
  uint32_t count = 0;
  for (; take->next_event < take->song.count; take->next_event++) {
    TaborKitEvent event = take->song.events[take->next_event];
    if (event.event.frame >= end) break;
    event.event.frame -= take->position;
    if (event.drum < KIT_SAMPLE) {
      take->song.events[first + count++] = event;
    } else if (take->samples) {
      kit_samples_take(take->samples, event.drum - KIT_SAMPLE, &event.event, event.event.frame);
    }
  }
  return count;
}

static void compute(KitTake *take, uint32_t frames) {
  TaborKitOutputs outputs = {0};
  const size_t first = take->next_event;
  for (uint32_t i = 0; i < take->output_count; i++) {
    float **const pair = take->split ? outputs.drum[i] : outputs.stereo;
    pair[0] = take->sound[i][0];
    pair[1] = take->sound[i][1];
  }
  const uint32_t count = take_events(take, first, (uint64_t)take->position + frames);
  const double start = process_seconds();
  tabor_kit_process(take->kit, take->song.events + first, count, &outputs, frames);
  if (!take->split && take->samples) {
    kit_samples_add(take->samples, take->sound[0][0], take->sound[0][1], frames);
  }
  take->computing += process_seconds() - start;
  take->position += frames;
}

static Outcome write_block(KitTake *take, uint32_t frames) {
  double samples[2 * AUDIO_BLOCK];
  Outcome outcome = OUTCOME_OK;
  take->block_peak = 0;
  for (uint32_t file = 0; file < take->output_count && outcome == OUTCOME_OK; file++) {
    for (uint32_t i = 0; i < 2 * frames; i++) {
      const float sample = take->sound[file][i % 2][i / 2];
      samples[i] = take->format.gain * (double)sample;
      take->block_peak = fmaxf(take->block_peak, fabsf(sample));
      take->peak = fmax(take->peak, fabs(samples[i]));
    }
    outcome = audio_file_write(&take->files[file], samples, frames);
  }
  return outcome;
}

static double stored_energy(const KitTake *take) {
  double stored = 0;
  for (uint32_t i = 0; i < drums_of(take); i++) {
    TaborLedger ledger;
    tabor_drum_ledger(tabor_kit_drum(take->kit, i), &ledger);
    stored += ledger.stored;
  }
  return stored;
}

/* As for a single drum: 90 dB down, but 0.5 s after the last event at least and 20 s at most. */
static bool is_over(KitTake *take) {
  const double since = ((double)take->position - take->song.last_frame) / take->format.audio.rate;
  if (take->format.frames > 0) return take->position >= take->format.frames;
  if (since <= 0) return false;
  const double stored = stored_energy(take);
  take->loudest = fmax(take->loudest, stored);
  const bool without_samples =
    take->split || !take->samples || kit_samples_are_silent(take->samples);
  const bool silent =
    stored <= ENERGY_FALL * take->loudest && (double)take->block_peak < QUIET && without_samples;
  take->sounding = !silent;
  return (since >= LEAST_TIME && silent) || since >= KIT_TAKE_MOST_TIME;
}

static Outcome play(KitTake *take, PlayedFn *played, void *context) {
  Outcome outcome = OUTCOME_OK;
  do {
    const uint32_t left = (uint32_t)take->format.audio.most_frames - take->position;
    const uint32_t frames = left < AUDIO_BLOCK ? left : AUDIO_BLOCK;
    compute(take, frames);
    outcome = write_block(take, frames);
    if (played) played(context, take->position);
  } while (outcome == OUTCOME_OK && !is_over(take) &&
           take->position < take->format.audio.most_frames);
  return outcome;
}

/* ---- a take ---- */

Outcome kit_format_read(const Arguments *arguments, const TaborKitDef *kit,
                        TaborModelOptions *model, KitFormat *format) {
  static const NumberField gain = {"--gain", -120, 120, false};
  static const NumberField duration = {"--duration", 0.01, 3600, false};
  const char *const encoding = arguments_value(arguments, "format");
  double seconds = 0;
  *format = (KitFormat){.audio = {.channels = 2}};
  Outcome outcome = audio_encoding(encoding ? encoding : DEFAULT_ENCODING, &format->audio.encoding);
  if (outcome == OUTCOME_OK) outcome = arguments_number(arguments, &gain, &format->gain_db);
  if (outcome == OUTCOME_OK) outcome = arguments_number(arguments, &duration, &seconds);
  if (outcome == OUTCOME_OK) outcome = model_options_read(arguments, &kit->drum[0].def, model);
  if (outcome != OUTCOME_OK) return outcome;
  format->gain = pow(10, format->gain_db / 20);
  format->audio.rate = (uint32_t)model->sample_rate;
  format->frames = (uint32_t)llround(seconds * model->sample_rate);
  return OUTCOME_OK;
}

void kit_take_begin(KitTake *take) {
  *take = (KitTake){0};
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) take->outputs[i] = OUTPUT_FILE_NONE;
}

Outcome kit_take_write(KitTake *take, PlayedFn *played, void *context) {
  Outcome outcome = open_files(take);
  if (outcome == OUTCOME_OK) outcome = play(take, played, context);
  return outcome == OUTCOME_OK ? deliver(take) : outcome;
}

TaborStatistics kit_take_statistics(const KitTake *take, uint32_t drum) {
  TaborStatistics statistics;
  tabor_drum_statistics(tabor_kit_drum(take->kit, drum), &statistics);
  return statistics;
}

void kit_take_warn(const KitTake *take) {
  const double largest = audio_largest(take->format.audio.encoding);
  uint64_t lost = tabor_kit_dropped(take->kit);
  for (uint32_t i = 0; i < drums_of(take); i++) lost += kit_take_statistics(take, i).dropped_events;
  if (take->peak > largest) {
    warn("the peak of %+.1f dBFS saturates; --gain %.1f avoids it", 20 * log10(take->peak),
         floor(10 * (take->format.gain_db - 20 * log10(take->peak / largest))) / 10);
  }
  if (lost > 0) warn("%llu events were dropped", (unsigned long long)lost);
}

void kit_take_free(KitTake *take) {
  tabor_kit_destroy(take->kit);
  kit_song_free(&take->song);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    audio_file_free(&take->files[i]);
    output_discard(&take->outputs[i]);
  }
}
