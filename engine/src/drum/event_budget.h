/* SPDX-License-Identifier: MIT */
/* A bound on the work of events: see tabor_drum_process() in tabor.h.
 *
 * A stroke, a press and a damping hand change which contacts a drum has, which costs as much as
 * several samples. Each that acts adds TABOR_BURST_FRAMES frames to a debt of the drum, and each
 * frame pays one back. While the debt is that of a whole burst, further ones are dropped. The debt
 * is part of the state, so what is dropped does not depend on the division into blocks.
 * Audio-safe. */
#ifndef TB_EVENT_BUDGET_H
#define TB_EVENT_BUDGET_H

#include "step/state.h"

static inline bool tb_event_costs(const TaborEvent *event) {
  return event->type == TABOR_EVENT_STRIKE || event->type == TABOR_EVENT_PRESS ||
         event->type == TABOR_EVENT_DAMP;
}

static inline bool tb_event_affordable(const TbState *state, const TaborEvent *event) {
  const uint32_t most = (TABOR_BURST - 1u) * TABOR_BURST_FRAMES;
  return !tb_event_costs(event) || state->event_debt <= most;
}

/* Call for each event that was carried out. */
static inline void tb_event_charge(TbState *state, const TaborEvent *event) {
  if (tb_event_costs(event)) state->event_debt += TABOR_BURST_FRAMES;
}

/* Call once per frame. */
static inline void tb_event_pay_back(TbState *state) {
  if (state->event_debt > 0) state->event_debt--;
}

#endif
