/* SPDX-License-Identifier: MIT */
/*
 * The audio thread's part of the player. It does not allocate, lock or make system calls (the clock is read
 * in user space). Its work is bounded by the number of frames, by PLAYER_EVENTS events per frame, and by
 * the capacity of the queues.
 *
 * A block is played in pieces. A piece starts wherever a message acts, and every PLAYER_PIECE frames. So
 * a message acts at its frame for every block size, and the end is checked at the same frames as in a
 * rendering.
 */
#include "sound/player.h"

#include <math.h>
#include <string.h>

#include "base/stopwatch.h"
#include "sound/player_state.h"
#include "strokes/fit_striker.h"

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
  const bool sleeps = tabor_drum_is_silent(player->drum) && player->leaving.count == 0;
  TaborStatistics now;
  tally_statistics(&player->tally, player->drum, &now);
  set(&meters->strokes, now.strikes);
  set(&meters->solves, now.solves);
  set(&meters->iterations, now.newton_iterations);
  set(&meters->capped, now.newton_capped);
  set(&meters->recovered, now.recovered);
  set(&meters->dropped, now.dropped_events);
  atomic_store_explicit(&meters->newton_max, now.newton_max, memory_order_relaxed);
  atomic_store_explicit(&meters->strikers, now.in_play, memory_order_relaxed);
  atomic_store_explicit(&meters->sleeping, sleeps, memory_order_relaxed);
  atomic_store_explicit(&meters->gain, player->gain.now, memory_order_relaxed);
}

static void meter_event(Player *player, const TaborEvent *event) {
  PlayerMeters *const meters = &player->meters;
  atomic_store_explicit(&meters->last_velocity, event->velocity, memory_order_relaxed);
  atomic_store_explicit(&meters->last_radius, event->radius, memory_order_relaxed);
  atomic_store_explicit(&meters->last_angle, event->angle, memory_order_relaxed);
  atomic_store_explicit(&meters->last_value, event->value, memory_order_relaxed);
  set(&meters->last_frame, player->position);
  atomic_store_explicit(&meters->last_type, event->type, memory_order_relaxed);
}

/* ---- messages ------------------------------------------------------------------------------- */

void player_listen(Player *player) {
  for (uint32_t mic = 0; mic < TABOR_MAX_MICS; mic++) player->outputs[mic] = NULL;
  for (uint32_t channel = 0; channel < player->channels; channel++) {
    const uint32_t mic = player->mics[channel];
    player->outputs[mic] = player->planar[mic];
  }
}

static void add_event(Player *player, const TaborEvent *event) {
  TaborEvent *const added = &player->events[player->event_count++];
  *added = *event;
  added->frame = 0;
  fit_striker(added, player->striker_count);
  silencer_remember(&player->silencer, added);
  meter_event(player, added);
}

/* Whoever has sent it may destroy it. There is always room: he sends few. */
static void give_back(Player *player, TaborDrum *drum) {
  if (drum) (void)spsc_queue_push(&player->gone, &drum);
}

static void give_back_left(Player *player) {
  TaborDrum *drum;
  while ((drum = leaving_take(&player->leaving)) != NULL) give_back(player, drum);
}

static void swap(Player *player, const PlayerMessage *message) {
  TaborEvent event = message->event;
  event.frame = 0;
  tabor_drum_process(player->drum, &event, 1, NULL, 0);
}

static void replace(Player *player, const PlayerMessage *message) {
  tally_keep(&player->tally, player->drum);
  give_back(player, leaving_add(&player->leaving, player->drum, player->mics, player->channels));
  player->drum = message->drum;
  silencer_forget(&player->silencer);
}

/* At once, so that what follows is understood as meant for what has come. */
static void change_drum(Player *player, const PlayerMessage *message) {
  tabor_drum_process(player->drum, player->events, player->event_count, NULL, 0);
  player->event_count = 0;
  if (message->type == PLAYER_DRUM) {
    replace(player, message);
  } else {
    swap(player, message);
  }
  for (uint32_t i = 0; i < player->channels; i++) player->mics[i] = message->mics[i];
  player->striker_count = message->strikers;
  player_listen(player);
  meter_event(player, &message->event);
}

static bool changes_drum(const PlayerMessage *message) {
  return message->type == PLAYER_SWAP || message->type == PLAYER_DRUM;
}

static void carry_out(Player *player, const PlayerMessage *message) {
  const bool passed = message->frame != PLAYER_NOW && message->frame < player->position;
  if (passed && !changes_drum(message)) count(&player->meters.late, 1); /* models take time */
  switch (message->type) {
  case PLAYER_EVENT: add_event(player, &message->event); break;
  case PLAYER_SWAP:
  case PLAYER_DRUM: change_drum(player, message); break;
  case PLAYER_GAIN: fader_set(&player->gain, message->value); break;
  case PLAYER_EXPRESSION: fader_set(&player->expression, message->value); break;
  case PLAYER_SILENCE: silencer_wish(&player->silencer); break;
  default: break;
  }
}

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

/* Takes what acts at this frame. How many of @p most frames there are until the next message. */
static uint32_t take_messages(Player *player, uint32_t most) {
  uint64_t frame = 0;
  int source;
  while (player->event_count < PLAYER_EVENTS && !silencer_waits(&player->silencer)) {
    source = first_source(player, &frame);
    if (source < 0) return most;
    if (frame > player->position) {
      return frame - player->position < most ? (uint32_t)(frame - player->position) : most;
    }
    carry_out(player, spsc_queue_peek(&player->sources[source]));
    spsc_queue_pop(&player->sources[source]);
  }
  return silencer_waits(&player->silencer) ? most : 1; /* what is left acts one frame later */
}

