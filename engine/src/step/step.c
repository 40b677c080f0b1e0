/* SPDX-License-Identifier: MIT */
#include "step/step.h"

#include <math.h>
#include <string.h>

#include "air/high_band_step.h"
#include "air/incident_sound.h"
#include "air/mic_output.h"
#include "air/radiated_energy.h"
#include "heads/coupling.h"
#include "heads/hihat_air.h"
#include "heads/lug_forces.h"
#include "heads/pedal.h"
#include "heads/stretch.h"
#include "kernels/profile.h"
#include "step/edge_friction.h"
#include "step/energy.h"
#include "step/energy_guard.h"
#include "step/live_params.h"
#include "step/wire_clearance.h"
#include "strikers/stick.h"
#include "strikers/striker_hold.h"
#include "strikers/striker_pool.h"
#include "strikers/strokes.h"
#include "wires/pluck.h"
#include "wires/wire_motion.h"

#ifdef TABOR_PROFILE
_Thread_local TbProfile tb_profile;
#endif

/* The shape at rest is bent: a tension other than the rest's pulls it. */
static void pull_rest(TbView *view, uint32_t w) {
  const TaborModel *model = view->model;
  const TbWire *wire = &model->wires.wires[w];
  const TbWireCoefficients *c = &view->state->wires.coefficients[w];
  const uint32_t at = w * model->wires.lanes + TB_WIRE_FRONT;
  if (c->tension == wire->tension) return;
  const double pull = c->compliance * (c->tension - wire->tension) / wire->spacing;
  model->kernels->axpy(model->wires.lanes, view->next.v + at, pull, model->rest.bend + at);
}

static void free_wires(TbView *view) {
  const TbWires *wires = &view->model->wires;
  const TbPhase *next = &view->next, *now = &view->now, *last = &view->last;
  view->model->kernels->wire_step(wires->count, wires->lanes, view->state->wires.coefficients,
                                  wires->inner, now->v + TB_WIRE_FRONT, last->v + TB_WIRE_FRONT,
                                  view->bend + TB_WIRE_FRONT, next->v + TB_WIRE_FRONT);
  for (uint32_t w = 0; w < wires->count; w++) pull_rest(view, w);
  tb_pluck_pull(view);
}

/* Places of head and wires without contact forces, into view->next. */
static void free_motion(TbView *view) {
  TB_STAGE(MODES);
  tb_stretch_move(view);
  TB_STAGE(WIRES);
  if (!view->state->wires.lifted) free_wires(view);
  tb_stick_step(view);
}

/* The wires' rows of b. */
static void penetrate_wires(TbView *view, double *slots) {
  TB_STAGE(PROJECTION);
  tb_wire_motion_of(view)->project(view);
  TB_STAGE(STRETCH);
  tb_stretch_yield(view, slots);
  TB_STAGE(PROJECTION);
  tb_wire_motion_of(view)->penetrate(view);
}

/* 1 where the law acts on the sum of the last two instants' penetrations (contact_law.h), which
 * stands in view->last.eta during the solve; otherwise 0. */
static double law_of_sum(const TbView *view, uint32_t slot) {
  return tb_slot_strikes(tb_slot(view, slot)) ? 1.0 : 0.0;
}

/* b: the change of penetration over two steps without contact forces, with the load at rest. If a
 * law acts on a sum, the sum stands in view->last.eta until respond() takes it out again. */
static void free_penetration(TbView *view) {
  const TaborModel *model = view->model;
  _Alignas(64) double slots[TB_SLOTS] = {0.0};
  if (view->state->wires.lifted) {
    tb_stretch_yield(view, slots);
  } else {
    penetrate_wires(view, slots);
  }
  TB_STAGE(STRIKERS);
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    if (!tb_slot_in_play(tb_slot(view, i))) continue;
    const uint32_t row = tb_slot_row(&model->rows, i);
    const double head = tb_pool_displacement(view, i, view->next.q);
    double eta = head;
    if (tb_slot_strikes(tb_slot(view, i))) {
      const TbTruncatedModes *truncated = tb_slot_truncated(view, i);
      tb_truncated_modes_step(truncated, view->next.truncated[i], view->now.truncated[i],
                              view->last.truncated[i]);
      eta += tb_truncated_modes_displacement(truncated, view->next.truncated[i]) -
             (tb_hold_free_height(view, i) - tb_slot(view, i)->bristles.coat);
      if (tb_slot(view, i)->end.bends) eta -= tb_stick_bow(view, i, &view->next);
    }
    view->b[row] = (eta - view->last.eta[row]) + view->rest_load[row] + slots[i];
    view->last.eta[row] += law_of_sum(view, i) * view->now.eta[row];
  }
}

