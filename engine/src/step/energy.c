/* SPDX-License-Identifier: MIT */
#include "step/energy.h"

#include "air/high_band_step.h"
#include "heads/lug_forces.h"
#include "heads/stretch.h"
#include "strikers/stick.h"
#include "strikers/striker_pool.h"

static double oscillators(uint32_t n, double rate, const double *stiffness, const double *next,
                          const double *now) {
  double sum = 0.0;
  for (uint32_t i = 0; i < n; i++) {
    sum += tb_pole_energy(rate, stiffness[i], next[i], now[i]);
  }
  return 0.5 * sum;
}

static double modes_energy(const TbView *view, const TbPhase *next, const TbPhase *now) {
  const TbModes *modes = &view->model->modes;
  return oscillators(modes->padded, view->model->step_rate, modes->stiffness, next->q, now->q);
}

double tb_energy_high(const TbView *view) { return tb_high_band_step_of(view)->energy(view); }

/* dT Int (v_r'^2/2 + v_r' v') dx, v' the mean of the two instants. */
static double tension_energy(const TbView *view, const TbWire *wire, double change,
                             const double *next, const double *now) {
  const double *rest = view->model->rest.v + wire->first_node;
  double sum = 0.0;
  for (uint32_t i = 0; i < wire->cells; i++) {
    const double slope = rest[i + 1] - rest[i];
    const double moved = 0.5 * ((next[i + 1] - next[i]) + (now[i + 1] - now[i]));
    sum += slope * (0.5 * slope + moved);
  }
  return change * sum / wire->spacing;
}

static double wires_energy(const TbView *view, const TbPhase *next, const TbPhase *now) {
  const TbWires *wires = &view->model->wires;
  double sum = 0.0;
  for (uint32_t w = 0; w < wires->count; w++) {
    const TbWire *wire = &wires->wires[w];
    const TbWireCoefficients *c = &view->state->wires.coefficients[w];
    const double *v1 = next->v + wire->first_node, *v0 = now->v + wire->first_node;
    sum += tb_wire_energy(wire, c, view->model->time_step, v1, v0);
    const double change = c->tension - wire->tension;
    if (change != 0.0) sum += tension_energy(view, wire, change, v1, v0);
  }
  return sum;
}

static double contact_energy(const TbView *view, uint32_t row, double eta) {
  const TbRest *rest = &view->model->rest;
  const uint32_t w = view->model->wires.row_wire[row];
  const double moved = eta - rest->eta[row];
  return tb_contact_law_work(&view->model->wires.laws[w], rest->eta[row], moved) -
         rest->force[row] * (moved - view->state->wires.shift[w]);
}

static double contacts_energy(const TbView *view, const TbPhase *next, const TbPhase *now) {
  double sum = 0.0;
  for (uint32_t row = 0; row < view->model->wires.stride; row++) {
    if (view->model->wires.real[row] == 0.0) continue;
    sum += contact_energy(view, row, next->eta[row]) + contact_energy(view, row, now->eta[row]);
  }
  return 0.5 * sum;
}

/* Energy of strikers, of their contacts, and of the head's truncated modes under them. */
static double strikers_energy(const TbView *view, const TbPhase *next, const TbPhase *now) {
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *slot = tb_slot(view, i);
    if (!tb_slot_strikes(slot)) continue;
    sum += tb_stick_motion(view, i, next->z, now->z) +
           2.0 * tb_pool_contact_energy(view, i, next, now) +
           2.0 * tb_stick_bending(view, i, next, now) +
           2.0 * tb_truncated_modes_energy(tb_slot_truncated(view, i), view->model->step_rate,
                                           next->truncated[i], now->truncated[i]);
  }
  return 0.5 * sum;
}

double tb_energy_wires(const TbView *view, const TbPhase *next, const TbPhase *now) {
  return wires_energy(view, next, now) + contacts_energy(view, next, now);
}

double tb_energy_stored(const TbView *view, const TbPhase *next, const TbPhase *now) {
  return modes_energy(view, next, now) + tb_stretch_energy(view, next, now) +
         tb_lug_forces_energy(view, next->q, now->q) + tb_energy_wires(view, next, now) +
         strikers_energy(view, next, now) + view->state->air.energy;
}

double tb_energy_motion(const TbView *view, const TbPhase *next, const TbPhase *now) {
  const TbModes *modes = &view->model->modes;
  const TbWires *wires = &view->model->wires;
  double head = 0.0, all = 0.0;
  for (uint32_t i = 0; i < modes->padded; i++) {
    const double step = next->q[i] - now->q[i];
    head += step * step;
  }
  for (uint32_t w = 0; w < wires->count; w++) {
    const TbWire *wire = &wires->wires[w];
    double sum = 0.0;
    for (uint32_t i = 1; i < wire->cells; i++) {
      const double step = next->v[wire->first_node + i] - now->v[wire->first_node + i];
      sum += step * step;
    }
    all += wire->mass_per_length * wire->spacing * sum;
  }
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const double step = next->z[i] - now->z[i];
    all += tb_slot(view, i)->striker.mass * step * step;
    for (uint32_t n = 0; n < TB_BENDS; n++) {
      const double bent = next->bow[i][n] - now->bow[i][n];
      all += bent * bent;
    }
  }
  return 0.5 * (head + all) * view->model->step_rate * view->model->step_rate;
}

TbLosses tb_losses(const TbView *view) {
  const TbModes *modes = &view->model->modes;
  const double *const origins[3] = {modes->loss_head, modes->loss_air, modes->loss_shell};
  double by[3] = {0.0};
  view->model->kernels->losses(modes->padded, modes->walls ? 3 : 2, origins, view->next.q,
                               view->last.q, by);
  return tb_losses_with(view, by);
}

TbLosses tb_losses_with(const TbView *view, const double by[3]) {
  const TaborModel *model = view->model;
  TbLosses losses = {.head = by[0], .radiated = by[1], .shell = by[2]};
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    if (!tb_slot_strikes(tb_slot(view, i))) continue;
    losses.head += tb_truncated_modes_loss(tb_slot_truncated(view, i), view->next.truncated[i],
                                           view->last.truncated[i]);
  }
  if (!view->state->wires.lifted) {
    losses.wires = model->kernels->wire_losses(
      model->wires.count, model->wires.lanes, view->state->wires.coefficients,
      view->next.v + TB_WIRE_FRONT, view->last.v + TB_WIRE_FRONT);
  }
  return losses;
}