static void step_silencer(Player *player) {
  if (silencer_is_due(&player->silencer)) {
    tally_keep(&player->tally, player->drum);
    leaving_cut(&player->leaving);
    give_back_left(player);
  }
  silencer_step(&player->silencer, player->drum);
}

/* What happens at this frame; how many of @p most frames to compute before the next. */
static uint32_t begin_piece(Player *player, uint32_t most) {
  const Silencer *const silencer = &player->silencer;
  player->event_count = 0;
  step_silencer(player);
  const uint32_t frames = silencer_waits(silencer) ? most : take_messages(player, most);
  return silencer_limit(silencer, frames);
}

/* ---- sound ---------------------------------------------------------------------------------- */

/* What each channel hears of all drums. */
static void gather(Player *player, uint32_t frames) {
  const float *samples[TABOR_MAX_MICS];
  double *sound[TABOR_MAX_MICS];
  for (uint32_t channel = 0; channel < player->channels; channel++) {
    samples[channel] = player->planar[player->mics[channel]];
    sound[channel] = player->mixed[channel];
  }
  leaving_join(&player->leaving, samples, sound, player->channels, frames);
  give_back_left(player);
}

static double clip(Player *player, double sample) {
  if (fabs(sample) <= 1) return sample;
  count(&player->meters.clipped, 1);
  return sample > 1 ? 1 : -1;
}

/* Channels at their level. The gain is of all channels: it moves with the frames. */
static void mix(Player *player, uint32_t frames) {
  double peak[TABOR_MAX_MICS] = {0};
  for (uint32_t frame = 0; frame < frames; frame++) {
    const double gain = fader_next(&player->gain) * fader_next(&player->expression) *
                        silencer_next(&player->silencer);
    for (uint32_t channel = 0; channel < player->channels; channel++) {
      const double sample = gain * player->mixed[channel][frame];
      peak[channel] = fmax(peak[channel], fabs(sample));
      player->mixed[channel][frame] = clip(player, sample);
    }
  }
  for (uint32_t channel = 0; channel < player->channels; channel++) {
    raise_to(&player->meters.peak[channel], peak[channel]);
    raise_to(&player->meters.loudest, peak[channel]);
  }
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

/* A block is full every PLAYER_RECORD frames, where a piece ends, too. */
static void record(Player *player, uint32_t frames) {
  PlayerRecord *const block = player->record;
  const uint32_t channels = player->channels;
  if (block->frames == 0) block->frame = player->position;
  double *const samples = block->samples + (size_t)block->frames * channels;
  for (uint32_t channel = 0; channel < channels; channel++) {
    for (uint32_t frame = 0; frame < frames; frame++) {
      samples[frame * channels + channel] = player->mixed[channel][frame];
    }
  }
  block->frames += frames;
  if (block->frames == PLAYER_RECORD) player_hand_over(player);
}

void player_hand_over(Player *player) {
  if (player->record->frames == 0) return;
  if (!spsc_queue_push(&player->recording, player->record)) {
    count(&player->meters.lost_frames, player->record->frames);
  }
  player->record->frames = 0;
}

/* ---- pieces and blocks ---------------------------------------------------------------------- */

static void look_for_end(Player *player) {
  bool over = player->position >= player->end;
  if (player->ends && !over && player->position % PLAYER_PIECE == 0) {
    over = ring_out_is_over(&player->ring_out, (uint32_t)player->position, player->drum);
  }
  if (over) atomic_store_explicit(&player->over, true, memory_order_release);
}

/* Frames to the next multiple of PLAYER_PIECE and to the end, at most @p most. */
static uint32_t piece_limit(const Player *player, uint32_t most) {
  const uint32_t whole = PLAYER_PIECE - (uint32_t)(player->position % PLAYER_PIECE);
  const uint64_t left = player->end - player->position;
  const uint32_t limit = whole < most ? whole : most;
  return left < limit ? (uint32_t)left : limit;
}

static uint32_t play_piece(Player *player, float *samples, uint32_t most) {
  const uint32_t frames = begin_piece(player, piece_limit(player, most));
  tabor_drum_process(player->drum, player->events, player->event_count, player->outputs, frames);
  gather(player, frames);
  mix(player, frames);
  send_out(player, samples, frames);
  if (player->records) record(player, frames);
  player->position += frames;
  atomic_store_explicit(&player->played, player->position, memory_order_relaxed);
  look_for_end(player);
  return frames;
}

static bool has_ended(const Player *player) {
  return atomic_load_explicit(&player->over, memory_order_relaxed) ||
         atomic_load_explicit(&player->halted, memory_order_acquire);
}

static void introduce_thread(Player *player) {
  if (atomic_load_explicit(&player->has_thread, memory_order_relaxed)) return;
  player->thread = pthread_self();
  atomic_store_explicit(&player->has_thread, true, memory_order_release);
}

bool player_process(Player *player, float *samples, uint32_t frames, double now, bool gap) {
  uint32_t done = 0;
  atomic_store(&player->busy, true); /* sequentially consistent, as halted: see player_halt() */
  if (!has_ended(player)) {
    const double start = stopwatch_seconds(CLOCK_MONOTONIC);
    introduce_thread(player);
    count(&player->meters.xruns, gap);
    frame_clock_tick(&player->clock, player->position, frames, now);
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
