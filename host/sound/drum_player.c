/* SPDX-License-Identifier: MIT */
#include "sound/drum_player.h"

#include <math.h>
#include <string.h>

#include "strokes/fit_striker.h"

bool player_message_from_midi(const MidiAction *action, uint64_t frame, PlayerMessage *message) {
  *message = (PlayerMessage){.frame = frame, .value = action->value, .event = action->event};
  switch (action->type) {
  case MIDI_ACTION_EVENT: message->type = PLAYER_EVENT; return true;
  case MIDI_ACTION_GAIN: message->type = PLAYER_EXPRESSION; return true;
  case MIDI_ACTION_SILENCE:
    message->type = PLAYER_EVENT;
    message->event.type = TABOR_EVENT_SILENCE;
    return true;
  case MIDI_ACTION_PRESET: break;
  }
  return false;
}

/* ---- messages ------------------------------------------------------------------------------- */

static void add_event(DrumPlayer *player, uint32_t drum, const TaborEvent *event, uint32_t offset) {
  TaborKitEvent *const added = &player->events[player->count++];
  *added = (TaborKitEvent){.drum = drum, .event = *event};
  added->event.frame = offset;
  if (drum < TABOR_KIT_DRUMS) fit_striker(&added->event, player->strikers[drum]);
  player->strokes += added->event.type == TABOR_EVENT_STRIKE && drum < TABOR_KIT_NOTE;
}

static void add_gain(DrumPlayer *player, uint32_t offset) {
  const TaborEvent event = {.type = TABOR_EVENT_GAIN, .value = player->gain * player->expression};
  if (player->kit) {
    fader_set(&player->mix, event.value);
  } else {
    add_event(player, 0, &event, offset);
  }
}

static void change_model(DrumPlayer *player, const PlayerMessage *message, uint32_t offset) {
  add_event(player, message->drum, &message->event, offset);
  if (message->drum < TABOR_KIT_DRUMS) player->strikers[message->drum] = message->strikers;
}

static void add(DrumPlayer *player, const PlayerMessage *message, uint32_t offset) {
  switch (message->type) {
  case PLAYER_EVENT: add_event(player, message->drum, &message->event, offset); break;
  case PLAYER_MODEL: change_model(player, message, offset); break;
  case PLAYER_GAIN:
    player->gain = message->value;
    add_gain(player, offset);
    break;
  case PLAYER_EXPRESSION:
    player->expression = message->value;
    add_gain(player, offset);
    break;
  default: break;
  }
}

/* Never before an event that has been taken already. */
static uint32_t offset_of(const DrumPlayer *player, const PlayerMessage *message) {
  const uint32_t first = player->count > 0 ? player->events[player->count - 1].event.frame : 0;
  const uint64_t offset = message->frame > player->position ? message->frame - player->position : 0;
  return offset > first ? (uint32_t)offset : first;
}

/* Where the events of a block do not fit, it ends before the frame of the last ones, which may be
   joined by others; one frame has DRUM_PLAYER_EVENTS of them at most. So it does not depend on the
   blocks which events act when. */
static uint32_t frames_of_full_block(const DrumPlayer *player, uint32_t next) {
  const uint32_t last = player->events[player->count - 1].event.frame;
  if (next > last) return next;
  return player->events[0].event.frame < last ? last : last + 1;
}

/* The gain of a kit's mix begins to move at the beginning of what is computed at once. */
static bool moves_mix(const DrumPlayer *player, const PlayerMessage *message) {
  return player->kit && (message->type == PLAYER_GAIN || message->type == PLAYER_EXPRESSION);
}

/* Adds what acts before frame @p end. Returns the number of frames that can be played with it. */
static uint32_t gather(DrumPlayer *player, DrumSourceFn *take, void *source, uint64_t end) {
  while (player->has_next || take(source, end, &player->next)) {
    const PlayerMessage *const next = &player->next;
    const uint32_t offset = offset_of(player, next);
    player->has_next = true;
    if (player->count == DRUM_PLAYER_EVENTS) return frames_of_full_block(player, offset);
    if (offset > 0 && moves_mix(player, next)) return offset;
    add(player, next, offset);
    if (player->witness) player->witness(player->context, next, player->position + offset);
    player->has_next = false;
  }
  return (uint32_t)(end - player->position);
}

