/* SPDX-License-Identifier: MIT */
#include "plugin/kit_plugin_player.h"

#include <math.h>
#include <string.h>

static const double FADE = 0.03; /* [s] of a kit that leaves */

/* ---- beginning and end ---------------------------------------------------------------------- */

void kit_plugin_player_begin(KitPluginPlayer *player, KitWorker *worker) {
  memset(player, 0, sizeof *player);
  player->worker = worker;
  player->fade_frames = (uint32_t)ceil(FADE * worker->builder.options.sample_rate);
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) player->values[i] = (float)kit_knobs[i].fallback;
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) player->midi_gain[i] = 1;
  player->humanizer = humanizer(kit_knobs[KIT_KNOB_HUMANIZE].fallback, HUMANIZE_SEED);
}

void kit_plugin_player_end(KitPluginPlayer *player) {
  kit_voice_destroy(player->now);
  kit_voice_destroy(player->leaving);
  player->now = player->leaving = NULL;
}

/* ---- events --------------------------------------------------------------------------------- */

/* Adds an event at a frame of the block. */
static void add_event(KitPluginPlayer *player, TaborKitEvent event, uint32_t frame) REALTIME;
static void add_event(KitPluginPlayer *player, TaborKitEvent event, uint32_t frame) {
  if (player->event_count == KIT_PLUGIN_EVENTS) kit_plugin_player_play(player, frame);
  if (player->event_count == KIT_PLUGIN_EVENTS) return; /* all are of this frame */
  event.event.frame = frame;
  player->events[player->event_count++] = event;
  if (event.event.type != TABOR_EVENT_STRIKE || event.drum >= TABOR_KIT_DRUMS) return;
  player->struck[event.drum] = fmaxf(player->struck[event.drum], (float)event.event.velocity);
}

static double gain_of(const KitPluginPlayer *player, uint32_t drum) REALTIME;
static double gain_of(const KitPluginPlayer *player, uint32_t drum) {
  const double all = knob_factor(&kit_knobs[KIT_KNOB_GAIN], player->values[KIT_KNOB_GAIN]);
  const KitKnobId level = (KitKnobId)(KIT_KNOB_LEVEL + drum);
  const double own =
    drum < KIT_KNOB_DRUMS ? knob_factor(&kit_knobs[level], player->values[level]) : 1;
  return all * own * player->midi_gain[drum];
}

static void set_gain(KitPluginPlayer *player, uint32_t drum, uint32_t frame) REALTIME;
static void set_gain(KitPluginPlayer *player, uint32_t drum, uint32_t frame) {
  const TaborEvent gain = {.type = TABOR_EVENT_GAIN, .value = gain_of(player, drum)};
  add_event(player, (TaborKitEvent){.drum = drum, .event = gain}, frame);
}

static void set_gains(KitPluginPlayer *player) REALTIME;
static void set_gains(KitPluginPlayer *player) {
  for (uint32_t i = 0; player->now && i < player->now->drum_count; i++) {
    set_gain(player, i, player->at);
  }
}

static void add_value(KitPluginPlayer *player, uint32_t parameter, double value) REALTIME;
static void add_value(KitPluginPlayer *player, uint32_t parameter, double value) {
  const TaborEvent event = {.type = TABOR_EVENT_PARAMETER, .parameter = parameter, .value = value};
  add_event(player, (TaborKitEvent){.drum = TABOR_KIT_MIX, .event = event}, player->at);
}

static void set_value(KitPluginPlayer *player, KitKnobId id) REALTIME;
static void set_value(KitPluginPlayer *player, KitKnobId id) {
  const KitVoice *const voice = player->now;
  const bool is_coupling = id == KIT_KNOB_COUPLING;
  if (!voice || (is_coupling && !tabor_kit_definition(voice->kit)->coupled)) return;
  const double value = is_coupling
                         ? kit_knob_beside(id, player->values[id], voice->coupling, -60)
                         : kit_knob_beside(id, player->values[id], voice->overheads, KIT_KNOB_NONE);
  add_value(player, is_coupling ? TABOR_KIT_COUPLING : TABOR_KIT_OVERHEADS, value);
}

