/* SPDX-License-Identifier: MIT */
#include "step/plate_relax.h"

#include "air/mic_output.h"
#include "heads/von_karman.h"
#include "strikers/striker_pool.h"

static bool is_struck(const TbView *view) {
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    if (tb_slot_strikes(tb_slot(view, i)) && tb_pool_touches(view, i)) return true;
  }
  return false;
}

/* Adds to the penetrations of slots in play, with this sign, what these feel of the modes. */
static void add_displacements(TbView *view, double sign) {
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    if (!tb_slot_in_play(tb_slot(view, i))) continue;
    const uint32_t row = tb_slot_row(&view->model->rows, i);
    view->now.eta[row] += sign * tb_pool_displacement(view, i, view->now.q);
    view->last.eta[row] += sign * tb_pool_displacement(view, i, view->last.q);
  }
}

void tb_plate_relax(TbView *view) {
  const double excess = is_struck(view) ? 0.0 : tb_von_karman_excess(view);
  if (excess == 0.0) return;
  add_displacements(view, -1.0);
  tb_von_karman_return(view, excess);
  add_displacements(view, 1.0);
  tb_mic_hear_anew(view);
}
