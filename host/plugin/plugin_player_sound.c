/* SPDX-License-Identifier: MIT */
/* Mixes a player's sound: the microphones of its drum at their levels. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "plugin/plugin_player_internal.h"

/* The knob of each microphone's level. */
static const KnobId mic_levels[PLUGIN_MICS] = {KNOB_LEVEL_TOP,   KNOB_LEVEL_BOTTOM, KNOB_LEVEL_NEAR,
                                               KNOB_LEVEL_FAR,   KNOB_LEVEL_PAIR,   KNOB_LEVEL_PAIR,
                                               KNOB_LEVEL_INSIDE};

static bool is_audible(const PluginPlayer *player, KnobId id) {
  return player->levels[id].now != 0 || player->levels[id].left > 0;
}

static bool hears(const PluginPlayer *player, const PluginBuffers *outputs, PluginMic mic) {
  return player->stereo ? is_audible(player, mic_levels[mic]) : outputs->channels[mic] != NULL;
}

static double next_level(PluginPlayer *player, KnobId id) {
  if (player->waits[id] == 0) return fader_next(&player->levels[id]);
  player->waits[id]--;
  return player->levels[id].now;
}

/* A sum as a sample: what is fainter than any float with all its digits is none, since subnormal
 * numbers make hosts slow. */
static float to_sample(double sum) REALTIME;
static float to_sample(double sum) { return fabs(sum) >= (double)FLT_MIN ? (float)sum : 0.0f; }

/* ---- sound in ------------------------------------------------------------------------------- */

static double limited(float sample) REALTIME;
static double limited(float sample) {
  return isfinite(sample)
           ? fmin(fmax((double)sample, -DRUM_PLAYER_MOST_INPUT), DRUM_PLAYER_MOST_INPUT)
           : 0;
}

/* A loudspeaker plays the mean of both channels at the place of the drum's first microphone. */
static void take_sound(PluginPlayer *player, const PluginBuffers *outputs, uint32_t at,
                       uint32_t frames) REALTIME;
static void take_sound(PluginPlayer *player, const PluginBuffers *outputs, uint32_t at,
                       uint32_t frames) {
  player->core.input = outputs->input[0] ? player->pressure : NULL;
  for (uint32_t i = 0; player->core.input && i < frames; i++) {
    const double sum = limited(outputs->input[0][at + i]) + limited(outputs->input[1][at + i]);
    player->pressure[i] = (float)(fader_next(&player->sound) * (0.5 * sum));
  }
}

/* The host may use the same buffers for both. */
static void mix_with_sound(PluginPlayer *player, const PluginBuffers *outputs, uint32_t at,
                           uint32_t frames, const float (*dry)[DRUM_PLAYER_BLOCK]) REALTIME;
static void mix_with_sound(PluginPlayer *player, const PluginBuffers *outputs, uint32_t at,
                           uint32_t frames, const float (*dry)[DRUM_PLAYER_BLOCK]) {
  for (uint32_t i = 0; i < frames; i++) {
    const double part = fader_next(&player->mix);
    for (uint32_t side = 0; side < 2; side++) {
      float *const out = outputs->channels[side];
      if (!out) continue;
      const double wet = (double)out[at + i];
      out[at + i] = to_sample((1 - part) * (double)dry[side][i] + part * wet);
    }
  }
}

static void keep_sound(const PluginBuffers *outputs, uint32_t at, uint32_t frames,
                       float (*dry)[DRUM_PLAYER_BLOCK]) REALTIME;
static void keep_sound(const PluginBuffers *outputs, uint32_t at, uint32_t frames,
                       float (*dry)[DRUM_PLAYER_BLOCK]) {
  for (uint32_t side = 0; side < 2; side++) {
    for (uint32_t i = 0; i < frames; i++)
      dry[side][i] = (float)limited(outputs->input[side][at + i]);
  }
}

/* ---- microphones ---------------------------------------------------------------------------- */

static void mix_stereo(PluginPlayer *player, float *const *channels, uint32_t at, uint32_t frames) {
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double pair = next_level(player, KNOB_LEVEL_PAIR);
    double left = pair * (double)player->core.sound[PLUGIN_LEFT][frame];
    double right = pair * (double)player->core.sound[PLUGIN_RIGHT][frame];
    for (uint32_t mic = PLUGIN_TOP; mic < PLUGIN_MICS; mic++) {
      if (mic == PLUGIN_LEFT || mic == PLUGIN_RIGHT) continue;
      const double level = next_level(player, mic_levels[mic]);
      const double sample = level * (double)player->core.sound[mic][frame];
      left += sample;
      right += sample;
    }
    if (channels[0]) channels[0][at + frame] = to_sample(left);
    if (channels[1]) channels[1][at + frame] = to_sample(right);
  }
}

static void copy_multi(const PluginPlayer *player, float *const *channels, uint32_t at,
                       uint32_t frames) {
  for (uint32_t mic = 0; mic < PLUGIN_MICS; mic++) {
    if (channels[mic]) memcpy(channels[mic] + at, player->core.sound[mic], frames * sizeof(float));
  }
}

uint32_t plugin_player_play(PluginPlayer *player, const PluginBuffers *outputs, uint32_t at,
                            uint32_t most) {
  const uint32_t frames = most < DRUM_PLAYER_BLOCK ? most : DRUM_PLAYER_BLOCK;
  player->core.heard = 0;
  for (uint32_t mic = 0; mic < PLUGIN_MICS; mic++) {
    if (hears(player, outputs, (PluginMic)mic)) player->core.heard |= UINT64_C(1) << mic;
  }
  take_sound(player, outputs, at, frames);
  drum_player_play(&player->core, plugin_player_next, player, frames);
  if (outputs->input[0]) {
    float dry[2][DRUM_PLAYER_BLOCK];
    keep_sound(outputs, at, frames, dry);
    mix_stereo(player, outputs->channels, at, frames);
    mix_with_sound(player, outputs, at, frames, (const float(*)[DRUM_PLAYER_BLOCK])dry);
  } else if (player->stereo) {
    mix_stereo(player, outputs->channels, at, frames);
  } else {
    copy_multi(player, outputs->channels, at, frames);
  }
  return frames;
}
