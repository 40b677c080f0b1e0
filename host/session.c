/* SPDX-License-Identifier: MIT */
#include "session.h"

#include <math.h>

#include "drum_source.h"
#include "stopwatch.h"

Outcome session_open(Session *session, RenderRequest *request) {
  const double rate = request->model.sample_rate;
  session->request = request;
  session->next_event = session->next_item = 0;
  session->position = 0;
  session->peak = session->computing = 0;
  session->drops = (SessionDrops){0};
  session->expression = fader_at(1, rate);
  session->silencer = silencer_begin(rate);
  for (uint32_t i = 0; i < request->channels; i++) session->mics[i] = request->mics[i];
  const Outcome outcome = preset_swaps_begin(&session->swaps, &request->def, &request->model);
  session->drum = session->swaps.drum;
  return outcome;
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

static Outcome act(Session *session, const MidiAction *action) {
  Outcome outcome = OUTCOME_OK;
  switch (action->type) {
  case MIDI_ACTION_EVENT: break; /* these are among the strokes */
  case MIDI_ACTION_GAIN: fader_set(&session->expression, action->value); break;
  case MIDI_ACTION_SILENCE: silencer_wish(&session->silencer); break;
  case MIDI_ACTION_PRESET:
    outcome = preset_swaps_act(&session->swaps, action->preset);
    silencer_forget(&session->silencer);
    attend(session);
    break;
  }
  return outcome;
}

static const MidiSongItem *next_item(const Session *session) {
  const MidiSong *const song = &session->request->song;
  return session->next_item < song->count ? &song->items[session->next_item] : NULL;
}

static uint32_t item_frame(const Session *session, const MidiSongItem *item) {
  return midi_song_frame(item, session->request->model.sample_rate);
}

static Outcome act_due(Session *session) {
  const MidiSongItem *item;
  Outcome outcome = OUTCOME_OK;
  while (outcome == OUTCOME_OK && !silencer_waits(&session->silencer) &&
         (item = next_item(session)) && item_frame(session, item) <= session->position) {
    session->next_item++;
    outcome = act(session, &item->action);
  }
  return outcome;
}

/* How many of *frames frames there are until the song does something. */
static Outcome begin_piece(Session *session, uint32_t *frames) {
  silencer_step(&session->silencer, session->drum);
  const Outcome outcome = act_due(session);
  const MidiSongItem *const item = next_item(session);
  uint32_t left = *frames;
  if (item) left = item_frame(session, item) - session->position;
  if (silencer_waits(&session->silencer) || left > *frames) left = *frames;
  *frames = silencer_limit(&session->silencer, left);
  return outcome;
}

/* ---- sound ---- */

/* This thread's: others may play other drums. */
static double processor_time(void) { return stopwatch_seconds(CLOCK_THREAD_CPUTIME_ID); }

/* The strokes of the next @p frames frames; those that waited act at the first. */
static uint32_t take_events(Session *session, uint32_t frames) {
  const Strokes *const strokes = &session->request->strokes;
  TaborEvent *const events = strokes->events + session->next_event;
  const uint32_t position = session->position;
  uint32_t count = 0;
  while (!silencer_waits(&session->silencer) && session->next_event < strokes->count &&
         events[count].frame < position + frames) {
    TaborEvent *const event = &events[count]; /* from here on counted within the piece */
    event->frame = event->frame > position ? event->frame - position : 0;
    silencer_remember(&session->silencer, event);
    session->next_event++;
    count++;
  }
  return count;
}

/* Frames from @p at on in the block. */
static void interleave(Session *session, uint32_t at, uint32_t frames) {
  const RenderRequest *const request = session->request;
  const uint32_t channels = request->channels;
  for (uint32_t frame = at; frame < at + frames; frame++) {
    const double gain =
      request->gain * fader_next(&session->expression) * silencer_next(&session->silencer);
    for (uint32_t channel = 0; channel < channels; channel++) {
      const double sample = gain * (double)session->planar[session->mics[channel]][frame];
      session->interleaved[frame * channels + channel] = sample;
      session->peak = fmax(session->peak, fabs(sample));
    }
  }
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

static void play_piece(Session *session, uint32_t at, uint32_t frames) {
  const RenderRequest *const request = session->request;
  float *outputs[TABOR_MAX_MICS] = {NULL}; /* for microphones that nobody hears */
  for (uint32_t channel = 0; channel < request->channels; channel++) {
    const uint32_t mic = session->mics[channel];
    outputs[mic] = session->planar[mic] + at;
  }
  TaborEvent *const events = request->strokes.events + session->next_event;
  const uint32_t count = take_events(session, frames);
  const double start = processor_time();
  process(session, events, count, outputs, frames);
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
  session->drum = NULL;
  preset_swaps_free(&session->swaps);
}
