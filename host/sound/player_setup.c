/* SPDX-License-Identifier: MIT */
/* The functions of a player for all threads but the audio thread. */
#include <sched.h>
#include <stdlib.h>
#include <string.h>

#include "platform/clock.h"
#include "platform/process.h"
#include "sound/player.h"
#include "sound/player_state.h"
#include "sound/room_create.h"

#define SOURCE_ROOM 4096                          /* messages */
#define LOG_ROOM (2 * SOURCE_COUNT * SOURCE_ROOM) /* messages: twice as many as may wait */
#define PRIORITY 60 /* of SCHED_FIFO: below what the system's own sound has */

static bool create_recording(Player *player, const PlayerSetup *setup) {
  return !setup->records || recording_begin(&player->recording, setup->channels, setup->rate);
}

static bool create_log(Player *player) {
  return !player->logs || spsc_queue_create(&player->log, sizeof(PlayerMessage), LOG_ROOM);
}

static bool create_rings(Player *player, const PlayerSetup *setup) {
  bool created = create_recording(player, setup) && create_log(player);
  for (int i = 0; i < SOURCE_COUNT; i++) {
    created = created && spsc_queue_create(&player->sources[i], sizeof(PlayerMessage), SOURCE_ROOM);
  }
  return created;
}

static void set_end(Player *player, const PlayerSetup *setup) {
  player->ends = setup->dies_away && setup->frames == 0;
  player->end = setup->frames > 0 ? setup->frames : UINT64_MAX;
  if (!player->ends) return;
  player->ring_out = ring_out_begin(0, setup->last_event, setup->rate);
  player->end = player->ring_out.most;
}

static Outcome set_instrument(Player *player, const PlayerSetup *setup) {
  DrumPlayer *const core = &player->core;
  if (setup->kit) {
    drum_player_begin(core, 2, setup->gain);
    drum_player_set_kit(core, setup->kit, setup->rate);
    return OUTCOME_OK;
  }
  drum_player_begin(core, setup->def->mic_count, setup->gain);
  drum_player_set_drum(core, setup->drum, setup->def->striker_count);
  const Outcome outcome = room_create(setup->def, setup->rate, &player->room);
  if (outcome == OUTCOME_OK) drum_player_set_room(core, &player->room);
  return outcome;
}

Outcome player_create(const PlayerSetup *setup, Player **created) {
  Player *const player = process_allocate_aligned(SPSC_QUEUE_LINE, sizeof *player);
  *created = player;
  if (!player) return fail_memory();
  memset(player, 0, sizeof *player);
  const Outcome outcome = set_instrument(player, setup);
  if (outcome != OUTCOME_OK) return outcome;
  player->rate = setup->rate;
  player->channels = setup->channels;
  memcpy(player->mics, setup->mics, sizeof player->mics);
  for (uint32_t i = 0; i < setup->channels; i++)
    player->core.heard |= UINT64_C(1) << setup->mics[i];
  player->width = setup->width;
  player->logs = setup->logs;
  set_end(player, setup);
  frame_clock_start(&player->clock, setup->rate, setup->buffer);
  return create_rings(player, setup) ? OUTCOME_OK : fail_memory();
}

void player_destroy(Player *player) {
  if (!player) return;
  for (int i = 0; i < SOURCE_COUNT; i++) spsc_queue_destroy(&player->sources[i]);
  recording_end(&player->recording);
  spsc_queue_destroy(&player->log);
  room_mix_free(&player->room);
  process_free_aligned(player);
}

uint64_t player_most_frames(const Player *player) { return player->end; }

/* ---- sources -------------------------------------------------------------------------------- */

bool player_send(Player *player, PlayerSource source, const PlayerMessage *message) {
  return spsc_queue_push(&player->sources[source], message);
}

size_t player_waiting(const Player *player, PlayerSource source) {
  return spsc_queue_count(&player->sources[source]);
}

uint64_t player_frame_at(const Player *player, double time) {
  return frame_clock_frame(&player->clock, time);
}

/* ---- the recording -------------------------------------------------------------------------- */

Recording *player_recording(Player *player) { return &player->recording; }

/* ---- the log -------------------------------------------------------------------------------- */

const PlayerMessage *player_log(const Player *player) {
  return player->logs ? spsc_queue_peek(&player->log) : NULL;
}

void player_log_next(Player *player) { spsc_queue_pop(&player->log); }

bool player_log_has_room(const Player *player) {
  return !player->logs || spsc_queue_count(&player->log) <= LOG_ROOM / 2;
}

uint64_t player_log_lost(const Player *player) {
  return player->logs ? spsc_queue_dropped(&player->log) : 0;
}

/* ---- the user ------------------------------------------------------------------------------- */

static double get(const _Atomic double *meter) {
  return atomic_load_explicit(meter, memory_order_relaxed);
}

static unsigned long long number(const atomic_ullong *meter) {
  return atomic_load_explicit(meter, memory_order_relaxed);
}

