/* SPDX-License-Identifier: MIT */
#include "sound/ring_out.h"

#include <math.h>

#define LEAST_TIME 0.5   /* [s] after the last stroke */
#define ENERGY_FALL 1e-9 /* 90 dB */

RingOut ring_out_begin(uint32_t frames, uint32_t last_event, double rate) {
  if (frames > 0) { /* what comes later does not */
    if (last_event >= frames) last_event = frames - 1;
    return (RingOut){.last_event = last_event, .least = frames, .most = frames};
  }
  return (RingOut){.last_event = last_event,
                   .least = last_event + (uint32_t)ceil(LEAST_TIME * rate),
                   .most = last_event + (uint32_t)ceil(RING_OUT_MOST_TIME * rate)};
}

bool ring_out_is_over(RingOut *ring_out, DrumPlayer *player) {
  const uint64_t position = player->position;
  const bool room_is_over = !player->room || room_mix_is_over(player->room);
  if (position <= ring_out->last_event) return false;
  TaborLedger ledger;
  tabor_drum_ledger(player->drum, &ledger);
  if (ledger.stored > ring_out->loudest) ring_out->loudest = ledger.stored;
  if (position < ring_out->least) return false;
  const bool silent = room_is_over && (tabor_drum_is_silent(player->drum) ||
                                       ledger.stored <= ENERGY_FALL * ring_out->loudest);
  ring_out->sounding = !silent && position >= ring_out->most;
  return silent || position >= ring_out->most;
}
