/* SPDX-License-Identifier: MIT */
#include "heads/hihat_air.h"

#include <math.h>

#include "heads/mode_force.h"

static const double CONTRACTION = 0.61101547; /* pi/(pi + 2) */

/* Between all edges [m^2]. */
static double gap_area(const TbView *view) {
  const TbWires *wires = &view->model->wires;
  double sum = 0.0;
  for (uint32_t row = 0; row < wires->stride; row++) {
    const double gap = -wires->real[row] * view->now.eta[row];
    sum += gap > 0.0 ? gap : 0.0;
  }
  return view->model->hihat_air.width * sum;
}

/* W of the step to view->next. */
static double volume_taken(const TbView *view) {
  return tb_mode_force_way(view, &view->model->hihat_air.volume);
}

/* P with b P + a |P|^(1/2) sgn(P) = r, a >= 0, b > 0. */
static double mean_pressure(double a, double b, double r) {
  const double size = fabs(r);
  if (size == 0.0) return 0.0;
  const double root = 2.0 * size / (a + sqrt(a * a + 4.0 * b * size));
  return copysign(root * root, r);
}

void tb_hihat_air_push(TbView *view) {
  const TbHihatAir *air = &view->model->hihat_air;
  TbHihatAirState *state = &view->state->air;
  state->mean = 0.0;
  if (air->stiffness == 0.0 || view->state->wires.lifted) return;
  const double free = volume_taken(view) + state->by_contacts;
  const double flow = view->model->time_step * CONTRACTION * gap_area(view) *
                      sqrt(2.0 / view->model->def.air.density);
  state->mean = mean_pressure(flow, 2.0 / air->stiffness + 0.5 * air->response,
                              2.0 * state->pressure / air->stiffness - free);
  state->foreseen = free + 0.5 * air->response * state->mean - state->by_contacts;
  tb_mode_force_push(view, &air->volume, state->mean);
}

double tb_hihat_air_product(const TbView *view, const double *pull) {
  return view->state->air.mean * tb_mode_force_along(&view->model->hihat_air.volume, pull);
}

double tb_hihat_air_work(const TbView *view) {
  return view->state->air.mean == 0.0 ? 0.0 : view->state->air.mean * volume_taken(view);
}

double tb_hihat_air_end(TbView *view) {
  const TbHihatAir *air = &view->model->hihat_air;
  TbHihatAirState *state = &view->state->air;
  if (air->stiffness == 0.0) return 0.0;
  if (view->state->wires.lifted) return tb_hihat_air_rest(view);
  const double taken = volume_taken(view), left = state->energy - state->mean * taken;
  const double flow =
    2.0 * (state->pressure - state->mean) / air->stiffness - (state->foreseen + state->by_contacts);
  state->pressure -= air->stiffness * (taken + flow);
  state->energy = 0.5 * state->pressure * state->pressure / air->stiffness;
  if (state->energy > left) {
    state->energy = left;
    state->pressure =
      copysign(sqrt(2.0 * air->stiffness * (left > 0.0 ? left : 0.0)), state->pressure);
  }
  state->by_contacts = taken - state->foreseen;
  return left - state->energy;
}

double tb_hihat_air_rest(TbView *view) {
  const double energy = view->state->air.energy;
  view->state->air = (TbHihatAirState){0};
  return energy;
}

void tb_hihat_air_carry(const TbView *from, TbView *to) {
  const double pressure = from->state->air.pressure, stiffness = to->model->hihat_air.stiffness;
  if (!(stiffness > 0.0)) return;
  to->state->air.pressure = pressure;
  to->state->air.energy = 0.5 * pressure * pressure / stiffness;
}
