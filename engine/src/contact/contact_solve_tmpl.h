/* SPDX-License-Identifier: MIT */
/* The part of the contact solve that both precisions share (contact_solve.h): compiled with
 * contact_solve.c and contact_solvef.c, which have each precision's own input, Newton step and
 * iteration; see real.h. */
#ifndef TB_CONTACT_SOLVE_TMPL_H
#define TB_CONTACT_SOLVE_TMPL_H

#include "contact/contact_solve.h"

#include <math.h>
#include <string.h>

#include "contact/slot_compliance.h"
#include "kernels/profile.h"
#include "kernels/real.h"

typedef TYPE_OF(TbKernels) Kernels;
typedef TYPE_OF(TbSolveWork) Work;
typedef TYPE_OF(TbStart) Start;
typedef TYPE_OF(TbEnd) End;
typedef TYPE_OF(TbResidual) Residual;
typedef TYPE_OF(TbBalance) Balance;

/* Forces are balanced where they lose this part of the work that makes up the balance, and as far
 * on either side: in single precision sums are right to a tenth of it, and nothing may be
 * gained. */
static const Real BALANCE_AIM = REAL(SINGLE ? 1.5e-6 : 0.0);
static const Real BALANCE_WINDOW = REAL(SINGLE ? 1.5e-6 : 1e-13);
static const uint32_t MOST_BALANCE_STEPS = SINGLE ? 4 : 8;
static const Real BALANCE_REACH = REAL(SINGLE ? 0.25 : 0.1);
/* A point goes no farther than this many times its free way and the depth of contacts. */
static const Real FARTHEST = REAL(100.0);

static const Kernels *kernels_of(const TbSolve *solve) { return solve->in.NAME_OF(kernels); }
static Work *work_of(TbSolve *solve) { return &solve->NAME_OF(work); }

/* The slots' rows stand last; they are skipped while none is in play. */
static uint32_t total_rows(const TbSolve *solve) {
  return tb_wire_rows(&solve->in.rows) + (solve->in.slot_mask ? TB_SLOTS : 0u);
}

/* ---- what each precision brings -------------------------------------------------------------- */

/* The input, in the solve's own precision. */
static const Real *b_of(const TbSolve *solve);
static const Real *y_of(const TbSolve *solve);
static const Real *contact_compliance_of(const TbSolve *solve);
/* sqrt(y), and what a row's own point gives to a force there; NULL where the kernels do without
 * them. */
static const Real *root_of(const TbSolve *solve);
static const Real *yield_of(const TbSolve *solve);
/* Whether wire points take part at s. */
static bool wires_touch(const TbSolve *solve, const Real *s);
/* The last forces on the grid, and the new ones, from and to the drum. */
static void take_grid(TbSolve *solve);
static void give_grid(TbSolve *solve);
/* Adds the part of slots and stretching heads in M x, beside the wires. */
static void add_others(TbSolve *solve, const Real *x, const Real *grid, Real *out);

/* ---- M x ------------------------------------------------------------------------------------ */

/* out = M x, and x on the grid; without `wires` x is 0 at all wire points. */
static void product_of(TbSolve *solve, bool wires, const Real *x, Real *grid, Real *out) {
  const Kernels *kernels = kernels_of(solve);
  const Work *work = work_of(solve);
  const TYPE_OF(TbWireGrid) *wire_grid = solve->in.NAME_OF(wire_grid);
  TB_STAGE(PRODUCT);
  if (wires) {
    kernels->rows_to_grid(wire_grid, x, work->scratch, grid);
    kernels->apply_compliance(solve->in.NAME_OF(compliance), grid, work->answer);
  } else {
    memset(grid, 0, wire_grid->size * sizeof *grid);
    memset(work->answer, 0, wire_grid->size * sizeof *grid);
  }
  add_others(solve, x, grid, out);
  if (solve->in.lifted) {
    memset(out, 0, tb_wire_rows(&solve->in.rows) * sizeof *out);
  } else {
    kernels->grid_to_rows(wire_grid, work->answer, work->scratch, out);
  }
  kernels->add_product(total_rows(solve), out, contact_compliance_of(solve), x);
  TB_STAGE(LAWS);
}

/* ---- laws ----------------------------------------------------------------------------------- */

