/* SPDX-License-Identifier: MIT */
#include "render/sound_input.h"

#include <math.h>
#include <stdlib.h>

#include "base/suggest.h"
#include "drums/drum_args.h"
#include "files/audio_clip.h"
#include "sound/drum_player.h"

static Outcome read_mic(const Arguments *arguments, const TaborDrumDef *def, uint32_t *mic) {
  const char *const name = arguments_value(arguments, "input-mic");
  if (!name) return OUTCOME_OK;
  const int found = tabor_drum_def_find_mic(def, name);
  char hint[512];
  suggest_choice(hint, sizeof hint, name, "", drum_mic_name, def);
  if (found < 0)
    return refuse("--input-mic '%.80s': the drum has no such microphone%s", name, hint);
  *mic = (uint32_t)found;
  return OUTCOME_OK;
}

/* Limits what no recording holds, as the plugins do, and says so. */
static void limit_clip(const char *name, const AudioClip *clip) {
  double peak = 0;
  for (size_t i = 0; i < clip->count; i++) {
    peak = fmax(peak, fabs(clip->samples[i]));
    clip->samples[i] =
      fmin(fmax(clip->samples[i], -DRUM_PLAYER_MOST_INPUT), DRUM_PLAYER_MOST_INPUT);
  }
  if (peak <= DRUM_PLAYER_MOST_INPUT) return;
  warn("--input " INPUT ": its peak of %+.0f dBFS is limited to %+.0f dBFS", INPUT_OF(name),
       20 * log10(peak), 20 * log10(DRUM_PLAYER_MOST_INPUT));
}

static Outcome take_clip(const char *name, const AudioClip *clip, double rate, double level,
                         SoundInput *input) {
  if (clip->rate != rate) {
    return refuse("--input " INPUT ": its rate is %u Hz, that of the drum %.10g Hz; --rate %u fits",
                  INPUT_OF(name), (unsigned)clip->rate, rate, (unsigned)clip->rate);
  }
  if (clip->count == 0) return refuse("--input " INPUT ": it is empty", INPUT_OF(name));
  input->pressure = calloc(clip->count, sizeof *input->pressure);
  if (!input->pressure) return fail_memory();
  input->count = (uint32_t)clip->count;
  limit_clip(name, clip);
  for (size_t i = 0; i < clip->count; i++) input->pressure[i] = (float)(level * clip->samples[i]);
  return OUTCOME_OK;
}

Outcome sound_input_read(const Arguments *arguments, const TaborDrumDef *def, double rate,
                         SoundInput *input) {
  static const NumberField field = {"--input-level", 1e-3, 1000, false};
  static const AudioClipPart whole = {1, 0, INFINITY};
  const char *const name = arguments_value(arguments, "input");
  double level = SOUND_INPUT_LEVEL;
  AudioClip clip = {0};
  *input = (SoundInput){0};
  if (!name) {
    if (!arguments_has(arguments, "input-level") && !arguments_has(arguments, "input-mic")) {
      return OUTCOME_OK;
    }
    return refuse("--input-level and --input-mic need --input, the sound");
  }
  if (!*name) return refuse("--input needs the name of a file");
  Outcome outcome = arguments_number(arguments, &field, &level);
  if (outcome == OUTCOME_OK) outcome = read_mic(arguments, def, &input->mic);
  if (outcome == OUTCOME_OK) outcome = audio_clip_read(name, &whole, &clip);
  if (outcome == OUTCOME_OK) outcome = take_clip(name, &clip, rate, level, input);
  audio_clip_free(&clip);
  return outcome;
}

void sound_input_take(const SoundInput *input, uint64_t first, uint32_t count, float *to) {
  for (uint32_t i = 0; i < count; i++) {
    to[i] = first + i < input->count ? input->pressure[first + i] : 0.0f;
  }
}

void sound_input_free(SoundInput *input) {
  free(input->pressure);
  *input = (SoundInput){0};
}