/* The gain is for all outputs, and so for the sounds of notes, too. */
static void set_samples(KitPluginPlayer *player) REALTIME;
static void set_samples(KitPluginPlayer *player) {
  const float gain = player->values[KIT_KNOB_GAIN];
  add_value(player, TABOR_KIT_SAMPLES, kit_knob_beside(KIT_KNOB_GAIN, gain, 0, KIT_KNOB_NONE));
}

/* A new kit's gains are 1, its values its own. */
static void set_first_gains(KitPluginPlayer *player) REALTIME;
static void set_first_gains(KitPluginPlayer *player) {
  for (uint32_t i = 0; i < player->now->drum_count; i++) {
    if (gain_of(player, i) != 1) set_gain(player, i, player->at);
  }
  if (player->values[KIT_KNOB_GAIN] != 0) set_samples(player);
  if (player->values[KIT_KNOB_COUPLING] != 0) set_value(player, KIT_KNOB_COUPLING);
  if (player->values[KIT_KNOB_OVERHEADS] != 0) set_value(player, KIT_KNOB_OVERHEADS);
}

static void set_response(KitPluginPlayer *player) REALTIME;
static void set_response(KitPluginPlayer *player) {
  for (uint32_t i = 0; player->now && i < player->now->drum_count; i++) {
    MidiResponse *const response = &player->now->midi.maps[i].response;
    response->curve = (MidiCurve)player->values[KIT_KNOB_VELOCITY_CURVE];
    response->range = (MidiRange)player->values[KIT_KNOB_VELOCITY_RANGE];
  }
}

void kit_plugin_player_turn(KitPluginPlayer *player, KitKnobId id, float value) {
  if (player->values[id] == value) return;
  player->values[id] = value;
  if (kit_knobs[id].kind != KNOB_SETTING) return;
  if (id == KIT_KNOB_HUMANIZE) {
    player->humanizer.amount = knob_decimal(value);
  } else if (id == KIT_KNOB_VELOCITY_CURVE || id == KIT_KNOB_VELOCITY_RANGE) {
    set_response(player);
  } else if (id == KIT_KNOB_COUPLING || id == KIT_KNOB_OVERHEADS) {
    set_value(player, id);
  } else if (id == KIT_KNOB_GAIN) {
    set_gains(player);
    if (player->now) set_samples(player);
  } else if (player->now && id - KIT_KNOB_LEVEL < player->now->drum_count) {
    set_gain(player, id - KIT_KNOB_LEVEL, player->at);
  }
}

void kit_plugin_player_take(KitPluginPlayer *player, const MidiMessage *message, uint32_t frame) {
  TaborKitEvent events[KIT_MIDI_MOST_EVENTS];
  if (!player->now) return;
  KitMidi *const midi = &player->now->midi;
  const uint32_t count = kit_midi_take(midi, message, events);
  for (uint32_t i = 0; i < count; i++) {
    kit_midi_humanize(midi, &player->humanizer, &events[i]);
    if (events[i].event.type == TABOR_EVENT_GAIN) {
      player->midi_gain[events[i].drum] = events[i].event.value;
      set_gain(player, events[i].drum, frame);
    } else {
      add_event(player, events[i], frame);
    }
  }
}

void kit_plugin_player_strike(KitPluginPlayer *player, const WindowStroke *stroke) {
  if (!player->now || stroke->drum >= player->now->drum_count) return;
  const MidiBinding *const drum = &player->now->midi.drums[stroke->drum].binding;
  const bool is_placed = stroke->radius >= 0;
  const TaborEvent event = {.type = TABOR_EVENT_STRIKE,
                            .striker = drum->striker,
                            .velocity = stroke->velocity,
                            .radius = is_placed ? stroke->radius * drum->head_radius : drum->radius,
                            .angle = is_placed ? stroke->angle : drum->angle};
  add_event(player, (TaborKitEvent){.drum = stroke->drum, .event = event}, player->at);
}

void kit_plugin_player_struck(KitPluginPlayer *player, float struck[TABOR_KIT_DRUMS]) {
  memcpy(struck, player->struck, sizeof player->struck);
  memset(player->struck, 0, sizeof player->struck);
}

