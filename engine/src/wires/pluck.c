/* SPDX-License-Identifier: MIT */
#include "wires/pluck.h"

#include <math.h>

#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;
static const double SLACK = 1e-2; /* of a L */
static const double FAR = 5e-4;   /* [m] from rest */

static double compliance_of(const TbWire *wire, double tension, double x) {
  const double rest = wire->length - x, bending = wire->bending_stiffness;
  const double string = x * rest / (tension * wire->length);
  if (bending == 0.0) return string;
  const double a = sqrt(tension / bending);
  if (a * wire->length < SLACK) return x * x * rest * rest / (3.0 * bending * wire->length);
  const double bent = (1.0 - tb_exp(-2.0 * a * x)) * (1.0 - tb_exp(-2.0 * a * rest)) /
                      (2.0 * a * tension * (1.0 - tb_exp(-2.0 * a * wire->length)));
  return string - bent;
}

bool tb_pluck(TbView *view, uint32_t wire, double place, double displacement, double time) {
  const TbWires *wires = &view->model->wires;
  if (wire >= wires->count || wires->rims) return false;
  const TbWire *w = &wires->wires[wire];
  const double node = place * w->cells;
  const uint32_t inner = w->cells - 1u;
  const double at = node < 1.0 ? 1.0 : (node > inner ? inner : node);
  const uint32_t left = (uint32_t)at < inner ? (uint32_t)at : inner - 1u;
  const double tension = view->state->wires.coefficients[wire].tension;
  const double compliance = compliance_of(w, tension, at * w->spacing);
  const double steps = time * view->model->step_rate;
  if (!(compliance > 0.0)) return false;
  view->state->wires.plucks[wire] = (TbPluck){.node = left,
                                              .share = at - left,
                                              .force = displacement / compliance,
                                              .steps = steps < 1.0 ? 1u : (uint32_t)steps};
  view->state->wires.flung = TB_FLUNG;
  return true;
}

bool tb_pluck_acts(const TbState *state) {
  for (uint32_t w = 0; w < TABOR_MAX_WIRES; w++) {
    if (state->wires.plucks[w].steps > 0) return true;
  }
  return false;
}

static double force_now(const TbPluck *pluck) {
  const double part = (pluck->done + 1.0) / pluck->steps;
  return 0.5 * pluck->force * (1.0 - tb_cos(PI * part));
}

/* The first of the two nodes that a finger pulls. */
static uint32_t first_node(const TbView *view, uint32_t wire) {
  return view->model->wires.wires[wire].first_node + view->state->wires.plucks[wire].node;
}

void tb_pluck_pull(TbView *view) {
  if (view->state->wires.flung == 0) return; /* no finger is on a wire */
  for (uint32_t w = 0; w < view->model->wires.count; w++) {
    const TbPluck *pluck = &view->state->wires.plucks[w];
    if (pluck->steps == 0) continue;
    double *v = view->next.v + first_node(view, w);
    const double moved = view->state->wires.coefficients[w].compliance * force_now(pluck);
    v[0] += (1.0 - pluck->share) * moved;
    v[1] += pluck->share * moved;
  }
}

double tb_pluck_work(const TbView *view) {
  double work = 0.0;
  if (view->state->wires.flung == 0) return work;
  for (uint32_t w = 0; w < view->model->wires.count; w++) {
    const TbPluck *pluck = &view->state->wires.plucks[w];
    if (pluck->steps == 0) continue;
    const uint32_t node = first_node(view, w);
    const double *next = view->next.v + node, *last = view->last.v + node;
    work += force_now(pluck) *
            ((1.0 - pluck->share) * (next[0] - last[0]) + pluck->share * (next[1] - last[1]));
  }
  return 0.5 * work;
}

void tb_pluck_follow(TbView *view) {
  if (view->state->wires.flung == 0) return; /* no finger is on a wire */
  for (uint32_t w = 0; w < view->model->wires.count; w++) {
    TbPluck *pluck = &view->state->wires.plucks[w];
    if (pluck->steps > 0 && ++pluck->done >= pluck->steps) *pluck = (TbPluck){.steps = 0};
  }
}

static bool are_far(const TbView *view) {
  for (uint32_t i = 0; i < view->model->wires.node_count; i++) {
    if (fabs(view->now.v[i]) > FAR) return true;
  }
  return false;
}

void tb_pluck_calm(TbView *view) {
  uint32_t *flung = &view->state->wires.flung;
  if (*flung == 0) return;
  *flung = tb_pluck_acts(view->state) || are_far(view) ? TB_FLUNG : *flung - 1u;
}