static void slot_laws(TbSolve *solve, const Real *s) {
  const Work *work = work_of(solve);
  if (!solve->in.slot_mask) return;
  memset(work->law + tb_slot_row(&solve->in.rows, 0), 0, TB_SLOTS * sizeof(Real));
  memset(work->slope + tb_slot_row(&solve->in.rows, 0), 0, TB_SLOTS * sizeof(Real));
  memset(work->mean + tb_slot_row(&solve->in.rows, 0), 0, TB_SLOTS * sizeof(Real));
  for (uint32_t slot = 0; solve->in.slot_mask >> slot; slot++) {
    const uint32_t row = tb_slot_row(&solve->in.rows, slot);
    if (!tb_contacts_have_slot(&solve->in, slot)) continue;
    const TbContactLawResult law =
      tb_contact_law_force(&solve->in.slot_laws[slot], (double)y_of(solve)[row], (double)s[row]);
    work->law[row] = (Real)law.force;
    work->slope[row] = (Real)law.slope;
    work->mean[row] = (Real)law.mean;
  }
}

/* Forces, slopes and means of the laws at s. */
static void apply_laws(TbSolve *solve, const Real *s) {
  const Work *work = work_of(solve);
  const TYPE_OF(TbWireGrid) *wire_grid = solve->in.NAME_OF(wire_grid);
  if (work->wires) {
    kernels_of(solve)->laws(wire_grid->wires, wire_grid->lanes, solve->in.wire_laws, y_of(solve),
                            root_of(solve), s, work->law, work->slope, work->mean);
  }
  slot_laws(solve, s);
}

/* ---- one Newton step ------------------------------------------------------------------------ */

/* Conjugate gradients [HestenesStiefel1952] on A x = d, A = I + W M W, W = diag(weight), from x,
 * r = `residual` and p = `direction` on, rho = r.r given, until rho is `enough`:
 *   q = A p,  alpha = rho/p.q,  x += alpha p,  r -= alpha q,  beta = r.r/rho,  p = r + beta p.
 * Adds M W dx to `product`, and W dx on the grid to `grid`. */
static void solve_inner(TbSolve *solve, Real rho, uint32_t cap, Real enough) {
  const Kernels *kernels = kernels_of(solve);
  const Work *work = work_of(solve);
  const uint32_t rows = total_rows(solve), size = solve->in.wire_grid->size;
  Real *const x = work->solution, *const r = work->residual, *const p = work->direction;
  Real *const q = work->turned, *const w_p = work->turned; /* q takes the place of W p */
  Real *const m_w_p = work->moved, *const grid_w_p = work->pushed;
  Real beta = REAL(0.0);
  for (uint32_t i = 0; i < cap && rho > enough; i++) {
    if (i > 0) kernels->xpby(rows, beta, p, r);
    kernels->product(rows, w_p, work->weight, p);
    product_of(solve, work->wires, w_p, grid_w_p, m_w_p);
    const Real alpha = rho / kernels->cg_apply(rows, q, p, work->weight, m_w_p);
    const Real next = kernels->cg_advance(rows, alpha, x, p, r, q);
    kernels->axpy(rows, work->product, alpha, m_w_p);
    kernels->axpy(size, work->grid, alpha, grid_w_p);
    beta = next / rho;
    rho = next;
  }
}

/* ---- the balance ---------------------------------------------------------------------------- */

/* `yield` is NULL where the largest miss is not asked for. */
static Balance balance_at(TbSolve *solve, const Real *yield, const Real *s, Real t) {
  const Work *work = work_of(solve);
  return kernels_of(solve)->balance(total_rows(solve), t, yield, s, work->law, work->slope,
                                    work->force, work->force_last, work->product,
                                    work->product_last);
}

/* How far forces have to move along their change, f~ + t g, and the energy that is left over then,
 * lost. */
typedef struct Move {
  Real t, over;
} Move;

/* Finds the place at which the work of the forces is that of the laws, with the sums at s to begin
 * with, and leaves that place's laws; false where there is no such place up to `reach` away. */