void kit_plugin_player_choke(KitPluginPlayer *player, int key, uint32_t frame) {
  TaborKitEvent silence = {.drum = TABOR_KIT_ALL, .event = {.type = TABOR_EVENT_SILENCE}};
  if (!player->now) return;
  if (key >= 0) {
    silence.drum = kit_midi_address(&player->now->midi, (uint8_t)key);
    if (silence.drum == KIT_MIDI_NOWHERE) return;
  }
  add_event(player, silence, frame);
}

/* ---- kits that come and go ------------------------------------------------------------------ */

static bool has_left(const KitPluginPlayer *player) REALTIME;
static bool has_left(const KitPluginPlayer *player) {
  return player->rings ? tabor_kit_is_silent(player->leaving->kit) : player->fade == 0;
}

/* Until the worker has taken the one before, it is kept. */
static void retire(KitPluginPlayer *player) REALTIME;
static void retire(KitPluginPlayer *player) {
  KitVoice *expected = NULL;
  if (!player->leaving || !has_left(player)) return;
  if (atomic_compare_exchange_strong(&player->worker->retired, &expected, player->leaving)) {
    player->leaving = NULL;
  }
}

/* Two kits are heard at once: one that rings out makes way for a third. */
static void end_ringing(KitPluginPlayer *player) REALTIME;
static void end_ringing(KitPluginPlayer *player) {
  if (player->rings) player->fade = player->fade_frames;
  player->rings = false;
}

void kit_plugin_player_end_leaving(KitPluginPlayer *player) {
  player->rings = false;
  player->fade = 0;
}

static void change_to(KitPluginPlayer *player, KitVoice *next) REALTIME;
static void change_to(KitPluginPlayer *player, KitVoice *next) {
  player->leaving = player->now;
  player->rings = next->follows;
  player->fade = player->now && !next->follows ? player->fade_frames : 0;
  player->now = next;
  memcpy(player->playing, player->asked, sizeof player->playing);
  player->own_playing = player->own_asked;
  if (next->follows) {
    kit_midi_follow(&next->midi, &player->leaving->midi);
    tabor_kit_take_over(next->kit, player->leaving->kit);
  }
  set_response(player);
  set_first_gains(player);
}

void kit_plugin_player_receive(KitPluginPlayer *player) {
  retire(player);
  KitWorker *const worker = player->worker;
  if (!builder_is(&worker->builder, BUILDER_ANSWERED)) return;
  if (player->leaving) {
    end_ringing(player);
    return;
  }
  if (worker->answer) {
    change_to(player, worker->answer);
    worker->answer = NULL;
  } else if (!worker->failed) {
    player->has_asked = false; /* it was cancelled: ask again */
  }
  builder_accept(&worker->builder);
}

void kit_plugin_player_export(KitPluginPlayer *player, bool exports) { player->exports = exports; }

/* What a knob asks for, in real time of a quality that plays in real time. */
static float wish(const KitPluginPlayer *player, uint32_t id) REALTIME;
static float wish(const KitPluginPlayer *player, uint32_t id) {
  const float most = PLUGIN_LIVE_QUALITY - TABOR_QUALITY_DRAFT, value = player->values[id];
  return id == KIT_KNOB_QUALITY && !player->exports && value > most ? most : value;
}

/* True if the knobs want another kit than the one that was built for `values` and a version of the
 * user's own. If `drums`, only what changes the drums counts. */
static bool is_another(const KitPluginPlayer *player, const float *values, unsigned own,
                       bool drums) REALTIME;
static bool is_another(const KitPluginPlayer *player, const float *values, unsigned own,
                       bool drums) {
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) {
    const KnobKind kind = kit_knobs[i].kind;
    const bool counts = kind == KNOB_REPLACE || (kind == KNOB_REBUILD && !drums);
    if (counts && wish(player, i) != values[i]) return true;
  }
  return kit_knob_is_own(player->values[KIT_KNOB_KIT]) &&
         own != own_kit_version(player->worker->own);
}

