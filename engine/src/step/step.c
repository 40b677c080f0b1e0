/* SPDX-License-Identifier: MIT */
#include "step/step.h"

#include <math.h>
#include <string.h>

#include "kernels/profile.h"
#include "step/brush.h"
#include "step/energy.h"
#include "step/energy_guard.h"
#include "step/high_band_step.h"
#include "step/incident_sound.h"
#include "step/live_params.h"
#include "step/lug_forces.h"
#include "step/mic_output.h"
#include "step/modes_end.h"
#include "step/radiated_energy.h"
#include "step/reset.h"
#include "step/stick_rigid.h"
#include "step/stretch.h"
#include "step/striker_pool.h"
#include "step/wire_clearance.h"
#include "step/wire_motion.h"

#ifdef TABOR_PROFILE
_Thread_local TbProfile tb_profile;
#endif

/* The shape at rest is bent: a tension other than the rest's pulls it. */
static void pull_rest(TbView *view, uint32_t w) {
  const TaborModel *model = view->model;
  const TbWire *wire = &model->wires.wires[w];
  const TbWireCoefficients *c = &view->state->wires[w];
  const uint32_t at = w * model->wires.lanes + TB_WIRE_FRONT;
  if (c->tension == wire->tension) return;
  const double pull = c->compliance * (c->tension - wire->tension) / wire->spacing;
  model->kernels->add_scaled(model->wires.lanes, view->next.v + at, pull, model->rest.bend + at);
}

static void free_wires(TbView *view) {
  const TbWires *wires = &view->model->wires;
  const TbPhase *next = &view->next, *now = &view->now, *last = &view->last;
  view->model->kernels->wire_step(wires->count, wires->lanes, view->state->wires, wires->inner,
                                  now->v + TB_WIRE_FRONT, last->v + TB_WIRE_FRONT,
                                  view->bend + TB_WIRE_FRONT, next->v + TB_WIRE_FRONT);
  for (uint32_t w = 0; w < wires->count; w++) pull_rest(view, w);
}

/* Where head and wires would be without contact forces, into view->next. */
static void free_motion(TbView *view) {
  TB_STAGE(MODES);
  tb_stretch_move(view);
  TB_STAGE(WIRES);
  if (!view->state->lifted) free_wires(view);
  tb_rigid_stick_step(view);
}

/* b = change of penetration over two steps without contact forces, with the rest load: of the wires, */
static void penetrate_wires(TbView *view, double *slots) {
  TB_STAGE(PROJECTION);
  tb_wire_motion_of(view)->project(view);
  TB_STAGE(STRETCH);
  tb_stretch_yield(view, slots);
  TB_STAGE(PROJECTION);
  tb_wire_motion_of(view)->penetrate(view);
}

/* 1 where the law acts on the sum of the last two instants' penetrations (contact_law.h), which stands in
 * view->last.eta during the solve; otherwise 0. */
static double law_of_sum(const TbView *view, uint32_t slot) {
  return view->state->slots[slot].kind == TB_SLOT_STRIKER ? 1.0 : 0.0;
}

/* ... and of all. */
static void free_penetration(TbView *view) {
  const TaborModel *model = view->model;
  const TbKernels *kernels = model->kernels;
  _Alignas(64) double slots[TB_SLOTS] = {0.0};
  if (view->state->lifted) {
    tb_stretch_yield(view, slots);
  } else {
    penetrate_wires(view, slots);
  }
  TB_STAGE(STRIKERS);
  for (uint32_t i = 0; view->state->slot_mask >> i; i++) {
    if (view->state->slots[i].kind == TB_SLOT_FREE) continue;
    const uint32_t row = model->wires.stride + i;
    const double head = kernels->dot(model->modes.padded, tb_slot_shape(view, i), view->next.q);
    double eta = head;
    if (view->state->slots[i].kind == TB_SLOT_STRIKER) {
      const TbResidualModes *missing = tb_slot_missing(view, i);
      tb_residual_modes_step(missing, view->next.missing[i], view->now.missing[i],
                             view->last.missing[i]);
      eta += tb_residual_modes_displacement(missing, view->next.missing[i]) -
             (tb_pool_free_height(view, i) - view->state->slots[i].coat);
      if (view->state->slots[i].bends) eta -= tb_rigid_stick_bow(view, i, &view->next);
    }
    view->b[row] = (eta - view->last.eta[row]) + view->rest_load[row] + slots[i];
    view->last.eta[row] += law_of_sum(view, i) * view->now.eta[row];
  }
}

/* What the wires' forces, counted from rest, do to modes: into view->modal. */
static void force_modes(TbView *view) {
  const TaborModel *model = view->model;
  model->kernels->subtract(model->projection.wire_grid.size, view->solve.warm.grid,
                           model->rest.grid, view->change);
  tb_wire_motion_of(view)->project_forces(view);
}

/* Adds what the contact forces do to the free motion in view->next, `unchanged` if they are those of the
 * last step: of the wires, */