/* The load that half of @p total blocks stay below, in the middle of its bin. */
static double median_load(const uint32_t *bins) {
  uint64_t total = 0, sum = 0;
  uint32_t bin = 0;
  for (uint32_t i = 0; i < LOAD_BINS; i++) total += bins[i];
  if (total == 0) return 0;
  while (2 * (sum += bins[bin]) < total) bin++;
  return (bin + 0.5) / 100;
}

static void status_load(Player *player, PlayStatus *status) {
  uint32_t recent[LOAD_BINS];
  for (uint32_t i = 0; i < LOAD_BINS; i++) {
    const uint32_t seen = atomic_load_explicit(&player->meters.load[i], memory_order_relaxed);
    recent[i] = seen - player->load_seen[i];
    player->load_seen[i] = seen;
  }
  status->load_median = median_load(recent);
  status->load_worst =
    atomic_exchange_explicit(&player->meters.load_worst_recent, 0, memory_order_relaxed);
}

void player_load(const Player *player, double *median, double *worst) {
  uint32_t all[LOAD_BINS];
  for (uint32_t i = 0; i < LOAD_BINS; i++) {
    all[i] = atomic_load_explicit(&player->meters.load[i], memory_order_relaxed);
  }
  *median = median_load(all);
  *worst = get(&player->meters.load_worst);
}

static void status_last_event(Player *player, PlayStatus *status) {
  PlayerMeters *const meters = &player->meters;
  status->last_event = (TaborEvent){
    .type = atomic_load_explicit(&meters->last_type, memory_order_relaxed),
    .velocity = get(&meters->last_velocity),
    .radius = get(&meters->last_radius),
    .angle = get(&meters->last_angle),
    .value = get(&meters->last_value),
  };
  status->last_time = (double)number(&meters->last_frame) / player->rate;
}

static uint64_t dropped_messages(const Player *player) {
  uint64_t sum = 0;
  for (int i = 0; i < SOURCE_COUNT; i++) sum += spsc_queue_dropped(&player->sources[i]);
  return sum;
}

static void status_drum(Player *player, PlayStatus *status) {
  PlayerMeters *const meters = &player->meters;
  const unsigned long long solves = number(&meters->solves);
  status->sleeping = atomic_load_explicit(&meters->sleeping, memory_order_relaxed);
  status->strikers = atomic_load_explicit(&meters->strikers, memory_order_relaxed);
  status->newton_mean = solves > 0 ? (double)number(&meters->iterations) / (double)solves : 0;
  status->newton_max = atomic_load_explicit(&meters->newton_max, memory_order_relaxed);
  status->newton_capped = number(&meters->capped);
  status->recovered = number(&meters->recovered);
  status->strokes = number(&meters->strokes);
  status->late = number(&meters->late);
  status->dropped = number(&meters->dropped) + dropped_messages(player);
}

void player_status(Player *player, PlayStatus *status) {
  PlayerMeters *const meters = &player->meters;
  status->rate = player->rate;
  status->time = (double)player_position(player) / player->rate;
  status->channels = player->channels;
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) {
    status->peak[i] = atomic_exchange_explicit(&meters->peak[i], 0, memory_order_relaxed);
  }
  status->loudest = get(&meters->loudest);
  status->gain = get(&meters->gain);
  status->clipped = number(&meters->clipped);
  status->xruns = number(&meters->xruns);
  status->recording = player->recording.channels > 0;
  status->lost_frames = number(&player->recording.lost);
  status_load(player, status);
  status_drum(player, status);
  status_last_event(player, status);
}

uint32_t player_buffer(const Player *player) {
  return atomic_load_explicit(&player->clock.delay, memory_order_relaxed);
}

bool player_is_over(const Player *player) {
  return atomic_load_explicit(&player->over, memory_order_acquire);
}

uint64_t player_position(const Player *player) {
  return atomic_load_explicit(&player->played, memory_order_acquire);
}

bool player_halt(Player *player, double seconds) {
  const struct timespec moment = {.tv_nsec = 1000000};
  const double start = stopwatch_seconds(CLOCK_MONOTONIC);
  atomic_store(&player->halted, true);
  while (atomic_load(&player->busy)) {
    if (stopwatch_seconds(CLOCK_MONOTONIC) - start > seconds) return false;
    (void)nanosleep(&moment, NULL);
  }
  recording_hand_over(&player->recording);
  return true;
}

bool player_raise_priority(Player *player) {
  int policy;
  struct sched_param parameter;
  if (!atomic_load_explicit(&player->has_thread, memory_order_acquire)) return false;
  if (pthread_getschedparam(player->thread, &policy, &parameter) != 0) return false;
  if (policy == SCHED_FIFO || policy == SCHED_RR) return true; /* the device's own */
  parameter.sched_priority = PRIORITY;
  return pthread_setschedparam(player->thread, SCHED_FIFO, &parameter) == 0;
}
