/* SPDX-License-Identifier: MIT */
#include "render/offline_player.h"

#include <math.h>

#include "base/stopwatch.h"
#include "drums/drum_args.h"
#include "strokes/fit_striker.h"

/* Microphone of a channel on the request's own drum. */
static uint32_t asked_mic(const OfflinePlayer *player, uint32_t channel) {
  const uint32_t channels = player->request->channels;
  return channel < channels ? player->request->mics[channel]
                            : player->room.feed[channel - channels];
}

/* The request's channels, then those that only the room hears. */
static Outcome open_room(OfflinePlayer *player) {
  const RenderRequest *const request = player->request;
  TaborRoom *room;
  const Outcome outcome = room_create(&request->def, request->model.sample_rate, &room);
  room_mix_begin(&player->room, room, request->mics, request->channels);
  player->channels = request->channels + room_mix_extra(&request->def);
  for (uint32_t i = 0; i < player->channels; i++) player->mics[i] = asked_mic(player, i);
  return outcome;
}

Outcome offline_player_open(OfflinePlayer *player, RenderRequest *request) {
  const double rate = request->model.sample_rate;
  player->request = request;
  player->next_event = player->next_item = 0;
  player->position = 0;
  player->peak = player->computing = 0;
  player->drops = (OfflineDrops){0};
  player->expression = fader_at(1, rate);
  player->silencer = silencer_begin(rate);
  player->presets = (PresetDrums){.options = &request->model};
  player->tally = (Tally){0};
  leaving_begin(&player->leaving, rate);
  const Outcome outcome = open_room(player);
  if (outcome != OUTCOME_OK) return outcome;
  return drum_create(&request->def, &request->model, &player->drum);
}

/* ---- strokes ---- */