/* Forces of the wires on the modes, counted from rest: into view->modal. */
static void force_modes(TbView *view) {
  const TaborModel *model = view->model;
  model->kernels->subtract(model->projection.wire_grid.size, view->solve.warm.grid,
                           model->rest.grid, view->change);
  tb_wire_motion_of(view)->project_forces(view);
}

/* Adds the effect of the wires' contact forces, which are those of the last step if `unchanged`. */
static void respond_to_wires(TbView *view, bool unchanged) {
  const TaborModel *model = view->model;
  const TbModes *modes = &model->modes;
  const TbKernels *kernels = model->kernels;
  const uint32_t stride = model->wires.stride;
  const double *force = view->solve.warm.force;
  TB_STAGE(WIRES);
  kernels->move_wires(stride, view->contact_compliance, force, model->rest.force, view->last.eta,
                      view->s, view->next.v + TB_WIRE_FRONT, view->next.eta);
  TB_STAGE(PROJECTION);
  if (!unchanged) force_modes(view);
  TB_STAGE(MODES);
  kernels->add_product(modes->group[modes->groups], view->next.q, modes->pull, view->modal);
}

/* Adds what all contact forces do to the free motion in view->next. Lifted wires touch nothing, at
 * rest neither, so they add nothing. */
static void respond(TbView *view, bool unchanged) {
  const TaborModel *model = view->model;
  const double *force = view->solve.warm.force;
  if (!view->state->wires.lifted) respond_to_wires(view, unchanged);
  TB_STAGE(STRIKERS);
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    if (!tb_slot_in_play(tb_slot(view, i))) continue;
    const uint32_t row = tb_slot_row(&model->rows, i);
    if (force[row] != 0.0) {
      tb_pool_push(view, i, -force[row], view->next.q);
      tb_truncated_modes_press(tb_slot_truncated(view, i), force[row], view->next.truncated[i]);
    }
    view->next.z[i] = tb_hold_free_height(view, i) + view->contact_compliance[row] * force[row];
    if (tb_slot_is_end(tb_slot(view, i))) view->next.z[i] += tb_stick_pull(view, i);
    if (tb_slot(view, i)->end.bends) tb_stick_press(view, i, force[row]);
    view->last.eta[row] -= law_of_sum(view, i) * view->now.eta[row];
    view->next.eta[row] = view->last.eta[row] + view->s[row];
  }
}

/* The last pass over the modes: adds what stretching heads do to view->next, and finds what the
 * modes lost in the step and what microphone `mic` hears of them. All of it needs only the finished
 * displacements, so one pass reads them once. */
static void end_modes(TbView *view, uint32_t mic) {
  const TaborModel *model = view->model;
  const TbModes *modes = &model->modes;
  TbModesEnd *end = &view->end;
  const bool heard = mic < model->def.mic_count;
  *end = (TbModesEnd){.stretched = view->stretch.count > 0,
                      .origins = modes->walls ? 3 : 2,
                      .pull = {view->stretch.pull[0], view->stretch.pull[1]},
                      .last = view->last.q,
                      .loss = {modes->loss_head, modes->loss_air, modes->loss_shell},
                      .ahead = heard ? model->mics[mic].ahead : modes->loss_air,
                      .behind = heard ? model->mics[mic].behind : modes->loss_air,
                      .stretch = {end->stretch[0], end->stretch[1]},
                      .next = view->next.q};
  view->mics.ear = heard ? mic : TB_NO_EAR;
  model->kernels->end_modes(&view->moving, end);
}

