/* SPDX-License-Identifier: MIT */
#include "step/wire_clearance.h"

#include <math.h>
#include <string.h>

#include "heads/coupling.h"
#include "wires/pluck.h"
#include "wires/wire_motion.h"

static const double LEAST_GAP = 3e-3; /* [m] */
static const double STILL = 1e-12;    /* [m], a deviation that is none */

static double least_gap(const TbView *view) {
  const TbWires *wires = &view->model->wires;
  double gap = INFINITY;
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0) continue;
    const double eta = view->model->rest.eta[row] + view->state->wires.shift[wires->row_wire[row]];
    gap = -eta < gap ? -eta : gap;
  }
  return gap;
}

static bool out_of_reach(const TbView *view) {
  const TbModes *modes = &view->model->modes;
  const double most = view->model->kernels->weighted_size(modes->group[modes->groups],
                                                          view->model->reach, view->now.q);
  return most < 0.5 * view->state->wires.gap;
}

bool tb_wires_have_own_tension(const TbView *view) {
  const TbWires *wires = &view->model->wires;
  for (uint32_t w = 0; w < wires->count; w++) {
    if (view->state->wires.coefficients[w].tension != wires->wires[w].tension) return false;
  }
  return true;
}

static bool lie_still(const TbView *view) {
  const TbWires *wires = &view->model->wires;
  for (uint32_t i = 0; i < wires->node_count; i++) {
    if (fabs(view->now.v[i]) > STILL || fabs(view->last.v[i]) > STILL) return false;
  }
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (view->solve.warm.force[row] != 0.0) return false;
  }
  return tb_wires_have_own_tension(view);
}

static void rest_phase(const TbView *view, TbPhase *phase) {
  const TbWires *wires = &view->model->wires;
  memset(phase->v, 0, wires->node_count * sizeof(double));
  for (uint32_t row = 0; row < wires->stride; row++) {
    phase->eta[row] = view->model->rest.eta[row] + view->state->wires.shift[wires->row_wire[row]];
  }
}

void tb_wire_clearance_begin(TbView *view) {
  TbState *state = view->state;
  if (state->wires.lifted || view->model->wires.count == 0 || tb_pluck_acts(state)) return;
  state->wires.gap = least_gap(view);
  if (!(state->wires.gap > LEAST_GAP) || !out_of_reach(view) || !lie_still(view)) return;
  state->wires.lifted = 1;
  tb_view_lift(view, true);
  TbPhase *const phases[3] = {&view->now, &view->last, &view->next};
  for (int i = 0; i < 3; i++) rest_phase(view, phases[i]);
  memset(view->b, 0, view->model->wires.stride * sizeof(double));
  memset(view->solve.warm.product, 0, view->model->wires.stride * sizeof(double));
}

void tb_wire_clearance_follow(TbView *view) {
  if (view->state->wires.lifted && !out_of_reach(view)) tb_wire_clearance_end(view);
}

void tb_wire_clearance_end(TbView *view) {
  if (!view->state->wires.lifted) return;
  view->state->wires.lifted = 0;
  tb_view_lift(view, false);
  tb_penetrations_from_displacements(view, &view->now);
  tb_penetrations_from_displacements(view, &view->last);
  tb_coupling_renew(view);
}
