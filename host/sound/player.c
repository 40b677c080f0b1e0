/* SPDX-License-Identifier: MIT */
/*
 * The audio thread's part of the player. It does not allocate, lock or make system calls (the clock
 * is read in user space). Its work is bounded by the number of frames, by DRUM_PLAYER_EVENTS events
 * per frame, and by the capacity of the queues.
 *
 * A device's block is played in pieces that end at multiples of PLAYER_PIECE, so that the end is
 * checked at the same frames as in a rendering.
 */
#include "sound/player.h"

#include <math.h>
#include <string.h>

#include "platform/clock.h"
#include "sound/player_state.h"

/* ---- meters --------------------------------------------------------------------------------- */

static void count(atomic_ullong *counter, unsigned long long more) {
  if (more > 0) atomic_fetch_add_explicit(counter, more, memory_order_relaxed);
}

/* A reader may take the maximum meanwhile: then this one is seen again, which does no harm. */
static void raise_to(_Atomic double *maximum, double value) {
  if (value > atomic_load_explicit(maximum, memory_order_relaxed)) {
    atomic_store_explicit(maximum, value, memory_order_relaxed);
  }
}

static void meter_load(Player *player, double load) {
  const double bin = fmin(100 * load, LOAD_BINS - 1);
  atomic_fetch_add_explicit(&player->meters.load[(uint32_t)fmax(bin, 0)], 1, memory_order_relaxed);
  raise_to(&player->meters.load_worst, load);
  raise_to(&player->meters.load_worst_recent, load);
}

static void set(atomic_ullong *meter, unsigned long long value) {
  atomic_store_explicit(meter, value, memory_order_relaxed);
}

static void meter_drum(Player *player) {
  PlayerMeters *const meters = &player->meters;
  TaborStatistics now;
  drum_player_statistics(&player->core, &now);
  set(&meters->strokes, now.strikes);
  set(&meters->solves, now.solves);
  set(&meters->iterations, now.newton_iterations);
  set(&meters->capped, now.newton_capped);
  set(&meters->recovered, now.recovered);
  set(&meters->dropped, now.dropped_events);
  atomic_store_explicit(&meters->newton_max, now.newton_max, memory_order_relaxed);
  atomic_store_explicit(&meters->strikers, now.in_play, memory_order_relaxed);
  atomic_store_explicit(&meters->sleeping, drum_player_is_silent(&player->core),
                        memory_order_relaxed);
  atomic_store_explicit(&meters->gain, player->core.gain, memory_order_relaxed);
}

static void meter_event(Player *player, const PlayerMessage *message) {
  PlayerMeters *const meters = &player->meters;
  const TaborEvent *const event = &message->event;
  const uint64_t position = player->core.position;
  atomic_store_explicit(&meters->last_velocity, event->velocity, memory_order_relaxed);
  atomic_store_explicit(&meters->last_radius, event->radius, memory_order_relaxed);
  atomic_store_explicit(&meters->last_angle, event->angle, memory_order_relaxed);
  atomic_store_explicit(&meters->last_value, event->value, memory_order_relaxed);
  set(&meters->last_frame, message->frame > position ? message->frame : position);
  atomic_store_explicit(&meters->last_type, event->type, memory_order_relaxed);
}

/* ---- messages ------------------------------------------------------------------------------- */

/* The source whose next message acts first; -1 if none has any. */
static int first_source(const Player *player, uint64_t *frame) {
  int first = -1;
  for (int i = 0; i < SOURCE_COUNT; i++) {
    const PlayerMessage *const message = spsc_queue_peek(&player->sources[i]);
    if (!message || (first >= 0 && message->frame >= *frame)) continue;
    first = i;
    *frame = message->frame;
  }
  return first;
}

static void meter_message(Player *player, const PlayerMessage *message) {
  const bool passed = message->frame != PLAYER_NOW && message->frame < player->core.position;
  if (passed && message->type != PLAYER_MODEL)
    count(&player->meters.late, 1); /* models take time */
  if (message->type == PLAYER_EVENT || message->type == PLAYER_MODEL) meter_event(player, message);
}

/* A DrumSourceFn. */
static bool take_message(void *source, uint64_t end, PlayerMessage *message) REALTIME;
static bool take_message(void *source, uint64_t end, PlayerMessage *message) {
  Player *const player = source;
  uint64_t frame = 0;
  const int first = first_source(player, &frame);
  if (first < 0 || frame >= end) return false;
  *message = *(const PlayerMessage *)spsc_queue_peek(&player->sources[first]);
  spsc_queue_pop(&player->sources[first]);
  meter_message(player, message);
  return true;
}