/* The strokes before frame @p end; those that waited act at the first. */
static uint32_t take_events(OfflinePlayer *player, uint32_t end) {
  const Strokes *const strokes = &player->request->strokes;
  const TaborDrumDef *const def = tabor_model_definition(tabor_drum_model(player->drum));
  TaborEvent *const events = strokes->events + player->next_event;
  const uint32_t position = player->position;
  uint32_t count = 0;
  while (!silencer_waits(&player->silencer) && player->next_event < strokes->count &&
         events[count].frame < end) {
    TaborEvent *const event = &events[count]; /* from here on counted within the piece */
    event->frame = event->frame > position ? event->frame - position : 0;
    fit_striker(event, def->striker_count);
    silencer_remember(&player->silencer, event);
    player->next_event++;
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
static void process(OfflinePlayer *player, const TaborEvent *events, uint32_t count,
                    float *const *outputs, uint32_t frames) {
  TaborStatistics before, after;
  tabor_drum_statistics(player->drum, &before);
  tabor_drum_process(player->drum, events, count, outputs, frames);
  tabor_drum_statistics(player->drum, &after);
  const uint64_t begun = after.strikes - before.strikes;
  const uint64_t dropped = after.dropped_events - before.dropped_events;
  const uint64_t strokes = count_strokes(events, count) - begun;
  player->drops.strokes += strokes;
  player->drops.others += dropped - strokes;
}

/* ---- what the song does beside strokes ---- */

/* The same microphones on the new preset. */
static void attend(OfflinePlayer *player) {
  const RenderRequest *const request = player->request;
  const TaborDrumDef *const def = tabor_model_definition(tabor_drum_model(player->drum));
  for (uint32_t i = 0; i < player->channels; i++) {
    player->mics[i] = drum_same_mic(&request->def, asked_mic(player, i), def);
  }
}

static void destroy_left(OfflinePlayer *player) {
  TaborDrum *drum;
  while ((drum = leaving_take(&player->leaving)) != NULL) tabor_drum_destroy(drum);
}

static Outcome change_drum(OfflinePlayer *player, uint32_t preset) {
  TaborDrum *drum;
  const Outcome outcome = preset_drums_create(&player->presets, preset, &drum);
  if (outcome != OUTCOME_OK) return outcome;
  tally_keep(&player->tally, player->drum);
  tabor_drum_destroy(leaving_add(&player->leaving, player->drum, player->mics, player->channels));
  player->drum = drum;
  silencer_forget(&player->silencer);
  attend(player);
  return OUTCOME_OK;
}

static Outcome act(OfflinePlayer *player, const MidiAction *action) {
  switch (action->type) {
  case MIDI_ACTION_EVENT: break; /* these are among the strokes */
  case MIDI_ACTION_GAIN: fader_set(&player->expression, action->value); break;
  case MIDI_ACTION_SILENCE: silencer_wish(&player->silencer); break;
  case MIDI_ACTION_PRESET: return change_drum(player, action->preset);
  }
  return OUTCOME_OK;
}

static const MidiSongItem *next_item(const OfflinePlayer *player) {
  const MidiSong *const song = &player->request->song;
  return player->next_item < song->count ? &song->items[player->next_item] : NULL;
}

/* What has waited for the end of a silence acts in its order: strokes are for the drum of their time. */
static void strike_before(OfflinePlayer *player, const MidiSongItem *item) {
  TaborEvent *const events = player->request->strokes.events + player->next_event;
  if (item->action.type == MIDI_ACTION_GAIN) return;
  const uint32_t count = take_events(player, item->frame);
  if (count > 0) process(player, events, count, NULL, 0);
}

static Outcome act_due(OfflinePlayer *player) {
  const MidiSongItem *item;
  Outcome outcome = OUTCOME_OK;
  while (outcome == OUTCOME_OK && !silencer_waits(&player->silencer) &&
         (item = next_item(player)) && item->frame <= player->position) {
    player->next_item++;
    strike_before(player, item);
    outcome = act(player, &item->action);
  }
  return outcome;
}

static void step_silencer(OfflinePlayer *player) {
  if (silencer_is_due(&player->silencer)) {
    tally_keep(&player->tally, player->drum);
    leaving_cut(&player->leaving);
    destroy_left(player);
    room_mix_cut(&player->room);
  }
  silencer_step(&player->silencer, player->drum);
}

/* How many of *frames frames there are until the song does something. */
static Outcome begin_piece(OfflinePlayer *player, uint32_t *frames) {
  step_silencer(player);
  const Outcome outcome = act_due(player);
  const MidiSongItem *const item = next_item(player);
  uint32_t left = *frames;
  if (item) left = item->frame - player->position;
  if (silencer_waits(&player->silencer) || left > *frames) left = *frames;
  *frames = silencer_limit(&player->silencer, left);
  return outcome;
}

/* ---- sound ---- */

/* This thread's: others may play other drums. */
static double processor_time(void) { return stopwatch_seconds(CLOCK_THREAD_CPUTIME_ID); }

/* What each channel hears of all drums and of the room, from frame @p at of the block on. */
static void gather(OfflinePlayer *player, uint32_t at, uint32_t frames) {
  const uint32_t channels = player->channels;
  const float *samples[MOST_CHANNELS];
  double *sound[MOST_CHANNELS];
  for (uint32_t channel = 0; channel < channels; channel++) {
    samples[channel] = player->planar[player->mics[channel]] + at;
    sound[channel] = player->sound[channel] + at;
  }
  leaving_join(&player->leaving, samples, sound, channels, frames);
  destroy_left(player);
  room_mix_play(&player->room, sound, frames);
}

/* Frames from @p at on in the block. */
static void interleave(OfflinePlayer *player, uint32_t at, uint32_t frames) {
  const RenderRequest *const request = player->request;
  const uint32_t channels = request->channels;
  for (uint32_t frame = at; frame < at + frames; frame++) {
    const double gain =
      request->gain * fader_next(&player->expression) * silencer_next(&player->silencer);
    for (uint32_t channel = 0; channel < channels; channel++) {
      const double sample = gain * player->sound[channel][frame];
      player->interleaved[frame * channels + channel] = sample;
      player->peak = fmax(player->peak, fabs(sample));
    }
  }
}

static void play_piece(OfflinePlayer *player, uint32_t at, uint32_t frames) {
  const RenderRequest *const request = player->request;
  float *outputs[TABOR_MAX_MICS] = {NULL}; /* for microphones that nobody hears */
  for (uint32_t channel = 0; channel < player->channels; channel++) {
    const uint32_t mic = player->mics[channel];
    outputs[mic] = player->planar[mic] + at;
  }
  TaborEvent *const events = request->strokes.events + player->next_event;
  const uint32_t count = take_events(player, player->position + frames);
  const double start = processor_time();
  process(player, events, count, outputs, frames);
  gather(player, at, frames);
  player->computing += processor_time() - start;
  player->position += frames;
  interleave(player, at, frames);
}

/* Frames @p at to @p end of the block. */
static Outcome play(OfflinePlayer *player, uint32_t at, uint32_t end) {
  Outcome outcome = OUTCOME_OK;
  while (outcome == OUTCOME_OK && at < end) {
    uint32_t frames = end - at;
    outcome = begin_piece(player, &frames);
    if (outcome == OUTCOME_OK) play_piece(player, at, frames);
    at += frames;
  }
  return outcome;
}

Outcome offline_player_play(OfflinePlayer *player, uint32_t frames) {
  return play(player, 0, frames);
}

Outcome offline_player_play_traced(OfflinePlayer *player, uint32_t frames, TraceFile *trace) {
  const double rate = player->request->model.sample_rate;
  Outcome outcome = OUTCOME_OK;
  for (uint32_t frame = 0; outcome == OUTCOME_OK && frame < frames; frame++) {
    outcome = play(player, frame, frame + 1);
    if (outcome == OUTCOME_OK) {
      outcome = trace_file_row(trace, player->position / rate, player->drum);
    }
  }
  return outcome;
}

void offline_player_free(OfflinePlayer *player) {
  leaving_cut(&player->leaving);
  destroy_left(player);
  tabor_drum_destroy(player->drum);
  player->drum = NULL;
  tabor_room_destroy(player->room.room);
  player->room.room = NULL;
  preset_drums_free(&player->presets);
}