static bool is_wanted(const KitPluginPlayer *player) REALTIME;
static bool is_wanted(const KitPluginPlayer *player) {
  return player->has_asked && !is_another(player, player->asked, player->own_asked, false);
}

/* A kit that is being built is dropped for another kit or quality. One of another tuning or room is
 * built to its end, since the next one would be dropped as well while a knob moves. */
static bool is_outdated(const KitPluginPlayer *player) REALTIME;
static bool is_outdated(const KitPluginPlayer *player) {
  return wish(player, KIT_KNOB_QUALITY) != player->asked[KIT_KNOB_QUALITY] ||
         is_another(player, player->asked, player->own_asked, true);
}

static bool has_drums(const KitPluginPlayer *player) REALTIME;
static bool has_drums(const KitPluginPlayer *player) {
  return player->now && !is_another(player, player->playing, player->own_playing, true);
}

static void ask(KitPluginPlayer *player) REALTIME;
static void ask(KitPluginPlayer *player) {
  KitWorker *const worker = player->worker;
  if (is_wanted(player)) return;
  if (!builder_is(&worker->builder, BUILDER_IDLE)) {
    if (is_outdated(player)) builder_outdate(&worker->builder);
    return;
  }
  worker->playing = has_drums(player) ? player->now : NULL;
  for (uint32_t i = 0; i < KIT_KNOB_COUNT; i++) player->asked[i] = wish(player, i);
  player->own_asked = own_kit_version(worker->own);
  memcpy(worker->wanted, player->asked, sizeof worker->wanted);
  worker->is_held = player->asked[KIT_KNOB_QUALITY] != player->values[KIT_KNOB_QUALITY];
  player->has_asked = true;
  builder_ask(&worker->builder);
}

bool kit_plugin_player_ask(KitPluginPlayer *player) {
  KitWorker *const worker = player->worker;
  ask(player);
  return builder_is(&worker->builder, BUILDER_ASKED) || atomic_load(&worker->retired) != NULL;
}

bool kit_plugin_player_is_settled(const KitPluginPlayer *player) {
  return is_wanted(player) && builder_is(&player->worker->builder, BUILDER_IDLE);
}

/* ---- sound ---------------------------------------------------------------------------------- */

static float *channel_at(const KitPluginPlayer *player, uint32_t channel, uint32_t at) REALTIME;
static float *channel_at(const KitPluginPlayer *player, uint32_t channel, uint32_t at) {
  float *const begin = player->buffers->channels[channel];
  return begin ? begin + at : NULL;
}

static TaborKitOutputs outputs_at(const KitPluginPlayer *player, uint32_t at) REALTIME;
static TaborKitOutputs outputs_at(const KitPluginPlayer *player, uint32_t at) {
  TaborKitOutputs outputs = {0};
  for (uint32_t side = 0; side < 2; side++) {
    outputs.stereo[side] = channel_at(player, side, at);
    for (uint32_t i = 0; i < KIT_KNOB_DRUMS; i++)
      outputs.drum[i][side] = channel_at(player, 2 + 2 * i + side, at);
  }
  return outputs;
}

/* A kit fills the outputs of its own drums alone. */
static void clear(const TaborKitOutputs *outputs, uint32_t from, uint32_t frames) REALTIME;
static void clear(const TaborKitOutputs *outputs, uint32_t from, uint32_t frames) {
  for (uint32_t i = from; i < KIT_KNOB_DRUMS; i++) {
    for (uint32_t side = 0; side < 2; side++) {
      if (outputs->drum[i][side]) memset(outputs->drum[i][side], 0, frames * sizeof(float));
    }
  }
}

static void clear_all(const TaborKitOutputs *outputs, uint32_t frames) REALTIME;
static void clear_all(const TaborKitOutputs *outputs, uint32_t frames) {
  for (uint32_t side = 0; side < 2; side++) {
    if (outputs->stereo[side]) memset(outputs->stereo[side], 0, frames * sizeof(float));
  }
  clear(outputs, 0, frames);
}

static void add_faded(const KitPluginPlayer *player, const float *from, float *to,
                      uint32_t frames) REALTIME;
