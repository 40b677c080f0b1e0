/* SPDX-License-Identifier: MIT */
#include "sound/silencer.h"

Silencer silencer_begin(double rate) {
  return (Silencer){.phase = SILENCER_HEARD, .at_rest = true, .fader = fader_at(1, rate)};
}

void silencer_wish(Silencer *silencer) {
  if (silencer->at_rest) return;
  fader_set(&silencer->fader, 0);
  silencer->phase = SILENCER_FADING;
}

/* ---- live parameters ------------------------------------------------------------------------ */

void silencer_remember(Silencer *silencer, const TaborEvent *event) {
  uint32_t i = 0;
  silencer->at_rest = false;
  if (event->type != TABOR_EVENT_PARAMETER) return;
  while (i < silencer->live_count && (silencer->live[i].parameter != event->parameter ||
                                      silencer->live[i].index != event->index)) {
    i++;
  }
  if (i == SILENCER_LIVE) return;
  silencer->live[i] = *event;
  silencer->live[i].frame = 0;
  if (i == silencer->live_count) silencer->live_count++;
}

void silencer_forget(Silencer *silencer) { silencer->live_count = 0; }

/* ---- frames --------------------------------------------------------------------------------- */

bool silencer_is_due(const Silencer *silencer) {
  return silencer->phase == SILENCER_FADING && silencer->fader.left == 0;
}

static void rest(Silencer *silencer, TaborDrum *drum) {
  tabor_drum_reset(drum);
  tabor_drum_process(drum, silencer->live, silencer->live_count, NULL, 0);
  silencer->resting = 2 * silencer->fader.length; /* its parameters move meanwhile */
  silencer->phase = SILENCER_RESTING;
  silencer->at_rest = true;
}

void silencer_step(Silencer *silencer, TaborDrum *drum) {
  if (silencer_is_due(silencer)) rest(silencer, drum);
  if (silencer->phase == SILENCER_RESTING && silencer->resting == 0) {
    fader_set(&silencer->fader, 1);
    silencer->phase = SILENCER_HEARD;
  }
}

uint32_t silencer_limit(const Silencer *silencer, uint32_t most) {
  if (silencer->phase == SILENCER_HEARD) return most;
  const uint32_t left =
    silencer->phase == SILENCER_FADING ? silencer->fader.left : silencer->resting;
  return left < most ? left : most;
}

double silencer_next(Silencer *silencer) {
  if (silencer->phase == SILENCER_RESTING) silencer->resting--;
  return fader_next(&silencer->fader);
}
