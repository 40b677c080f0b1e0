/* SPDX-License-Identifier: MIT */
#include "sound/ring_out.h"

#include <math.h>

#define LEAST_TIME 0.5   /* [s] after the last stroke */
#define ENERGY_FALL 1e-9 /* 90 dB */
#define QUIET 1e-5f      /* -100 dBFS: of a kit's mix */

RingOut ring_out_begin(uint32_t frames, uint32_t last_event, double rate) {
  if (frames > 0) { /* what comes later does not */
    if (last_event >= frames) last_event = frames - 1;
    return (RingOut){.last_event = last_event, .least = frames, .most = frames};
  }
  return (RingOut){.last_event = last_event,
                   .least = last_event + (uint32_t)ceil(LEAST_TIME * rate),
                   .most = last_event + (uint32_t)ceil(RING_OUT_MOST_TIME * rate)};
}

/* A kit's room and samples are in its mix. */
static bool room_is_over(DrumPlayer *player) REALTIME;
static bool room_is_over(DrumPlayer *player) {
  const bool is_quiet = player->loudest < QUIET;
  player->loudest = 0;
  if (player->kit && tabor_kit_sounds(player->kit) > 0) return false;
  return player->kit ? is_quiet : !player->room || room_mix_is_over(player->room);
}

bool ring_out_is_over(RingOut *ring_out, DrumPlayer *player) {
  const uint64_t position = player->position;
  const bool is_alone = room_is_over(player);
  if (position <= ring_out->last_event) return false;
  TaborLedger ledger;
  drum_player_ledger(player, &ledger);
  const double stored = ledger.stored;
  if (stored > ring_out->loudest) ring_out->loudest = stored;
  if (position < ring_out->least) return false;
  const bool silent =
    is_alone && (drum_player_is_silent(player) || stored <= ENERGY_FALL * ring_out->loudest);
  ring_out->sounding = !silent && position >= ring_out->most;
  return silent || position >= ring_out->most;
}
