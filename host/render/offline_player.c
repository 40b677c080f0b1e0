/* SPDX-License-Identifier: MIT */
#include "render/offline_player.h"

#include <math.h>

#include "base/stopwatch.h"
#include "drums/drum_args.h"
#include "strokes/fit_striker.h"

Outcome session_open(Session *session, RenderRequest *request) {
  const double rate = request->model.sample_rate;
  session->request = request;
  session->next_event = session->next_item = 0;
  session->position = 0;
  session->peak = session->computing = 0;
  session->drops = (SessionDrops){0};
  session->expression = fader_at(1, rate);
  session->silencer = silencer_begin(rate);
  session->presets = (PresetDrums){.options = &request->model};
  session->tally = (Tally){0};
  leaving_begin(&session->leaving, rate);
  for (uint32_t i = 0; i < request->channels; i++) session->mics[i] = request->mics[i];
  return drum_create(&request->def, &request->model, &session->drum);
}

/* ---- strokes ---- */

/* The strokes before frame @p end; those that waited act at the first. */
static uint32_t take_events(Session *session, uint32_t end) {
  const Strokes *const strokes = &session->request->strokes;
  const TaborDrumDef *const def = tabor_model_definition(tabor_drum_model(session->drum));
  TaborEvent *const events = strokes->events + session->next_event;
  const uint32_t position = session->position;
  uint32_t count = 0;
  while (!silencer_waits(&session->silencer) && session->next_event < strokes->count &&
         events[count].frame < end) {
    TaborEvent *const event = &events[count]; /* from here on counted within the piece */
    event->frame = event->frame > position ? event->frame - position : 0;
    fit_striker(event, def->striker_count);
    silencer_remember(&session->silencer, event);
    session->next_event++;
    count++;
  }
  return count;
}

static uint32_t count_strokes(const TaborEvent *events, uint32_t count) {
  uint32_t strokes = 0;
  for (uint32_t i = 0; i < count; i++) strokes += events[i].type == TABOR_EVENT_STRIKE;
  return strokes;
}

/* The drum counts all that it drops alike, but also the strokes that it begins. */
static void process(Session *session, const TaborEvent *events, uint32_t count,
                    float *const *outputs, uint32_t frames) {
  TaborStatistics before, after;
  tabor_drum_statistics(session->drum, &before);
  tabor_drum_process(session->drum, events, count, outputs, frames);
  tabor_drum_statistics(session->drum, &after);
  const uint64_t begun = after.strikes - before.strikes;
  const uint64_t dropped = after.dropped_events - before.dropped_events;
  const uint64_t strokes = count_strokes(events, count) - begun;
  session->drops.strokes += strokes;
  session->drops.others += dropped - strokes;
}

/* ---- what the song does beside strokes ---- */

/* The same microphones on the new preset. */
static void attend(Session *session) {
  const RenderRequest *const request = session->request;
  const TaborDrumDef *const def = tabor_model_definition(tabor_drum_model(session->drum));
  for (uint32_t i = 0; i < request->channels; i++) {
    session->mics[i] = drum_same_mic(&request->def, request->mics[i], def);
  }
}

static void destroy_left(Session *session) {
  TaborDrum *drum;
  while ((drum = leaving_take(&session->leaving)) != NULL) tabor_drum_destroy(drum);
}

static Outcome change_drum(Session *session, uint32_t preset) {
  TaborDrum *drum;
  const Outcome outcome = preset_drums_create(&session->presets, preset, &drum);
  if (outcome != OUTCOME_OK) return outcome;
  tally_keep(&session->tally, session->drum);
  tabor_drum_destroy(
    leaving_add(&session->leaving, session->drum, session->mics, session->request->channels));
  session->drum = drum;
  silencer_forget(&session->silencer);
  attend(session);
  return OUTCOME_OK;
}

static Outcome act(Session *session, const MidiAction *action) {
  switch (action->type) {
  case MIDI_ACTION_EVENT: break; /* these are among the strokes */
  case MIDI_ACTION_GAIN: fader_set(&session->expression, action->value); break;
  case MIDI_ACTION_SILENCE: silencer_wish(&session->silencer); break;
  case MIDI_ACTION_PRESET: return change_drum(session, action->preset);
  }
  return OUTCOME_OK;
}

static const MidiSongItem *next_item(const Session *session) {
  const MidiSong *const song = &session->request->song;
  return session->next_item < song->count ? &song->items[session->next_item] : NULL;
}