/* With the modes' losses of end_modes(), unless the step was shortened after them. */
static void book_losses(TbView *view, bool shortened) {
  const TbLosses losses = shortened ? tb_losses(view) : tb_losses_with(view, view->end.lost);
  TaborLedger *sums = &view->state->ledger.sums;
  const double beyond = tb_radiated_beyond(view); /* the modes lost it as heads: radiated_power.h */
  view->state->ledger.radiated_beyond += beyond;
  sums->head_loss += losses.head - beyond;
  sums->radiated += losses.radiated + beyond;
  sums->shell_loss += losses.shell;
  sums->wire_loss += losses.wires;
  const TbHoldWork hands = tb_hold_work(view);
  const double sound = tb_incident_work(view), plucks = tb_pluck_work(view);
  view->state->ledger.sound_work += sound;
  sums->injected += hands.done + sound + plucks;
  sums->damper_loss += hands.lost;
  if (!tb_pedal_rests(view)) sums->control += tb_pedal_work(view);
  sums->contact_loss += tb_hihat_air_end(view);
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

/* The forces that the solve found could not be balanced, and the step was shortened: nothing of
 * them is to be kept. */
static void forget_forces(TbView *view) {
  tb_solve_forget(&view->solve);
  tb_stretch_clear(view);
  view->mics.ear = TB_NO_EAR;
}

/* Energy that the contacts took, and the losses of all parts. If the forces would create energy,
 * the guard shortens the step first. */
static void close_ledger(TbView *view, const TbSolveOutcome *outcome) {
  bool shortened = outcome->excess > 0.0 && tb_energy_guard(view);
  if (shortened) {
    forget_forces(view);
  } else {
    view->state->ledger.sums.contact_loss += outcome->contact_loss;
    view->state->ledger.sums.damper_loss += outcome->damper_loss;
    shortened = tb_edge_friction(view);
    if (shortened) view->mics.ear = TB_NO_EAR;
  }
  book_losses(view, shortened);
}

static void wake_by_sound(TbView *view) {
  if (view->all_move || !tb_incident_pushes_all(view)) return;
  tb_pool_wake(view, NULL);
  tb_coupling_renew(view);
}

/* Everything is first moved without contact forces; the solve finds the forces; then they move
 * everything. Each line says what it reads -> what it writes, beside model and state: q of modes, v
 * of wires, z of strikers and eta, the penetrations of rows, are those of the instants next, now
 * and last; b, s and f = solve.warm.force are rows of the solve (solve.h). */
void tb_step(TbView *view, uint32_t heard, double *pressure) {
  wake_by_sound(view);
  /* live values -> coefficients of wires, grips, mufflers, gains; what that moves: now.eta,
   * last.eta, ledger */
  tb_live_params_step(view);
  TB_STAGE(STRIKERS);
  tb_hands_step(view);      /* brushes -> places of their slots, now.eta, last.eta, ledger */
  free_motion(view);        /* now, last -> next: q, v, bow */
  tb_incident_push(view);   /* sound from outside -> next.q */
  tb_lug_forces_pull(view); /* now.q -> next.q */
  if (!tb_pedal_rests(view)) tb_pedal_push(view); /* pedal -> next.q */
  tb_hihat_air_push(view);                        /* now.eta; next.q, last.q -> next.q */
  TB_STAGE(STRETCH);
  tb_stretch_free(view);  /* next.q, now.q, last.q -> stretch of this step: r and W of stretch.h */
  free_penetration(view); /* next, r, W -> b, next.truncated, and last.eta as the laws want it */
  TB_STAGE(STRETCH);
  tb_stretch_renew(view); /* f, r, W -> M f, from which the solve starts */
  TB_STAGE(LAWS);
  const TbSolveOutcome outcome = tb_solve(&view->solve); /* b, last.eta, M f -> f, s */
  count(&view->state->ledger.statistics, &outcome);
  const bool unchanged = !outcome.contact && view->state->airborne;
  respond(view, unchanged); /* f, s -> next: q, v, z, eta, truncated, bow */
  TB_STAGE(STRETCH);
  tb_stretch_respond(view); /* f, r, W -> force of the stretch */
  /* that force -> next.q; next.q, last.q -> losses, and what the first microphone hears */
  end_modes(view, tb_first_heard(heard));
  TB_STAGE(LEDGER);
  close_ledger(view, &outcome); /* next, now, last -> ledger; next, if it is shortened */
  /* f, s, next.q -> next.high, delay lines, pressure */
  tb_mic_output(view, heard, unchanged, pressure);
  TB_STAGE(OTHER);
  tb_pluck_follow(view); /* fingers that are done let go */
  view->state->airborne = !outcome.contact;
  view->state->clock++;
  tb_view_rotate(view);           /* next becomes now */
  tb_pool_retire(view);           /* now -> hands ease, slots that are done are free */
  tb_wire_clearance_follow(view); /* now.q -> whether the wires are out of its reach */
}
