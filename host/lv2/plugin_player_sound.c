/* SPDX-License-Identifier: MIT */
/* What a voice sounds like: its drum's microphones, and those of drums on their way out, at their levels. */
#include <string.h>

#include "lv2/plugin_player_internal.h"

/* The knob of each microphone's level. */
static const KnobId mic_levels[VOICE_MICS] = {KNOB_LEVEL_TOP, KNOB_LEVEL_BOTTOM, KNOB_LEVEL_NEAR,
                                              KNOB_LEVEL_FAR, KNOB_LEVEL_PAIR,   KNOB_LEVEL_PAIR};

static bool is_audible(const Voice *voice, KnobId id) {
  return voice->levels[id].now != 0 || voice->levels[id].left > 0;
}

static bool hears(const Voice *voice, const VoiceOutputs *outputs, VoiceMic mic) {
  if (!voice->drum) return false;
  return voice->stereo ? is_audible(voice, mic_levels[mic]) : outputs->channels[mic] != NULL;
}

/* Strokes that wait for the end of a silence stay. */
static uint32_t take_events(Voice *voice) {
  const uint32_t count = silencer_waits(&voice->silencer) ? 0 : voice->event_count;
  voice_note_events(voice, count);
  voice->event_count -= count;
  return count;
}

/* Where a drum's microphones go: NULL for those that nobody hears. */
static void choose_planar(const bool *heard, const uint32_t *mics, float (*samples)[VOICE_PIECE],
                          float **planar) {
  for (uint32_t mic = 0; mic < VOICE_MICS; mic++) {
    if (heard[mic] && mics[mic] != WORKSHOP_NO_MIC) planar[mics[mic]] = samples[mics[mic]];
  }
}

static void compute(Voice *voice, const bool *heard, uint32_t frames) {
  TaborDrum *const crossing = voice->crossing.drum;
  float *planar[TABOR_MAX_MICS] = {NULL}, *crossing_planar[TABOR_MAX_MICS] = {NULL};
  const uint32_t count = take_events(voice);
  if (!voice->drum) return;
  choose_planar(heard, voice->mics, voice->planar, planar);
  tabor_drum_process(voice->drum, voice->events, count, planar, frames);
  if (!crossing) return;
  choose_planar(heard, voice->mics, voice->crossing_planar, crossing_planar);
  tabor_drum_process(crossing, voice->events, count, crossing_planar, frames);
}

/* How much of what the drum was before a swap is heard so many frames from now. */
static double crossing_part(const Voice *voice, uint32_t frame) {
  const Crossing *const crossing = &voice->crossing;
  if (frame < crossing->hold) return 1;
  const uint32_t gone = frame - crossing->hold;
  return gone < crossing->fade ? (crossing->fade - gone) / (CROSS_FADE * voice->rate + 1) : 0;
}

/* What a microphone hears of the drum. */
static void hear(Voice *voice, VoiceMic mic, uint32_t frames) {
  const uint32_t index = voice->mics[mic];
  double *const sound = voice->sound[mic];
  if (index == WORKSHOP_NO_MIC) {
    memset(sound, 0, frames * sizeof *sound);
    return;
  }
  for (uint32_t i = 0; i < frames; i++) sound[i] = (double)voice->planar[index][i];
  for (uint32_t i = 0; voice->crossing.drum && i < frames; i++) {
    sound[i] += crossing_part(voice, i) * ((double)voice->crossing_planar[index][i] - sound[i]);
  }
}

static void gather(Voice *voice, const bool *heard, uint32_t frames) {
  double *sound[VOICE_MICS] = {NULL};
  for (uint32_t mic = 0; mic < VOICE_MICS; mic++) {
    if (!heard[mic]) continue;
    sound[mic] = voice->sound[mic];
    hear(voice, (VoiceMic)mic, frames);
  }
  leaving_play(&voice->leaving, sound, VOICE_MICS, frames);
}

static void pass(Voice *voice, uint32_t frames) {
  Crossing *const crossing = &voice->crossing;
  const uint32_t held = frames < crossing->hold ? frames : crossing->hold, rest = frames - held;
  crossing->hold -= held;
  crossing->fade -= rest < crossing->fade ? rest : crossing->fade;
  if (crossing->hold + crossing->fade == 0) voice_end_crossing(voice);
  voice_clear_up(voice);
  voice->chosen_before = voice->chosen;
  voice->held_events = voice->event_count;
  voice->held_actions = voice->action_count;
}

/* The gain of all channels: it moves with the frames. In the order of a rendering's factors. */
static double next_gain(Voice *voice) {
  return fader_next(&voice->gain) * fader_next(&voice->expression) *
         silencer_next(&voice->silencer);
}

static double next_level(Voice *voice, KnobId id) {
  if (voice->waits[id] == 0) return fader_next(&voice->levels[id]);
  voice->waits[id]--;
  return voice->levels[id].now;
}

static void mix_stereo(Voice *voice, const bool *heard, float *const *channels, uint32_t at,
                       uint32_t frames) {
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double gain = next_gain(voice), pair = next_level(voice, KNOB_LEVEL_PAIR);
    double left = heard[VOICE_LEFT] ? pair * voice->sound[VOICE_LEFT][frame] : 0;
    double right = heard[VOICE_RIGHT] ? pair * voice->sound[VOICE_RIGHT][frame] : 0;
    for (uint32_t mic = VOICE_TOP; mic <= VOICE_FAR; mic++) {
      const double level = next_level(voice, mic_levels[mic]);
      const double sample = heard[mic] ? level * voice->sound[mic][frame] : 0;
      left += sample;
      right += sample;
    }
    if (channels[0]) channels[0][at + frame] = (float)(gain * left);
    if (channels[1]) channels[1][at + frame] = (float)(gain * right);
  }
}

static void mix_multi(Voice *voice, const bool *heard, float *const *channels, uint32_t at,
                      uint32_t frames) {
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double gain = next_gain(voice);
    for (uint32_t mic = 0; mic < VOICE_MICS; mic++) {
      const double sample = heard[mic] ? voice->sound[mic][frame] : 0;
      if (channels[mic]) channels[mic][at + frame] = (float)(gain * sample);
    }
  }
}

uint32_t voice_play(Voice *voice, const VoiceOutputs *outputs, uint32_t at, uint32_t most,
                    bool waits) {
  if (silencer_is_due(&voice->silencer)) voice_cut_others(voice);
  if (voice->drum) silencer_step(&voice->silencer, voice->drum);
  voice_act_due(voice, waits);
  if (waits && !voice_is_settled(voice)) return 0;
  const uint32_t frames = silencer_limit(&voice->silencer, most < VOICE_PIECE ? most : VOICE_PIECE);
  bool heard[VOICE_MICS];
  for (uint32_t mic = 0; mic < VOICE_MICS; mic++) heard[mic] = hears(voice, outputs, (VoiceMic)mic);
  compute(voice, heard, frames);
  gather(voice, heard, frames);
  if (voice->stereo) {
    mix_stereo(voice, heard, outputs->channels, at, frames);
  } else {
    mix_multi(voice, heard, outputs->channels, at, frames);
  }
  pass(voice, frames);
  return frames;
}