/* What has waited for the end of a silence acts in its order: strokes are for the drum of their time. */
static void strike_before(Session *session, const MidiSongItem *item) {
  TaborEvent *const events = session->request->strokes.events + session->next_event;
  if (item->action.type == MIDI_ACTION_GAIN) return;
  const uint32_t count = take_events(session, item->frame);
  if (count > 0) process(session, events, count, NULL, 0);
}

static Outcome act_due(Session *session) {
  const MidiSongItem *item;
  Outcome outcome = OUTCOME_OK;
  while (outcome == OUTCOME_OK && !silencer_waits(&session->silencer) &&
         (item = next_item(session)) && item->frame <= session->position) {
    session->next_item++;
    strike_before(session, item);
    outcome = act(session, &item->action);
  }
  return outcome;
}

static void step_silencer(Session *session) {
  if (silencer_is_due(&session->silencer)) {
    tally_keep(&session->tally, session->drum);
    leaving_cut(&session->leaving);
    destroy_left(session);
  }
  silencer_step(&session->silencer, session->drum);
}

/* How many of *frames frames there are until the song does something. */
static Outcome begin_piece(Session *session, uint32_t *frames) {
  step_silencer(session);
  const Outcome outcome = act_due(session);
  const MidiSongItem *const item = next_item(session);
  uint32_t left = *frames;
  if (item) left = item->frame - session->position;
  if (silencer_waits(&session->silencer) || left > *frames) left = *frames;
  *frames = silencer_limit(&session->silencer, left);
  return outcome;
}

/* ---- sound ---- */

/* This thread's: others may play other drums. */
static double processor_time(void) { return stopwatch_seconds(CLOCK_THREAD_CPUTIME_ID); }

/* What each channel hears of all drums, from frame @p at of the block on. */
static void gather(Session *session, uint32_t at, uint32_t frames) {
  const uint32_t channels = session->request->channels;
  const float *samples[MOST_CHANNELS];
  double *sound[MOST_CHANNELS];
  for (uint32_t channel = 0; channel < channels; channel++) {
    samples[channel] = session->planar[session->mics[channel]] + at;
    sound[channel] = session->sound[channel] + at;
  }
  leaving_join(&session->leaving, samples, sound, channels, frames);
  destroy_left(session);
}

/* Frames from @p at on in the block. */
static void interleave(Session *session, uint32_t at, uint32_t frames) {
  const RenderRequest *const request = session->request;
  const uint32_t channels = request->channels;
  for (uint32_t frame = at; frame < at + frames; frame++) {
    const double gain =
      request->gain * fader_next(&session->expression) * silencer_next(&session->silencer);
    for (uint32_t channel = 0; channel < channels; channel++) {
      const double sample = gain * session->sound[channel][frame];
      session->interleaved[frame * channels + channel] = sample;
      session->peak = fmax(session->peak, fabs(sample));
    }
  }
}

static void play_piece(Session *session, uint32_t at, uint32_t frames) {
  const RenderRequest *const request = session->request;
  float *outputs[TABOR_MAX_MICS] = {NULL}; /* for microphones that nobody hears */
  for (uint32_t channel = 0; channel < request->channels; channel++) {
    const uint32_t mic = session->mics[channel];
    outputs[mic] = session->planar[mic] + at;
  }
  TaborEvent *const events = request->strokes.events + session->next_event;
  const uint32_t count = take_events(session, session->position + frames);
  const double start = processor_time();
  process(session, events, count, outputs, frames);
  gather(session, at, frames);
  session->computing += processor_time() - start;
  session->position += frames;
  interleave(session, at, frames);
}

/* Frames @p at to @p end of the block. */
static Outcome play(Session *session, uint32_t at, uint32_t end) {
  Outcome outcome = OUTCOME_OK;
  while (outcome == OUTCOME_OK && at < end) {
    uint32_t frames = end - at;
    outcome = begin_piece(session, &frames);
    if (outcome == OUTCOME_OK) play_piece(session, at, frames);
    at += frames;
  }
  return outcome;
}

Outcome session_play(Session *session, uint32_t frames) { return play(session, 0, frames); }

Outcome session_play_traced(Session *session, uint32_t frames, TraceFile *trace) {
  const double rate = session->request->model.sample_rate;
  Outcome outcome = OUTCOME_OK;
  for (uint32_t frame = 0; outcome == OUTCOME_OK && frame < frames; frame++) {
    outcome = play(session, frame, frame + 1);
    if (outcome == OUTCOME_OK) {
      outcome = trace_file_row(trace, session->position / rate, session->drum);
    }
  }
  return outcome;
}

void session_free(Session *session) {
  leaving_cut(&session->leaving);
  destroy_left(session);
  tabor_drum_destroy(session->drum);
  session->drum = NULL;
  preset_drums_free(&session->presets);
}
