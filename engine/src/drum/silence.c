/* SPDX-License-Identifier: MIT */
/* A silence: the sounding drum becomes a tail, and the drum goes on at rest in the tail's memory.
 * Wires that a live value has moved are moved from their rest again, which taps on the head. That
 * is not heard: the drum is hushed until it sleeps or is played. */
#include <math.h>
#include <string.h>

#include "drum/drum.h"
#include "step/energy.h"
#include "step/live_params.h"
#include "step/reset.h"
#include "strikers/strokes.h"

static const double FADE = 0.015;      /* [s] */
static const double INAUDIBLE = 1e-12; /* [J]: 110 dB below a stroke */

static void give_room(TaborDrum *drum) {
  TbTail **link = &drum->tails;
  while (*link && *link != drum->spare) link = &(*link)->before;
  tb_tails_end(link);
}

/* The drum at rest, with the live values, ledger and counters of the one that sounds. */
static void rest(const TbView *from, TbState *state) {
  tb_step_reset(state, from->model);
  TbView to = tb_view(state, from->model);
  state->ledger = from->state->ledger;
  state->ledger.sums.control -= tb_energy_stored(from, &from->now, &from->last);
  state->live.output = from->state->live.output;
  state->event_debt = from->state->event_debt;
  if (!tb_live_params_keep(&to, from->state->live.values)) return;
  state->asleep = 0;
  state->hushed = 1;
}

/* Nothing has been played since the silence that still fades. */
static bool is_silenced(const TaborDrum *drum, const TbView *view) {
  if (!atomic_load(&drum->spare->sounds)) return false;
  if (drum->state->asleep || drum->state->hushed) return true;
  return fabs(tb_energy_stored(view, &view->now, &view->last)) < INAUDIBLE;
}

bool tb_silence(TaborDrum *drum) {
  const uint32_t fade = (uint32_t)(FADE * drum->model->sample_rate);
  TbView from = tb_view(drum->state, drum->model);
  if (drum->state->asleep && !drum->tails) return false;
  if (is_silenced(drum, &from)) {
    tb_release(&from, 0);
    drum->state->hushed = 1; /* a further silence need not look again */
    return false;
  }
  tb_tails_shorten(drum, fade);
  if (drum->at_rest) return false;
  give_room(drum); /* a second silence within 15 ms cuts the first one's tail short */
  TbTail *tail = drum->spare;
  rest(&from, tail->state);
  TbState *const still = tail->state;
  tail->state = drum->state;
  drum->state = still;
  memcpy(tail->mics, drum->route.mics, sizeof tail->mics);
  tb_tails_begin(drum, tail, 0, fade);
  return true;
}