/* A DrumWitnessFn. */
static void log_message(void *context, const PlayerMessage *message, uint64_t frame) REALTIME;
static void log_message(void *context, const PlayerMessage *message, uint64_t frame) {
  Player *const player = context;
  PlayerMessage acted = *message;
  acted.frame = frame;
  (void)spsc_queue_push(&player->log, &acted); /* counts what it drops */
}

/* ---- sound ---------------------------------------------------------------------------------- */

static double clip(Player *player, double sample) {
  if (fabs(sample) <= 1) return sample;
  count(&player->meters.clipped, 1);
  return sample > 1 ? 1 : -1;
}

static void clip_channel(Player *player, uint32_t channel, uint32_t frames) {
  double peak = 0;
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double sample = (double)player->core.sound[player->mics[channel]][frame];
    peak = fmax(peak, fabs(sample));
    player->mixed[channel][frame] = clip(player, sample);
  }
  raise_to(&player->meters.peak[channel], peak);
  raise_to(&player->meters.loudest, peak);
}

/* One channel goes to all of the device's; of several each to its own. */
static void send_out(const Player *player, float *samples, uint32_t frames) {
  for (uint32_t column = 0; column < player->width; column++) {
    const uint32_t channel = player->channels == 1 ? 0 : column;
    for (uint32_t frame = 0; frame < frames; frame++) {
      const bool heard = channel < player->channels;
      samples[frame * player->width + column] = heard ? (float)player->mixed[channel][frame] : 0;
    }
  }
}

static void record(Player *player, uint64_t position, uint32_t frames) {
  double samples[TABOR_MAX_MICS];
  for (uint32_t frame = 0; frame < frames; frame++) {
    for (uint32_t i = 0; i < player->channels; i++) samples[i] = player->mixed[i][frame];
    recording_add(&player->recording, position + frame, samples);
  }
}

/* ---- pieces and blocks ---------------------------------------------------------------------- */

static void look_for_end(Player *player) {
  DrumPlayer *const core = &player->core;
  bool over = core->position >= player->end;
  if (player->ends && !over && core->position % PLAYER_PIECE == 0) {
    over = ring_out_is_over(&player->ring_out, core);
  }
  if (over) atomic_store_explicit(&player->over, true, memory_order_release);
}

/* Frames to the next multiple of PLAYER_PIECE and to the end, at most @p most. */
static uint32_t piece_limit(const Player *player, uint32_t most) {
  const uint64_t position = player->core.position, left = player->end - position;
  const uint32_t whole = PLAYER_PIECE - (uint32_t)(position % PLAYER_PIECE);
  const uint32_t limit = whole < most ? whole : most;
  return left < limit ? (uint32_t)left : limit;
}

static uint32_t play_piece(Player *player, float *samples, uint32_t most) {
  const uint32_t frames = piece_limit(player, most);
  const uint64_t position = player->core.position;
  drum_player_play(&player->core, take_message, player, frames);
  for (uint32_t i = 0; i < player->channels; i++) clip_channel(player, i, frames);
  send_out(player, samples, frames);
  if (player->recording.channels > 0) record(player, position, frames);
  atomic_store_explicit(&player->played, player->core.position, memory_order_release);
  look_for_end(player);
  return frames;
}

static bool has_ended(const Player *player) {
  return atomic_load_explicit(&player->over, memory_order_relaxed) ||
         atomic_load_explicit(&player->halted, memory_order_acquire);
}

/* What the audio thread does once. */
static void introduce_thread(Player *player) {
  if (atomic_load_explicit(&player->has_thread, memory_order_relaxed)) return;
  player->thread = pthread_self();
  player->core.witness = player->logs ? log_message : NULL;
  player->core.context = player;
  atomic_store_explicit(&player->has_thread, true, memory_order_release);
}

bool player_process(Player *player, float *samples, uint32_t frames, double now, bool gap) {
  uint32_t done = 0;
  atomic_store(&player->busy, true); /* sequentially consistent, as halted: see player_halt() */
  if (!has_ended(player)) {
    const double start = stopwatch_seconds(CLOCK_MONOTONIC);
    introduce_thread(player);
    count(&player->meters.xruns, gap);
    frame_clock_tick(&player->clock, player->core.position, frames, now);
    while (done < frames && !has_ended(player)) {
      done += play_piece(player, samples + (size_t)done * player->width, frames - done);
    }
    meter_drum(player);
    const double took = stopwatch_seconds(CLOCK_MONOTONIC) - start;
    meter_load(player, took * player->rate / frames);
  }
  const size_t width = player->width;
  if (width > 0) memset(samples + done * width, 0, (frames - done) * width * sizeof *samples);
  atomic_store(&player->busy, false);
  return !has_ended(player);
}