/* ---- sound ---------------------------------------------------------------------------------- */

static void leave_former(DrumPlayer *player) {
  if (player->former) atomic_store(&player->former->is_left, true);
  player->former = NULL;
}

/* The new room first, while the outputs still are the drum alone: it must not answer what fades in
 * the former. */
static void play_rooms(DrumPlayer *player, uint32_t at, uint32_t frames) {
  if (player->room) room_mix_play(player->room, player->sound, (uint32_t)player->heard, at, frames);
  if (!player->former) return;
  room_mix_play(player->former, player->sound, (uint32_t)player->heard, at, frames);
  if (!room_mix_is_fading(player->former)) leave_former(player);
}

/* Rooms hear the drum behind the gain: what sounds in them goes on as it is when that changes. */
static void add_rooms(DrumPlayer *player, uint32_t count, uint32_t at, uint32_t frames) {
  uint32_t from = 0;
  for (uint32_t i = 0; i < count && player->room; i++) {
    const TaborEvent *const event = &player->events[i].event;
    if (event->type != TABOR_EVENT_SILENCE) continue;
    play_rooms(player, at + from, event->frame - from);
    room_mix_silence(player->room);
    from = event->frame;
  }
  play_rooms(player, at + from, frames - from);
}

/* Number of events that act within @p frames frames. */
static uint32_t events_within(const DrumPlayer *player, uint32_t frames) {
  uint32_t count = player->count;
  while (count > 0 && player->events[count - 1].event.frame >= frames) count--;
  return count;
}

/* Keeps the events that act later. */
static void drop_events(DrumPlayer *player, uint32_t count, uint32_t frames) {
  player->count -= count;
  memmove(player->events, player->events + count, player->count * sizeof *player->events);
  for (uint32_t i = 0; i < player->count; i++) player->events[i].event.frame -= frames;
}

static void compute_drum(DrumPlayer *player, uint32_t count, float *const *outputs, uint32_t at,
                         uint32_t frames) {
  const TaborSound outside = {.mic = player->input_mic,
                              .pressure = player->input ? player->input + at : NULL};
  TaborEvent events[DRUM_PLAYER_EVENTS];
  for (uint32_t i = 0; i < count; i++) events[i] = player->events[i].event;
  tabor_drum_process_sound(player->drum, events, count, &outside, outputs, frames);
}

static void compute_kit(DrumPlayer *player, uint32_t count, float *const *outputs,
                        uint32_t frames) {
  float *const left = outputs[0], *const right = outputs[1];
  TaborKitOutputs to = {.stereo = {left, right}};
  for (uint32_t i = 2; i < player->outputs; i++) to.drum[i / 2 - 1][i % 2] = outputs[i];
  tabor_kit_process(player->kit, player->events, count, &to, frames);
  for (uint32_t i = 0; i < frames; i++) {
    const double gain = fader_next(&player->mix);
    for (uint32_t k = 0; k < player->outputs; k++) {
      if (!outputs[k]) continue;
      if (fabsf(outputs[k][i]) > player->loudest) player->loudest = fabsf(outputs[k][i]);
      outputs[k][i] = (float)(gain * (double)outputs[k][i]);
    }
  }
}

static void compute(DrumPlayer *player, uint32_t at, uint32_t frames) {
  const uint64_t played = player->heard | (player->room ? player->room->feeds : 0);
  const uint32_t count = events_within(player, frames);
  float *outputs[DRUM_PLAYER_OUTPUTS] = {NULL};
  for (uint32_t i = 0; i < player->outputs; i++) {
    float *const sound = player->sound[i] + at;
    if ((player->drum || player->kit) && played >> i & 1u) {
      outputs[i] = sound;
    } else {
      memset(sound, 0, frames * sizeof *sound);
    }
  }
  if (player->drum) compute_drum(player, count, outputs, at, frames);
  if (player->kit) compute_kit(player, count, outputs, frames);
  add_rooms(player, count, at, frames);
  drop_events(player, count, frames);
  player->position += frames;
}