static void add_faded(const KitPluginPlayer *player, const float *from, float *to,
                      uint32_t frames) {
  if (!to) return;
  for (uint32_t i = 0; i < frames && (player->rings || i < player->fade); i++) {
    to[i] +=
      player->rings ? from[i] : from[i] * ((float)(player->fade - i) / (float)player->fade_frames);
  }
}

/* The kit that leaves, into the piece that the other one has filled. */
static void play_leaving(KitPluginPlayer *player, const TaborKitOutputs *outputs,
                         uint32_t frames) REALTIME;
static void play_leaving(KitPluginPlayer *player, const TaborKitOutputs *outputs, uint32_t frames) {
  TaborKitOutputs own = {.stereo = {player->sound[0], player->sound[1]}};
  for (uint32_t i = 0; i < KIT_KNOB_DRUMS && i < player->leaving->drum_count; i++) {
    own.drum[i][0] = player->sound[2 + 2 * i];
    own.drum[i][1] = player->sound[3 + 2 * i];
  }
  tabor_kit_process(player->leaving->kit, NULL, 0, &own, frames);
  for (uint32_t side = 0; side < 2; side++) {
    add_faded(player, own.stereo[side], outputs->stereo[side], frames);
    for (uint32_t i = 0; i < KIT_KNOB_DRUMS; i++) {
      if (own.drum[i][side]) add_faded(player, own.drum[i][side], outputs->drum[i][side], frames);
    }
  }
  player->fade -= frames < player->fade ? frames : player->fade;
}

/* Events before frame `end`, counted from the frame where the piece begins. */
static uint32_t take_events(KitPluginPlayer *player, uint32_t first, uint32_t end) REALTIME;
static uint32_t take_events(KitPluginPlayer *player, uint32_t first, uint32_t end) {
  uint32_t next = first;
  while (next < player->event_count && player->events[next].event.frame < end) {
    TaborEvent *const event = &player->events[next++].event;
    event->frame = event->frame > player->at ? event->frame - player->at : 0;
  }
  return next - first;
}

/* `next` is the first event that was not played yet; returns how many were. */
static uint32_t play_piece(KitPluginPlayer *player, uint32_t next, uint32_t frames) REALTIME;
static uint32_t play_piece(KitPluginPlayer *player, uint32_t next, uint32_t frames) {
  const TaborKitOutputs outputs = outputs_at(player, player->at);
  const uint32_t count = take_events(player, next, player->at + frames);
  if (player->now) {
    tabor_kit_process(player->now->kit, player->events + next, count, &outputs, frames);
    clear(&outputs, player->now->drum_count, frames);
  } else {
    clear_all(&outputs, frames);
  }
  if (player->leaving && (player->rings || player->fade > 0))
    play_leaving(player, &outputs, frames);
  player->at += frames;
  return count;
}

void kit_plugin_player_begin_block(KitPluginPlayer *player, const PluginBuffers *buffers) {
  player->buffers = buffers;
  player->at = 0;
}

/* Events that stay, at the end of a block, act at the beginning of the next. */
void kit_plugin_player_play(KitPluginPlayer *player, uint32_t end) {
  uint32_t next = 0;
  while (player->at < end) {
    const uint32_t left = end - player->at;
    next += play_piece(player, next, left < KIT_PLUGIN_PIECE ? left : KIT_PLUGIN_PIECE);
  }
  player->event_count -= next;
  memmove(player->events, player->events + next, player->event_count * sizeof *player->events);
}

bool kit_plugin_player_is_silent(const KitPluginPlayer *player) {
  return !player->leaving && player->event_count == 0 &&
         (!player->now || tabor_kit_is_silent(player->now->kit));
}

/* The kit's gains are 1 again, and knobs set them; controllers begin anew. */
void kit_plugin_player_rest(KitPluginPlayer *player) {
  kit_plugin_player_end_leaving(player);
  player->at = player->event_count = 0;
  player->humanizer.state = HUMANIZE_SEED;
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) player->midi_gain[i] = 1;
  if (!player->now) return;
  tabor_kit_reset(player->now->kit);
  kit_midi_rest(&player->now->midi);
  set_first_gains(player);
}