static bool balance(TbSolve *solve, Balance sums, Real reach, Move *move) {
  const Work *work = work_of(solve);
  Real t = REAL(0.0);
  for (uint32_t i = 0;; i++) {
    const Real miss = sums.value + BALANCE_AIM * sums.size;
    *move = (Move){t, SINGLE ? -sums.value : REAL(0.0)};
    if (REAL_SIZE(miss) <= BALANCE_WINDOW * sums.size) return true;
    t -= miss / sums.derivative;
    if (i == MOST_BALANCE_STEPS || !(REAL_SIZE(t) <= reach)) return false;
    kernels_of(solve)->extrapolate(total_rows(solve), -t, work->product, work->product_last,
                                   work->s, work->turned);
    apply_laws(solve, work->turned);
    sums = balance_at(solve, NULL, work->turned, t);
  }
}

/* ---- the end -------------------------------------------------------------------------------- */

/* Moves the forces at `rows` rows from `from` on, and gives them back. */
static End give_rows(TbSolve *solve, uint32_t from, uint32_t rows, Real t) {
  const Work *work = work_of(solve);
  End end = {.t = t,
             .b = b_of(solve) + from,
             .f = work->force + from,
             .f_last = work->force_last + from,
             .p = work->product + from,
             .p_last = work->product_last + from,
             .law = work->law + from,
             .mean = work->mean + from,
             .slope = work->slope + from,
             .to_f = solve->warm.force + from,
             .to_p = solve->warm.product + from,
             .to_s = solve->s + from};
  kernels_of(solve)->finish(rows, &end);
  return end;
}

/* Books what the laws lose, at the wires and at the slots' own forces. */
static void book(TbSolve *solve, Real wires_lost, uint32_t touching, TbSolveOutcome *outcome) {
  const Work *work = work_of(solve);
  double contact = (double)wires_lost, damper = 0.0;
  outcome->touching = touching;
  for (uint32_t slot = 0; solve->in.slot_mask >> slot; slot++) {
    if (!tb_contacts_have_slot(&solve->in, slot)) continue;
    const uint32_t row = tb_slot_row(&solve->in.rows, slot);
    const bool hand = solve->in.slot_laws[slot].kind == TB_CONTACT_LAW_DAMPER;
    *(hand ? &damper : &contact) +=
      solve->s[row] * ((double)work->law[row] - (double)work->mean[row]);
  }
  outcome->contact_loss = 0.5 * contact;
  outcome->damper_loss = 0.5 * damper;
}

/* The same for the slots' rows; returns how many touch. */
static uint32_t give_slots(TbSolve *solve, Real t) {
  return solve->in.slot_mask ? give_rows(solve, tb_wire_rows(&solve->in.rows), TB_SLOTS, t).touching
                             : 0u;
}

/* The forces where they are balanced, and what the laws lose there. */
static void give_back(TbSolve *solve, Move move, TbSolveOutcome *outcome) {
  const End wires = give_rows(solve, 0, tb_wire_rows(&solve->in.rows), move.t);
  const uint32_t touching = wires.touching + give_slots(solve, move.t);
  book(solve, wires.lost + move.over, touching, outcome);
}

/* The wires' forces on the grid, moved along with the others. */
static void move_grid(TbSolve *solve, Real t) {
  const Work *work = work_of(solve);
  kernels_of(solve)->extrapolate(solve->in.wire_grid->size, t, work->grid, work->grid_last,
                                 work->grid, work->grid);
  give_grid(solve);
}

static void evaluate(TbSolve *solve) {
  Work *work = work_of(solve);
  work->wires = work->wires || wires_touch(solve, work->s);
  apply_laws(solve, work->s);
}

/* Whether forces and laws agree to `enough` at s, and forces balance up to `reach` away; then all
 * is given back. It is no end where wires touch there that took no part. */
static bool settles(TbSolve *solve, Real enough, Real reach, TbSolveOutcome *outcome) {
  const Work *work = work_of(solve);
  Move move;
  evaluate(solve);
  const Balance sums = balance_at(solve, yield_of(solve), work->s, REAL(0.0));
  if (!(sums.miss <= enough)) return false;
  if (balance(solve, sums, reach, &move)) {
    give_back(solve, move, outcome);
    move_grid(solve, move.t);
    if (work->wires || !wires_touch(solve, work->s)) return true;
  }
  evaluate(solve); /* it has left the laws of another place */
  return false;
}

/* ---- the solve ------------------------------------------------------------------------------ */

/* A step that was solved too coarsely, over contacts too stiff for it, throws points about; the
 * next one would throw them farther, since forces with loss grow with the square of s. */
static bool goes_astray(Real way, Start size) {
  return !(way <= FARTHEST * (size.change + size.depth));
}

#endif