void drum_player_play(DrumPlayer *player, DrumSourceFn *take, void *source, uint32_t frames) {
  const uint64_t start = player->position, end = start + frames;
  while (player->position < end) {
    const uint32_t part = gather(player, take, source, end);
    compute(player, (uint32_t)(player->position - start), part);
  }
}

/* ---- the drum ------------------------------------------------------------------------------- */

void drum_player_begin(DrumPlayer *player, uint32_t outputs, double gain) {
  memset(player, 0, sizeof *player);
  player->outputs = outputs;
  player->gain = gain;
  player->expression = 1;
}

void drum_player_set_drum(DrumPlayer *player, TaborDrum *drum, uint32_t strikers) {
  player->drum = drum;
  player->strikers[0] = strikers;
  player->count = 0;
  add_gain(player, 0);
}

void drum_player_set_kit(DrumPlayer *player, TaborKit *kit, double rate) {
  const TaborKitDef *const def = tabor_kit_definition(kit);
  player->kit = kit;
  player->mix = fader_at(player->gain * player->expression, rate);
  for (uint32_t i = 0; i < def->drum_count; i++) {
    player->strikers[i] = def->drum[i].def.striker_count;
  }
}

/* ---- what they are all together -------------------------------------------------------------- */

/* A drum of the kit, or the only one; NULL past the last. */
static const TaborDrum *drum_at(const DrumPlayer *player, uint32_t index) REALTIME;
static const TaborDrum *drum_at(const DrumPlayer *player, uint32_t index) {
  if (player->kit) return tabor_kit_drum(player->kit, index);
  return index == 0 ? player->drum : NULL;
}

bool drum_player_is_silent(const DrumPlayer *player) {
  if (player->kit) return tabor_kit_is_silent(player->kit);
  return !player->drum || tabor_drum_is_silent(player->drum);
}

void drum_player_ledger(const DrumPlayer *player, TaborLedger *sum) {
  const TaborDrum *drum;
  *sum = (TaborLedger){0};
  for (uint32_t i = 0; (drum = drum_at(player, i)) != NULL; i++) {
    TaborLedger own;
    tabor_drum_ledger(drum, &own);
    sum->injected += own.injected;
    sum->control += own.control;
    sum->stored += own.stored;
    sum->head_loss += own.head_loss;
    sum->wire_loss += own.wire_loss;
    sum->contact_loss += own.contact_loss;
    sum->damper_loss += own.damper_loss;
    sum->shell_loss += own.shell_loss;
    sum->radiated += own.radiated;
    sum->removed += own.removed;
    sum->high_band += own.high_band;
    sum->residual += own.residual;
  }
}

void drum_player_statistics(const DrumPlayer *player, TaborStatistics *sum) {
  const TaborDrum *drum;
  *sum = (TaborStatistics){0};
  if (player->kit) sum->dropped_events = tabor_kit_dropped(player->kit);
  for (uint32_t i = 0; (drum = drum_at(player, i)) != NULL; i++) {
    TaborStatistics own;
    tabor_drum_statistics(drum, &own);
    sum->strikes += own.strikes;
    sum->solves += own.solves;
    sum->newton_iterations += own.newton_iterations;
    sum->newton_capped += own.newton_capped;
    sum->recovered += own.recovered;
    sum->dropped_events += own.dropped_events;
    sum->in_play += own.in_play;
    if (own.newton_max > sum->newton_max) sum->newton_max = own.newton_max;
  }
}

/* The former room hears nothing any more. */
void drum_player_set_room(DrumPlayer *player, RoomMix *room) {
  leave_former(player);
  player->former = player->room;
  player->room = room;
  if (!player->former) return;
  room_mix_silence(player->former);
  player->former->feeds = 0;
}

void drum_player_rest(DrumPlayer *player) {
  leave_former(player);
  if (player->room) room_mix_rest(player->room);
  player->count = 0;
  player->has_next = false;
  player->expression = 1;
  if (player->kit) tabor_kit_reset(player->kit);
  if (player->drum) tabor_drum_reset(player->drum);
  if (player->kit || player->drum) add_gain(player, 0);
}
