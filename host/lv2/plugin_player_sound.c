/* SPDX-License-Identifier: MIT */
/* Mixes a player's sound: the microphones of its drum and of leaving drums, at their levels. */
#include <string.h>

#include "lv2/plugin_player_internal.h"

/* The knob of each microphone's level. */
static const KnobId mic_levels[PLUGIN_MICS] = {KNOB_LEVEL_TOP,   KNOB_LEVEL_BOTTOM, KNOB_LEVEL_NEAR,
                                               KNOB_LEVEL_FAR,   KNOB_LEVEL_PAIR,   KNOB_LEVEL_PAIR,
                                               KNOB_LEVEL_INSIDE};

static bool is_audible(const PluginPlayer *player, KnobId id) {
  return player->levels[id].now != 0 || player->levels[id].left > 0;
}

static bool hears(const PluginPlayer *player, const PluginOutputs *outputs, PluginMic mic) {
  if (!player->drum) return false;
  return player->stereo ? is_audible(player, mic_levels[mic]) : outputs->channels[mic] != NULL;
}

/* Strokes that wait for the end of a silence stay. */
static uint32_t take_events(PluginPlayer *player) {
  const uint32_t count = silencer_waits(&player->silencer) ? 0 : player->event_count;
  plugin_player_note_events(player, count);
  player->event_count -= count;
  return count;
}

/* Where a drum's microphones go: NULL for those that nobody hears. */
static void choose_planar(const bool *heard, const uint32_t *mics, float (*samples)[PLUGIN_PIECE],
                          float **planar) {
  for (uint32_t mic = 0; mic < PLUGIN_MICS; mic++) {
    if (heard[mic] && mics[mic] != MODEL_WORKER_NO_MIC) planar[mics[mic]] = samples[mics[mic]];
  }
}

static void compute(PluginPlayer *player, const bool *heard, uint32_t frames) {
  TaborDrum *const crossing = player->crossing.drum;
  float *planar[TABOR_MAX_MICS] = {NULL}, *crossing_planar[TABOR_MAX_MICS] = {NULL};
  const uint32_t count = take_events(player);
  if (!player->drum) return;
  choose_planar(heard, player->mics, player->planar, planar);
  tabor_drum_process(player->drum, player->events, count, planar, frames);
  if (!crossing) return;
  choose_planar(heard, player->mics, player->crossing_planar, crossing_planar);
  tabor_drum_process(crossing, player->events, count, crossing_planar, frames);
}

/* How much of what the drum was before a swap is heard so many frames from now. */
static double crossing_part(const PluginPlayer *player, uint32_t frame) {
  const Crossing *const crossing = &player->crossing;
  if (frame < crossing->hold) return 1;
  const uint32_t gone = frame - crossing->hold;
  return gone < crossing->fade ? (crossing->fade - gone) / (CROSS_FADE * player->rate + 1) : 0;
}

/* What a microphone hears of the drum. */
static void hear(PluginPlayer *player, PluginMic mic, uint32_t frames) {
  const uint32_t index = player->mics[mic];
  double *const sound = player->sound[mic];
  if (index == MODEL_WORKER_NO_MIC) {
    memset(sound, 0, frames * sizeof *sound);
    return;
  }
  for (uint32_t i = 0; i < frames; i++) sound[i] = (double)player->planar[index][i];
  for (uint32_t i = 0; player->crossing.drum && i < frames; i++) {
    sound[i] += crossing_part(player, i) * ((double)player->crossing_planar[index][i] - sound[i]);
  }
}

static void gather(PluginPlayer *player, const bool *heard, uint32_t frames) {
  double *sound[PLUGIN_MICS] = {NULL};
  for (uint32_t mic = 0; mic < PLUGIN_MICS; mic++) {
    if (!heard[mic]) continue;
    sound[mic] = player->sound[mic];
    hear(player, (PluginMic)mic, frames);
  }
  leaving_play(&player->leaving, sound, PLUGIN_MICS, frames);
}

static void pass(PluginPlayer *player, uint32_t frames) {
  Crossing *const crossing = &player->crossing;
  const uint32_t held = frames < crossing->hold ? frames : crossing->hold, rest = frames - held;
  crossing->hold -= held;
  crossing->fade -= rest < crossing->fade ? rest : crossing->fade;
  if (crossing->hold + crossing->fade == 0) plugin_player_end_crossing(player);
  plugin_player_clear_up(player);
  player->chosen_before = player->chosen;
  player->held_events = player->event_count;
  player->held_actions = player->action_count;
}

/* The gain of all channels: it moves with the frames. In the order of a rendering's factors. */
static double next_gain(PluginPlayer *player) {
  return fader_next(&player->gain) * fader_next(&player->expression) *
         silencer_next(&player->silencer);
}

static double next_level(PluginPlayer *player, KnobId id) {
  if (player->waits[id] == 0) return fader_next(&player->levels[id]);
  player->waits[id]--;
  return player->levels[id].now;
}

static void mix_stereo(PluginPlayer *player, const bool *heard, float *const *channels, uint32_t at,
                       uint32_t frames) {
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double gain = next_gain(player), pair = next_level(player, KNOB_LEVEL_PAIR);
    double left = heard[PLUGIN_LEFT] ? pair * player->sound[PLUGIN_LEFT][frame] : 0;
    double right = heard[PLUGIN_RIGHT] ? pair * player->sound[PLUGIN_RIGHT][frame] : 0;
    for (uint32_t mic = PLUGIN_TOP; mic < PLUGIN_MICS; mic++) {
      if (mic == PLUGIN_LEFT || mic == PLUGIN_RIGHT) continue;
      const double level = next_level(player, mic_levels[mic]);
      const double sample = heard[mic] ? level * player->sound[mic][frame] : 0;
      left += sample;
      right += sample;
    }
    if (channels[0]) channels[0][at + frame] = (float)(gain * left);
    if (channels[1]) channels[1][at + frame] = (float)(gain * right);
  }
}

static void mix_multi(PluginPlayer *player, const bool *heard, float *const *channels, uint32_t at,
                      uint32_t frames) {
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double gain = next_gain(player);
    for (uint32_t mic = 0; mic < PLUGIN_MICS; mic++) {
      const double sample = heard[mic] ? player->sound[mic][frame] : 0;
      if (channels[mic]) channels[mic][at + frame] = (float)(gain * sample);
    }
  }
}

uint32_t plugin_player_play(PluginPlayer *player, const PluginOutputs *outputs, uint32_t at,
                            uint32_t most, bool waits) {
  if (silencer_is_due(&player->silencer)) plugin_player_cut_others(player);
  if (player->drum) silencer_step(&player->silencer, player->drum);
  plugin_player_act_due(player, waits);
  if (waits && !plugin_player_is_settled(player)) return 0;
  const uint32_t frames =
    silencer_limit(&player->silencer, most < PLUGIN_PIECE ? most : PLUGIN_PIECE);
  bool heard[PLUGIN_MICS];
  for (uint32_t mic = 0; mic < PLUGIN_MICS; mic++)
    heard[mic] = hears(player, outputs, (PluginMic)mic);
  compute(player, heard, frames);
  gather(player, heard, frames);
  if (player->stereo) {
    mix_stereo(player, heard, outputs->channels, at, frames);
  } else {
    mix_multi(player, heard, outputs->channels, at, frames);
  }
  pass(player, frames);
  return frames;
}