static void respond_to_wires(TbView *view, bool unchanged) {
  const TaborModel *model = view->model;
  const TbModes *modes = &model->modes;
  const TbKernels *kernels = model->kernels;
  const uint32_t stride = model->wires.stride;
  const double *force = view->solve.warm.force;
  TB_STAGE(WIRES);
  kernels->move(stride, view->own, force, model->rest.force, view->last.eta, view->s,
                view->next.v + TB_WIRE_FRONT, view->next.eta);
  TB_STAGE(PROJECTION);
  if (!unchanged) force_modes(view);
  TB_STAGE(MODES);
  kernels->add_product(modes->group[modes->groups], view->next.q, modes->pull, view->modal);
}

/* ... and of all. */
static void respond(TbView *view, bool unchanged) {
  const TaborModel *model = view->model;
  const TbModes *modes = &model->modes;
  const TbKernels *kernels = model->kernels;
  const uint32_t stride = model->wires.stride;
  const double *force = view->solve.warm.force;
  if (!view->state->lifted) respond_to_wires(view, unchanged);
  TB_STAGE(STRIKERS);
  for (uint32_t i = 0; view->state->slot_mask >> i; i++) {
    if (view->state->slots[i].kind == TB_SLOT_FREE) continue;
    const uint32_t row = stride + i;
    if (force[row] != 0.0) {
      kernels->add_scaled(modes->padded, view->next.q, -force[row], tb_slot_drive(view, i));
      tb_residual_modes_press(tb_slot_missing(view, i), force[row], view->next.missing[i]);
    }
    view->next.z[i] = tb_pool_free_height(view, i) + view->own[row] * force[row];
    if (view->state->slots[i].partner) view->next.z[i] += tb_rigid_stick_pull(view, i);
    if (view->state->slots[i].bends) tb_rigid_stick_press(view, i, force[row]);
    view->last.eta[row] -= law_of_sum(view, i) * view->now.eta[row];
    view->next.eta[row] = view->last.eta[row] + view->s[row];
  }
}

/* With the modes' losses of modes_end.h, unless the step was shortened after them. */
static void book_losses(TbView *view, bool shortened) {
  const TbLosses losses = shortened ? tb_losses(view) : tb_losses_with(view, view->end.lost);
  TaborLedger *sums = &view->state->sums;
  const double beyond = tb_radiated_beyond(view);
  view->state->radiated_beyond += beyond;
  sums->head_loss += losses.head - beyond;
  sums->radiated += losses.radiated + beyond;
  sums->shell_loss += losses.shell;
  sums->wire_loss += losses.wires;
  const TbHandWork hands = tb_pool_hand_work(view);
  const double sound = tb_incident_work(view);
  view->state->sound_work += sound;
  sums->injected += hands.done + sound;
  sums->damper_loss += hands.lost;
}

static void count(TaborStatistics *statistics, const TbSolveOutcome *outcome) {
  if (!outcome->contact) return;
  statistics->solves++;
  statistics->newton_iterations += outcome->iterations;
  if (outcome->iterations > statistics->newton_max) statistics->newton_max = outcome->iterations;
  statistics->newton_capped += outcome->capped;
  statistics->work_corrected += outcome->corrected;
  statistics->fallbacks += outcome->fallback;
  statistics->contact_sum += outcome->touching;
  if (outcome->touching > statistics->contact_max) statistics->contact_max = outcome->touching;
}

void tb_step(TbView *view, uint32_t heard, double *pressure) {
  tb_live_params_step(view);
  TB_STAGE(STRIKERS);
  tb_brush_step(view);
  free_motion(view);
  tb_incident_push(view);
  tb_lug_forces_pull(view);
  TB_STAGE(STRETCH);
  tb_stretch_free(view);
  free_penetration(view);
  TB_STAGE(STRETCH);
  tb_stretch_renew(view);
  TB_STAGE(LAWS);
  const TbSolveOutcome outcome = tb_solve(&view->solve);
  count(&view->state->statistics, &outcome);
  const bool unchanged = !outcome.contact && view->state->airborne;
  respond(view, unchanged);
  TB_STAGE(STRETCH);
  tb_stretch_respond(view);
  tb_modes_end(view, tb_first_heard(heard));
  TB_STAGE(LEDGER);
  const bool shortened = outcome.excess > 0.0 && tb_energy_guard(view);
  if (shortened) {
    tb_solve_forget(&view->solve);
    tb_stretch_clear(view);
    view->ear = TB_NO_EAR;
  } else {
    view->state->sums.contact_loss += outcome.contact_loss;
    view->state->sums.damper_loss += outcome.damper_loss;
  }
  book_losses(view, shortened);
  tb_mic_output(view, heard, unchanged, pressure);
  TB_STAGE(OTHER);
  view->state->airborne = !outcome.contact;
  view->state->clock++;
  tb_view_rotate(view);
  tb_pool_retire(view);
  tb_wire_clearance_follow(view);
}

/* ---- housekeeping --------------------------------------------------------------------------- */

