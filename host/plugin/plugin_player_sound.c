/* SPDX-License-Identifier: MIT */
/* Mixes a player's sound: the microphones of its drum at their levels. */
#include <string.h>

#include "plugin/plugin_player_internal.h"

/* The knob of each microphone's level. */
static const KnobId mic_levels[PLUGIN_MICS] = {KNOB_LEVEL_TOP,   KNOB_LEVEL_BOTTOM, KNOB_LEVEL_NEAR,
                                               KNOB_LEVEL_FAR,   KNOB_LEVEL_PAIR,   KNOB_LEVEL_PAIR,
                                               KNOB_LEVEL_INSIDE};

static bool is_audible(const PluginPlayer *player, KnobId id) {
  return player->levels[id].now != 0 || player->levels[id].left > 0;
}

static bool hears(const PluginPlayer *player, const PluginOutputs *outputs, PluginMic mic) {
  return player->stereo ? is_audible(player, mic_levels[mic]) : outputs->channels[mic] != NULL;
}

static double next_level(PluginPlayer *player, KnobId id) {
  if (player->waits[id] == 0) return fader_next(&player->levels[id]);
  player->waits[id]--;
  return player->levels[id].now;
}

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
    if (channels[0]) channels[0][at + frame] = (float)left;
    if (channels[1]) channels[1][at + frame] = (float)right;
  }
}

static void copy_multi(const PluginPlayer *player, float *const *channels, uint32_t at,
                       uint32_t frames) {
  for (uint32_t mic = 0; mic < PLUGIN_MICS; mic++) {
    if (channels[mic]) memcpy(channels[mic] + at, player->core.sound[mic], frames * sizeof(float));
  }
}

uint32_t plugin_player_play(PluginPlayer *player, const PluginOutputs *outputs, uint32_t at,
                            uint32_t most) {
  const uint32_t frames = most < DRUM_PLAYER_BLOCK ? most : DRUM_PLAYER_BLOCK;
  player->core.heard = 0;
  for (uint32_t mic = 0; mic < PLUGIN_MICS; mic++) {
    if (hears(player, outputs, (PluginMic)mic)) player->core.heard |= 1u << mic;
  }
  drum_player_play(&player->core, plugin_player_next, player, frames);
  if (player->stereo) {
    mix_stereo(player, outputs->channels, at, frames);
  } else {
    copy_multi(player, outputs->channels, at, frames);
  }
  return frames;
}
