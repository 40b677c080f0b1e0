/* SPDX-License-Identifier: MIT */
#include "kit/kit_player.h"

#include <math.h>
#include <string.h>

#include "platform/clock.h"

enum { LIVE_EVENTS = 1024 };

/* An event of a hand. */
typedef struct LiveEvent {
  uint64_t frame;
  TaborKitEvent event;
} LiveEvent;

Outcome kit_player_begin(KitPlayer *player, const KitPlayerSetup *setup) {
  memset(player, 0, sizeof *player);
  player->setup = *setup;
  frame_clock_start(&player->clock, setup->rate, setup->buffer);
  const bool has_memory =
    (!setup->records || recording_begin(&player->recording, 2, setup->rate)) &&
    spsc_queue_create(&player->live, sizeof(LiveEvent), LIVE_EVENTS);
  return has_memory ? OUTCOME_OK : fail_memory();
}

void kit_player_end(KitPlayer *player) {
  spsc_queue_destroy(&player->live);
  recording_end(&player->recording);
}

void kit_player_send(KitPlayer *player, double time, const TaborKitEvent *event) {
  const LiveEvent live = {.frame = frame_clock_frame(&player->clock, time), .event = *event};
  (void)spsc_queue_push(&player->live, &live); /* counts what it drops */
}

/* ---- events ---------------------------------------------------------------------------------- */

/* The event that acts next before frame `end`, of the song or live; false if there is none. */
static bool take_event(KitPlayer *player, uint64_t end, uint64_t *frame, TaborKitEvent *event) {
  const KitSong *const song = player->setup.song;
  const LiveEvent *const live = spsc_queue_peek(&player->live);
  const bool has_song = player->next < song->count;
  const uint64_t written = has_song ? song->events[player->next].event.frame : UINT64_MAX;
  const bool is_live = live && live->frame <= written;
  *frame = is_live ? live->frame : written;
  if ((!live && !has_song) || *frame >= end) return false;
  *event = is_live ? live->event : song->events[player->next];
  if (is_live) {
    spsc_queue_pop(&player->live);
  } else {
    player->next++;
  }
  return true;
}

/* Events of the piece, in order; one that is late acts at once. */
static uint32_t gather(KitPlayer *player, uint32_t frames) {
  uint32_t count = 0, last = 0;
  uint64_t frame;
  while (count < KIT_PLAYER_EVENTS &&
         take_event(player, player->position + frames, &frame, &player->events[count])) {
    const uint64_t offset = frame > player->position ? frame - player->position : 0;
    TaborKitEvent *const event = &player->events[count];
    last = offset > last ? (uint32_t)offset : last;
    event->event.frame = last;
    if (event->drum < KIT_MIDI_SAMPLE) {
      count++;
    } else {
      kit_samples_take(player->setup.samples, event->drum - KIT_MIDI_SAMPLE, &event->event, last);
    }
  }
  return count;
}

/* ---- sound ----------------------------------------------------------------------------------- */

static void raise_to(_Atomic double *maximum, double value) {
  if (value > atomic_load_explicit(maximum, memory_order_relaxed)) {
    atomic_store_explicit(maximum, value, memory_order_relaxed);
  }
}

static double clip(KitPlayer *player, double sample) {
  raise_to(&player->peak, fabs(sample));
  if (fabs(sample) <= 1) return sample;
  atomic_fetch_add_explicit(&player->clipped, 1u, memory_order_relaxed);
  return sample > 1 ? 1 : -1;
}

/* Left and right to the first two channels of the device, or both to its only one. */
static void send_frame(const double sides[2], float *samples, uint32_t width) {
  if (width == 1) {
    samples[0] = (float)(0.5 * (sides[0] + sides[1]));
    return;
  }
  for (uint32_t i = 0; i < width; i++) samples[i] = i < 2 ? (float)sides[i] : 0.0f;
}

static void send_out(KitPlayer *player, float *samples, uint32_t frames) {
  const uint32_t width = player->setup.width;
  for (uint32_t i = 0; i < frames; i++) {
    const double sides[2] = {clip(player, player->setup.gain * (double)player->sound[0][i]),
                             clip(player, player->setup.gain * (double)player->sound[1][i])};
    if (width > 0) send_frame(sides, samples + (size_t)i * width, width);
    recording_add(&player->recording, player->position + i, sides);
  }
}

static uint32_t play_piece(KitPlayer *player, float *samples, uint32_t most) {
  const uint64_t left = player->setup.end > 0 ? player->setup.end - player->position : UINT64_MAX;
  uint32_t frames = most < KIT_PLAYER_PIECE ? most : KIT_PLAYER_PIECE;
  if (left < frames) frames = (uint32_t)left;
  const uint32_t count = gather(player, frames);
  const TaborKitOutputs outputs = {.stereo = {player->sound[0], player->sound[1]}};
  tabor_kit_process(player->setup.kit, player->events, count, &outputs, frames);
  kit_samples_add(player->setup.samples, player->sound[0], player->sound[1], frames);
  send_out(player, samples, frames);
  player->position += frames;
  if (left == frames) atomic_store(&player->over, true);
  return frames;
}

bool kit_player_process(KitPlayer *player, float *samples, uint32_t frames, double now, bool gap) {
  const uint32_t width = player->setup.width;
  const double start = stopwatch_seconds(CLOCK_MONOTONIC);
  uint32_t done = 0;
  frame_clock_tick(&player->clock, player->position, frames, now);
  if (gap) atomic_fetch_add_explicit(&player->gaps, 1u, memory_order_relaxed);
  while (done < frames && !atomic_load(&player->over)) {
    done += play_piece(player, samples + (size_t)done * width, frames - done);
  }
  if (width > 0) {
    memset(samples + (size_t)done * width, 0, (frames - done) * width * sizeof *samples);
  }
  const double took = stopwatch_seconds(CLOCK_MONOTONIC) - start;
  raise_to(&player->worst_load, took * player->setup.rate / frames);
  atomic_store_explicit(&player->busy,
                        atomic_load_explicit(&player->busy, memory_order_relaxed) + took,
                        memory_order_relaxed);
  atomic_store_explicit(&player->played, player->position, memory_order_release);
  return !atomic_load(&player->over);
}

/* ---- looking --------------------------------------------------------------------------------- */

bool kit_player_is_over(const KitPlayer *player) { return atomic_load(&player->over); }

void kit_player_status(const KitPlayer *player, KitPlayerStatus *status) {
  const double seconds =
    (double)atomic_load_explicit(&player->played, memory_order_acquire) / player->setup.rate;
  *status = (KitPlayerStatus){.seconds = seconds,
                              .load = seconds > 0 ? atomic_load(&player->busy) / seconds : 0,
                              .worst_load = atomic_load(&player->worst_load),
                              .peak = atomic_load(&player->peak),
                              .clipped = atomic_load(&player->clipped),
                              .gaps = atomic_load(&player->gaps),
                              .dropped = spsc_queue_dropped(&player->live) +
                                         tabor_kit_dropped(player->setup.kit)};
}
