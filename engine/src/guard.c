/* SPDX-License-Identifier: MIT */
#include "guard.h"

#include "energy.h"

/* next = last + t (next - last). */
static void shorten(uint32_t n, double *next, const double *last, double t) {
  for (uint32_t i = 0; i < n; i++) next[i] = last[i] + t * (next[i] - last[i]);
}

static void shorten_all(TbView *view, double t) {
  const TbWires *wires = &view->model->wires;
  shorten(view->model->modes.padded, view->next.q, view->last.q, t);
  shorten(wires->node_count, view->next.v, view->last.v, t);
  shorten(wires->stride + TB_SLOTS, view->next.eta, view->last.eta, t);
  shorten(TB_SLOTS, view->next.z, view->last.z, t);
  for (uint32_t row = 0; row < wires->stride + TB_SLOTS; row++) view->s[row] *= t;
}

void tb_guard(TbView *view) {
  const double before = tb_energy_stored(view, &view->now, &view->last);
  double whole = 1.0; /* part of the original step that is left */
  for (int i = 0; i < 40; i++) {
    const double after = tb_energy_stored(view, &view->next, &view->now);
    if (after <= before) break;
    shorten_all(view, 0.8);
    whole *= 0.8;
  }
  if (tb_energy_stored(view, &view->next, &view->now) > before) shorten_all(view, 0.0);
  if (whole < 1.0) view->state->statistics.guarded++;
}
