/* SPDX-License-Identifier: MIT */
#include "step/energy_guard.h"

#include "air/incident_sound.h"
#include "heads/hihat_air.h"
#include "heads/pedal.h"
#include "step/energy.h"
#include "strikers/striker_hold.h"
#include "wires/pluck.h"

/* next = last + t (next - last). */
static void shorten(uint32_t n, double *next, const double *last, double t) {
  for (uint32_t i = 0; i < n; i++) next[i] = last[i] + t * (next[i] - last[i]);
}

void tb_shorten_modes(TbView *view, double t) {
  const TbWires *wires = &view->model->wires;
  shorten(view->model->modes.padded, view->next.q, view->last.q, t);
  shorten(wires->node_count, view->next.v, view->last.v, t);
  shorten(tb_wire_rows(&view->model->rows), view->next.eta, view->last.eta, t);
  shorten(1, view->next.psi, view->now.psi, t); /* it lies between two instants */
}

static void shorten_all(TbView *view, double t) {
  const uint32_t slots = tb_slot_row(&view->model->rows, 0);
  tb_shorten_modes(view, t);
  shorten(TB_SLOTS, view->next.eta + slots, view->last.eta + slots, t);
  shorten(TB_SLOTS, view->next.z, view->last.z, t);
  shorten(TB_SLOTS * TB_TRUNCATED, view->next.truncated[0], view->last.truncated[0], t);
  shorten(TB_SLOTS * TB_BENDS, view->next.bow[0], view->last.bow[0], t);
  for (uint32_t row = 0; row < tb_row_count(&view->model->rows); row++) view->s[row] *= t;
}

double tb_energy_and_losses(const TbView *view) {
  const TbLosses losses = tb_losses(view);
  const TbHoldWork hands = tb_hold_work(view);
  return tb_energy_stored(view, &view->next, &view->now) + losses.head + losses.radiated +
         losses.shell + losses.wires + hands.lost - hands.done - tb_incident_work(view) -
         tb_pluck_work(view) - tb_pedal_work(view) - tb_hihat_air_work(view);
}

bool tb_energy_guard(TbView *view) {
  const double before = tb_energy_stored(view, &view->now, &view->last);
  if (tb_energy_and_losses(view) <= before) return false;
  view->state->ledger.statistics.guarded++;
  /* From next to nothing on: a drum whose whole motion lost a fifth at once would be heard. */
  for (double part = 1e-12; part < 0.5; part *= 3.0) {
    shorten_all(view, 1.0 - part);
    if (tb_energy_and_losses(view) <= before) return true;
  }
  shorten_all(view, 0.0);
  return true;
}
