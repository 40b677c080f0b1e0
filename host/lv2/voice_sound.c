/* SPDX-License-Identifier: MIT */
/* What a voice sounds like: its drum's microphones, and those of one that leaves, at their levels. */
#include "voice_inside.h"

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
  for (uint32_t i = 0; i < count; i++) {
    TaborEvent *const event = &voice->events[i];
    /* meant for another preset, which had more of them */
    if (event->type == TABOR_EVENT_STRIKE && event->striker >= voice->striker_count)
      event->striker = 0;
    silencer_remember(&voice->silencer, event);
  }
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
  Leaving *const leaving = &voice->leaving;
  float *planar[TABOR_MAX_MICS] = {NULL}, *leaving_planar[TABOR_MAX_MICS] = {NULL};
  const uint32_t count = take_events(voice);
  if (!voice->drum) return;
  choose_planar(heard, voice->mics, voice->planar, planar);
  tabor_drum_process(voice->drum, voice->events, count, planar, frames);
  if (!leaving->drum) return;
  choose_planar(heard, leaving->mics, voice->leaving_planar, leaving_planar);
  tabor_drum_process(leaving->drum, voice->events, leaving->is_copy ? count : 0, leaving_planar,
                     frames);
}

/* How much of the leaving drum is heard so many frames from now. */
static double leaving_part(const Voice *voice, uint32_t frame) {
  const Leaving *const leaving = &voice->leaving;
  const double length = (leaving->is_copy ? CROSS_FADE : RING_OUT) * voice->rate;
  if (frame < leaving->hold) return 1;
  const uint32_t gone = frame - leaving->hold;
  return gone < leaving->fade ? (leaving->fade - gone) / (length + 1) : 0;
}

/* What a microphone hears, of the drum and of the one that leaves. */
static void gather(Voice *voice, VoiceMic mic, uint32_t frames) {
  const Leaving *const leaving = &voice->leaving;
  const uint32_t index = voice->mics[mic], old = leaving->mics[mic];
  double *const sound = voice->sound[mic];
  for (uint32_t i = 0; i < frames; i++) {
    sound[i] = index == WORKSHOP_NO_MIC ? 0 : (double)voice->planar[index][i];
  }
  for (uint32_t i = 0; leaving->drum && i < frames; i++) {
    const double part = leaving_part(voice, i);
    const double sample = old == WORKSHOP_NO_MIC ? 0 : (double)voice->leaving_planar[old][i];
    sound[i] += part * (sample - (leaving->is_copy ? sound[i] : 0));
  }
}

static void pass(Voice *voice, uint32_t frames) {
  Leaving *const leaving = &voice->leaving;
  const uint32_t held = frames < leaving->hold ? frames : leaving->hold, rest = frames - held;
  leaving->hold -= held;
  leaving->fade -= rest < leaving->fade ? rest : leaving->fade;
  if (leaving->hold + leaving->fade == 0) voice_end_leaving(voice);
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
  if (silencer_is_due(&voice->silencer)) voice_end_leaving(voice);
  if (voice->drum) silencer_step(&voice->silencer, voice->drum);
  voice_act_due(voice);
  if (waits && !voice_is_settled(voice)) return 0;
  const uint32_t frames = silencer_limit(&voice->silencer, most < VOICE_PIECE ? most : VOICE_PIECE);
  bool heard[VOICE_MICS];
  for (uint32_t mic = 0; mic < VOICE_MICS; mic++) heard[mic] = hears(voice, outputs, (VoiceMic)mic);
  compute(voice, heard, frames);
  for (uint32_t mic = 0; mic < VOICE_MICS; mic++) {
    if (heard[mic]) gather(voice, (VoiceMic)mic, frames);
  }
  if (voice->stereo) {
    mix_stereo(voice, heard, outputs->channels, at, frames);
  } else {
    mix_multi(voice, heard, outputs->channels, at, frames);
  }
  if (voice->leaving.drum) pass(voice, frames);
  return frames;
}
