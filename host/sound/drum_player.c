/* SPDX-License-Identifier: MIT */
#include "sound/drum_player.h"

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

static void add_event(DrumPlayer *player, const TaborEvent *event, uint32_t offset) {
  TaborEvent *const added = &player->events[player->count++];
  *added = *event;
  added->frame = offset;
  fit_striker(added, player->strikers);
  player->strokes += added->type == TABOR_EVENT_STRIKE;
}

static void add_gain(DrumPlayer *player, uint32_t offset) {
  const TaborEvent event = {.type = TABOR_EVENT_GAIN, .value = player->gain * player->expression};
  add_event(player, &event, offset);
}

static void change_model(DrumPlayer *player, const PlayerMessage *message, uint32_t offset) {
  add_event(player, &message->event, offset);
  player->strikers = message->strikers;
}

static void add(DrumPlayer *player, const PlayerMessage *message, uint32_t offset) {
  switch (message->type) {
  case PLAYER_EVENT: add_event(player, &message->event, offset); break;
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
  const uint32_t first = player->count > 0 ? player->events[player->count - 1].frame : 0;
  const uint64_t offset = message->frame > player->position ? message->frame - player->position : 0;
  return offset > first ? (uint32_t)offset : first;
}

/* Where the events of a block do not fit, it ends before the frame of the last ones, which may be joined by others;
   one frame has DRUM_PLAYER_EVENTS of them at most. So it does not depend on the blocks which events act when. */
static uint32_t frames_of_full_block(const DrumPlayer *player, uint32_t next) {
  const uint32_t last = player->events[player->count - 1].frame;
  if (next > last) return next;
  return player->events[0].frame < last ? last : last + 1;
}

/* Adds what acts before frame @p end. Returns the number of frames that can be played with it. */
static uint32_t gather(DrumPlayer *player, DrumSourceFn *take, void *source, uint64_t end) {
  while (player->has_next || take(source, end, &player->next)) {
    const PlayerMessage *const next = &player->next;
    const uint32_t offset = offset_of(player, next);
    player->has_next = true;
    if (player->count == DRUM_PLAYER_EVENTS) return frames_of_full_block(player, offset);
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

/* The new room first, while the outputs still are the drum alone: it must not answer what fades in the former. */
static void play_rooms(DrumPlayer *player, uint32_t at, uint32_t frames) {
  if (player->room) room_mix_play(player->room, player->sound, player->heard, at, frames);
  if (!player->former) return;
  room_mix_play(player->former, player->sound, player->heard, at, frames);
  if (!room_mix_is_fading(player->former)) leave_former(player);
}

/* Rooms hear the drum behind the gain: what sounds in them goes on as it is when that changes. */
static void add_rooms(DrumPlayer *player, uint32_t count, uint32_t at, uint32_t frames) {
  uint32_t from = 0;
  for (uint32_t i = 0; i < count && player->room; i++) {
    const TaborEvent *const event = &player->events[i];
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
  while (count > 0 && player->events[count - 1].frame >= frames) count--;
  return count;
}

/* Keeps the events that act later. */
static void drop_events(DrumPlayer *player, uint32_t count, uint32_t frames) {
  player->count -= count;
  memmove(player->events, player->events + count, player->count * sizeof *player->events);
  for (uint32_t i = 0; i < player->count; i++) player->events[i].frame -= frames;
}

static void compute(DrumPlayer *player, uint32_t at, uint32_t frames) {
  const uint32_t played = player->heard | (player->room ? player->room->feeds : 0);
  const uint32_t count = events_within(player, frames);
  float *outputs[TABOR_MAX_MICS] = {NULL};
  for (uint32_t i = 0; i < player->outputs; i++) {
    float *const sound = player->sound[i] + at;
    if (player->drum && played >> i & 1u) {
      outputs[i] = sound;
    } else {
      memset(sound, 0, frames * sizeof *sound);
    }
  }
  if (player->drum) {
    const TaborSound outside = {.mic = player->input_mic,
                                .pressure = player->input ? player->input + at : NULL};
    tabor_drum_process_sound(player->drum, player->events, count, &outside, outputs, frames);
  }
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
  player->strikers = strikers;
  player->count = 0;
  add_gain(player, 0);
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
  if (!player->drum) return;
  tabor_drum_reset(player->drum);
  add_gain(player, 0);
}
