/* SPDX-License-Identifier: MIT */
#include "step/edge_friction.h"

#include "step/energy_guard.h"
#include "strikers/striker_pool.h"

enum { EVERY = 16 }; /* steps: motion then shrinks by less than a hundredth at once */

/* EVERY k s, at most. */
static const double MOST = 0.05;

static bool is_touched(const TbView *view) {
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    if (tb_slot_in_play(tb_slot(view, i)) && tb_pool_touches(view, i)) return true;
  }
  return false;
}

/* Sum of the edges' forces [N]. */
static double pressure(const TbView *view) {
  double sum = 0.0;
  for (uint32_t row = 0; row < view->model->wires.stride; row++) sum += view->solve.warm.force[row];
  return sum;
}

/* Slots feel where the surface is; nothing touches. */
static void add_displacements(TbView *view, double sign) {
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    if (!tb_slot_in_play(tb_slot(view, i))) continue;
    view->next.eta[tb_slot_row(&view->model->rows, i)] +=
      sign * tb_pool_displacement(view, i, view->next.q);
  }
}

bool tb_edge_friction(TbView *view) {
  const double friction = view->model->def.hihat.friction;
  if (!view->model->wires.rims || friction == 0.0 || view->state->clock % EVERY > 0) return false;
  if (view->state->wires.lifted || !view->model->def.quality.losses || is_touched(view))
    return false;
  const double wanted = EVERY * view->model->time_step * friction * pressure(view);
  if (!(wanted > 0.0)) return false;
  const double before = tb_energy_and_losses(view);
  add_displacements(view, -1.0);
  tb_shorten_modes(view, 1.0 - (wanted < MOST ? wanted : MOST));
  add_displacements(view, 1.0);
  view->state->ledger.sums.contact_loss += before - tb_energy_and_losses(view);
  return true;
}