/* Far below anything audible: a medium stroke brings some 1e-2 J. */
static const double SILENT_ENERGY[] = {
  [TB_IN_DOUBLE] = 1e-18, /* [J] */
  /* Rounding keeps wires that lie on a head moving: 5e-17 J for the heaviest of the presets' wires. */
  [TB_IN_FLOAT] = 1e-15,
};
static const uint32_t SILENT_CHECKS = 16;
static const double VANISHED = 1e-150; /* [m kg^1/2]; denormals begin at 1e-308 */

/* Without branches: the compiler takes several at once. */
static void clear_small(uint32_t n, double *now, double *last) {
  for (uint32_t i = 0; i < n; i++) {
    const bool gone = (fabs(now[i]) < VANISHED) & (fabs(last[i]) < VANISHED);
    now[i] = gone ? 0.0 : now[i];
    last[i] = gone ? 0.0 : last[i];
  }
}

static void clear_vanished(TbView *view) {
  tb_high_band_step_of(view)->clear_small(view);
  clear_small(view->model->modes.padded, view->now.q, view->last.q);
  clear_small(TB_SLOTS * TB_MISSING, view->now.missing[0], view->last.missing[0]);
  clear_small(TB_SLOTS * TB_BENDS, view->now.bow[0], view->last.bow[0]);
}

static void clear_high(TbView *view) {
  const size_t bytes = view->model->high.padded * sizeof(double);
  memset(view->now.high, 0, bytes);
  memset(view->last.high, 0, bytes);
  view->state->held = view->state->hold_steps = 0;
  view->state->contacts = (TbWireContacts){0.0, 0.0, 0.0};
}

static double silent_energy(const TaborModel *model) { return SILENT_ENERGY[model->contacts]; }

/* Stops all motion; a drum within rounding of its rest returns to it exactly. */
static void fall_asleep(TbView *view) {
  const TaborModel *model = view->model;
  const bool at_rest =
    fabs(tb_energy_stored(view, &view->now, &view->last)) < 10.0 * silent_energy(model);
  const uint32_t rows = model->wires.stride + TB_SLOTS;
  if (at_rest) {
    memset(view->now.q, 0, model->modes.padded * sizeof(double));
    memset(view->now.missing, 0, sizeof view->state->missing[0]);
    memset(view->state->bow, 0, sizeof view->state->bow);
    memset(view->now.v, 0, model->wires.node_count * sizeof(double));
    for (uint32_t row = 0; row < model->wires.stride; row++) {
      view->now.eta[row] = model->rest.eta[row] + view->state->shift[model->wires.row_wire[row]];
      view->solve.warm.force[row] = model->rest.force[row];
    }
    for (uint32_t i = 0; i < TB_SLOTS; i++) {
      if (view->state->slots[i].kind != TB_SLOT_FREE) view->now.eta[model->wires.stride + i] = 0.0;
    }
    tb_solve_product(&view->solve, view->solve.warm.force, view->solve.warm.grid,
                     view->solve.warm.product);
    tb_stretch_clear(view);
  }
  memcpy(view->last.q, view->now.q, model->modes.padded * sizeof(double));
  memcpy(view->last.v, view->now.v, model->wires.node_count * sizeof(double));
  memcpy(view->last.eta, view->now.eta, rows * sizeof(double));
  memcpy(view->last.z, view->now.z, TB_SLOTS * sizeof(double));
  memcpy(view->last.missing, view->now.missing, sizeof view->state->missing[0]);
  memcpy(view->last.bow, view->now.bow, sizeof view->state->bow[0]);
  for (uint32_t mic = 0; mic < model->def.mic_count; mic++) {
    memset(view->delay[mic], 0, (model->mics[mic].delay + 1u) * sizeof(double));
  }
  memset(view->state->treble, 0, sizeof view->state->treble);
  memset(view->state->halved, 0, sizeof view->state->halved);
  memset(view->state->response, 0, sizeof view->state->response);
  clear_high(view);
  view->state->heard = 0;
  view->state->asleep = 1;
}

static bool striker_in_flight(const TbView *view) {
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *slot = &view->state->slots[i];
    if (slot->palm || (slot->kind == TB_SLOT_STRIKER && !slot->held)) return true;
  }
  return false;
}

static bool parameter_moves(const TbState *state) {
  for (uint32_t i = 0; i < TB_LIVE_COUNT; i++) {
    if (state->live[i].left) return true;
  }
  return false;
}

void tb_step_housekeeping(TbView *view) {
  TbState *state = view->state;
  const double motion = tb_energy_motion(view, &view->now, &view->last);
  if (!isfinite(motion)) {
    const TaborStatistics statistics = state->statistics;
    const TbLiveParam output = state->output;
    tb_state_reset(state, view->model);
    state->statistics = statistics;
    state->output = output;
    state->statistics.recovered++;
    *view = tb_view(state, view->model);
    return;
  }
  clear_vanished(view);
  tb_wire_clearance_begin(view);
  tb_wire_motion_of(view)->settle(view);
  const bool quiet = motion < silent_energy(view->model) && !striker_in_flight(view) &&
                     !parameter_moves(state) && !tb_brush_moves(state);
  state->quiet_checks = quiet ? state->quiet_checks + 1 : 0;
  if (state->quiet_checks >= SILENT_CHECKS) fall_asleep(view);
}
