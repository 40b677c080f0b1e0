/* SPDX-License-Identifier: MIT */
/* A bound on the work of events: see tabor_drum_process() in tabor.h.
 *
 * Each event that acts adds its price to a debt of the drum, and each frame pays some back.
 * Strokes, presses and damping hands change which contacts a drum has, which costs as much as
 * several samples: they act while the debt leaves room for one more within a burst. Live changes,
 * gains and moves of brushes cost little, and may go on to twice that debt, so that a flood of
 * strokes does not hold up a knob.
 *
 * Silences, resets and drum changes act whatever the debt. Each brings the drum to rest, so that a
 * further one costs next to nothing until something else has acted, which only a debt below the
 * limits allows; and a drum that cannot afford a swap is replaced, which is prepared. Releases are
 * free: what they take away has paid when it came.
 *
 * The debt is part of the state, so what is dropped does not depend on the division into blocks.
 * Audio-safe. */
#ifndef TB_EVENT_BUDGET_H
#define TB_EVENT_BUDGET_H

#include "tabor/tabor.h"

enum {
  TB_DEBT_PER_FRAME = 8, /* units of debt that a frame pays back */
  TB_DEBT_STROKE = TABOR_BURST_FRAMES * TB_DEBT_PER_FRAME,
  TB_DEBT_CHANGE = 1,                /* of a live parameter, say: some hundred instructions */
  TB_DEBT_REST = 7 * TB_DEBT_STROKE, /* of a whole drum that is brought to rest or carried over */
  TB_DEBT_BURST = TABOR_BURST * TB_DEBT_STROKE,
  TB_DEBT_MOST = 8 * TB_DEBT_BURST, /* what always acts adds no more beyond this */
};

static inline uint32_t tb_event_price(const TaborEvent *event) {
  switch (event->type) {
  case TABOR_EVENT_STRIKE:
  case TABOR_EVENT_PRESS:
  case TABOR_EVENT_DAMP:
  case TABOR_EVENT_REPLACE: return TB_DEBT_STROKE;
  case TABOR_EVENT_SWAP:
  case TABOR_EVENT_SILENCE:
  case TABOR_EVENT_RESET: return TB_DEBT_REST;
  case TABOR_EVENT_PARAMETER:
  case TABOR_EVENT_GAIN:
  case TABOR_EVENT_MOVE: return TB_DEBT_CHANGE;
  default: return 0;
  }
}

/* True if the debt leaves room for `price`: that of a stroke or a whole drum within a burst, that
 * of a change within two. */
static inline bool tb_event_affordable(uint32_t debt, uint32_t price) {
  const uint32_t limit = price > TB_DEBT_CHANGE ? TB_DEBT_BURST : 2 * TB_DEBT_BURST;
  return price == 0 || debt + price <= limit;
}

static inline void tb_event_charge(uint32_t *debt, uint32_t price) {
  *debt = *debt + price < TB_DEBT_MOST ? *debt + price : TB_DEBT_MOST;
}

/* Call once per frame. */
static inline void tb_event_pay_back(uint32_t *debt) {
  *debt = *debt > TB_DEBT_PER_FRAME ? *debt - TB_DEBT_PER_FRAME : 0;
}

#endif
