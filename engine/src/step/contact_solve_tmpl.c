/* SPDX-License-Identifier: MIT */
/* The contact solve (contact_solve.h), compiled once per precision: see real.h. */
#include "step/contact_solve.h"

#include <math.h>
#include <string.h>

#include "kernels/profile.h"
#include "kernels/real.h"
#include "step/slot_compliance.h"

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
#ifdef TB_FLOAT
/* Forces of single precision are right to this part of the largest: near a drum's rest that is all
 * they change. */
static const float NOISE = 2e-6f;
/* The part of the accepted difference between forces and laws that a step aims at, the first and
 * the next ones: laws are no lines. */
static const float FIRST_AIM = 0.8f, NEXT_AIM = 0.2f;
#endif
/* A point goes no farther than this many times its free way and the depth of contacts. */
static const Real FARTHEST = REAL(100.0);

static const Kernels *kernels_of(const TbSolve *solve) { return solve->in.NAME_OF(kernels); }
static Work *work_of(TbSolve *solve) { return &solve->NAME_OF(work); }

/* Those of the slots stand last; they are skipped while none is in play. */
static uint32_t total_rows(const TbSolve *solve) {
  return solve->in.stride + (solve->in.slot_mask ? TB_SLOTS : 0u);
}

/* ---- what the precisions do differently ------------------------------------------------------ */

#ifdef TB_FLOAT
/* The input rounded. */
static const float *b_of(const TbSolve *solve) { return solve->workf.b; }
static const float *y_of(const TbSolve *solve) { return solve->workf.y; }
static const float *own_of(const TbSolve *solve) { return solve->workf.own; }
static const float *root_of(const TbSolve *solve) { return solve->workf.root; }
static const float *yield_of(const TbSolve *solve) { return solve->workf.yield; }

static bool wires_touch(const TbSolve *solve, const float *s) {
  (void)solve, (void)s;
  return true;
}

static bool near(const TbSolve *solve) { return solve->in.near; }

/* What the head adds to the slots' own compliance. */
static void yield_at_slots(TbSolve *solve) {
  for (uint32_t slot = 0; solve->in.slot_mask >> slot; slot++) {
    if (!tb_slot_in_play(&solve->in, slot)) continue;
    const double head = solve->in.slot_coupling[slot * (TB_SLOTS + 1u)];
    solve->workf.yield[solve->in.stride + slot] += (float)head;
  }
}

/* The start from row `from` on: everything in single precision, s = b - M f of the last sample's forces. */
static TbStartF start_at(TbSolve *solve, uint32_t from) {
  TbSolveWorkF *work = &solve->workf;
  return (TbStartF){.from_b = solve->in.b + from,
                    .from_p = solve->warm.product + from,
                    .from_y = solve->in.y + from,
                    .from_f = solve->warm.force + from,
                    .from_own = solve->in.own + from,
                    .p = work->product_last + from,
                    .f = work->force_last + from,
                    .s = work->s + from,
                    .b = work->b + from,
                    .y = work->y + from,
                    .root = work->root + from,
                    .own = work->own + from,
                    .head = solve->in.yield + from,
                    .yield = work->yield + from};
}

static void take_stretch(TbSolve *solve) {
  for (uint32_t h = 0; h < solve->in.stretch_count; h++) {
    solve->in.kernelsf->narrow(solve->in.wire_gridf->size, solve->in.stretch_grid[h],
                               solve->workf.stretch[h]);
  }
}

static void take_grid(TbSolve *solve) {
  solve->in.kernelsf->narrow(solve->in.wire_gridf->size, solve->warm.grid, solve->workf.grid_last);
}

static void give_grid(TbSolve *solve) {
  solve->in.kernelsf->widen(solve->in.wire_gridf->size, solve->workf.grid, solve->warm.grid);
}

/* What the slots add to M x: few numbers, in double as ever. */
static void add_slots(TbSolve *solve, const float *x, const float *grid, float *out) {
  const TbKernelsF *kernels = solve->in.kernelsf;
  TbSolveWorkF *work = &solve->workf;
  const uint32_t size = solve->in.wire_gridf->size;
  double *pushed = solve->work.pushed, *answer = solve->work.answer;
  _Alignas(64) double slots[TB_SLOTS], moved[TB_SLOTS];
  kernels->widen(size, grid, pushed);
  kernels->widen(size, work->answer, answer);
  kernels->widen(TB_SLOTS, x + solve->in.stride, slots);
  tb_solve_slots(&solve->in, pushed, slots, answer, moved);
  tb_solve_stretch(&solve->in, pushed, slots, answer, moved);
  kernels->narrow(size, answer, work->answer);
  kernels->narrow(TB_SLOTS, moved, out + solve->in.stride);
}

/* What the stretching of the heads adds to it where no slot is in play. */
static void add_stretch(TbSolve *solve, const float *grid, float *out) {
  const TbKernelsF *kernels = solve->in.kernelsf;
  TbSolveWorkF *work = &solve->workf;
  const uint32_t size = solve->in.wire_gridf->size;
  float along[2] = {0.0f, 0.0f};
  for (uint32_t h = 0; h < solve->in.stretch_count; h++) {
    along[h] = kernels->dot(size, work->stretch[h], grid);
  }
  for (uint32_t h = 0; h < solve->in.stretch_count; h++) {
    const double *w = solve->in.stretch_weight[h];
    const float pull = -((float)w[0] * along[0] + (float)w[1] * along[1]);
    kernels->add_scaled(size, work->answer, pull, work->stretch[h]);
  }
  memset(out + solve->in.stride, 0, TB_SLOTS * sizeof *out);
}

static void add_others(TbSolve *solve, const float *x, const float *grid, float *out) {
  if (solve->in.slot_mask) {
    add_slots(solve, x, grid, out);
  } else {
    add_stretch(solve, grid, out);
  }
}
#else
static const double *b_of(const TbSolve *solve) { return solve->in.b; }
static const double *y_of(const TbSolve *solve) { return solve->in.y; }
static const double *own_of(const TbSolve *solve) { return solve->in.own; }
static const double *root_of(const TbSolve *solve) {
  (void)solve;
  return NULL;
}
static const double *yield_of(const TbSolve *solve) {
  (void)solve;
  return NULL;
}

/* Newton has converged when the residual is rounding noise of what it is a difference of. */
static bool is_noise(double residual, TbStart size) {
  static const double RELATIVE_TOLERANCE = 1e-14, PENETRATION_TOLERANCE = 4e-15;
  return residual <= RELATIVE_TOLERANCE * size.change + PENETRATION_TOLERANCE * size.depth;
}

static bool wires_touch(const TbSolve *solve, const double *s) {
  return solve->in.kernels->touches(solve->in.stride, solve->in.y, s, solve->warm.force);
}

static bool near(const TbSolve *solve) { return wires_touch(solve, solve->in.b); }

/* s = b - M f of the last sample's forces. */
static TbStart take_in(TbSolve *solve) {
  TbSolveWork *work = &solve->work;
  const uint32_t rows = total_rows(solve);
  TbStart start = {.from_b = solve->in.b,
                   .from_p = solve->warm.product,
                   .from_y = solve->in.y,
                   .from_f = solve->warm.force,
                   .p = work->product_last,
                   .f = work->force_last,
                   .s = work->s};
  solve->in.kernels->start(rows, &start);
  work->wires = wires_touch(solve, work->s);
  if (work->wires) return start;
  memset(work->law, 0, rows * sizeof(double));
  memset(work->slope, 0, rows * sizeof(double));
  memset(work->mean, 0, rows * sizeof(double));
  return start;
}

static void take_grid(TbSolve *solve) {
  memcpy(solve->work.grid_last, solve->warm.grid, solve->in.wire_grid->size * sizeof(double));
}

static void give_grid(TbSolve *solve) { (void)solve; } /* it is the drum's own */

static void add_others(TbSolve *solve, const double *x, const double *grid, double *out) {
  const double *slots = x + solve->in.stride;
  double *answer = solve->work.answer, *moved = out + solve->in.stride;
  tb_solve_slots(&solve->in, grid, slots, answer, moved);
  tb_solve_stretch(&solve->in, grid, slots, answer, moved);
}
#endif

/* ---- M x ------------------------------------------------------------------------------------ */

/* out = M x, and x on the grid; without `wires` x is 0 at all wire points. */
static void product_of(TbSolve *solve, bool wires, const Real *x, Real *grid, Real *out) {
  const Kernels *kernels = kernels_of(solve);
  const Work *work = work_of(solve);
  const TYPE_OF(TbWireGrid) *wire_grid = solve->in.NAME_OF(wire_grid);
  TB_STAGE(PRODUCT);
  if (wires) {
    kernels->contract(wire_grid, x, work->scratch, grid);
    kernels->comply(solve->in.NAME_OF(compliance), grid, work->answer);
  } else {
    memset(grid, 0, wire_grid->size * sizeof *grid);
    memset(work->answer, 0, wire_grid->size * sizeof *grid);
  }
  add_others(solve, x, grid, out);
  if (solve->in.lifted) {
    memset(out, 0, solve->in.stride * sizeof *out);
  } else {
    kernels->expand(wire_grid, work->answer, work->scratch, out);
  }
  kernels->add_product(total_rows(solve), out, own_of(solve), x);
  TB_STAGE(LAWS);
}

/* ---- laws ----------------------------------------------------------------------------------- */

static void slot_laws(TbSolve *solve, const Real *s) {
  const Work *work = work_of(solve);
  if (!solve->in.slot_mask) return;
  memset(work->law + solve->in.stride, 0, TB_SLOTS * sizeof(Real));
  memset(work->slope + solve->in.stride, 0, TB_SLOTS * sizeof(Real));
  memset(work->mean + solve->in.stride, 0, TB_SLOTS * sizeof(Real));
  for (uint32_t slot = 0; solve->in.slot_mask >> slot; slot++) {
    const uint32_t row = solve->in.stride + slot;
    if (!tb_slot_in_play(&solve->in, slot)) continue;
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

/* Goes on from the `residual` of (I + W M W) x = d, whose square is given, by conjugate gradients
 * until it is `enough`, W = diag(weight); adds M W dx to `product`, and W dx on the grid to
 * `grid`. */
static void solve_inner(TbSolve *solve, Real square, uint32_t cap, Real enough) {
  const Kernels *kernels = kernels_of(solve);
  const Work *work = work_of(solve);
  const uint32_t rows = total_rows(solve), size = solve->in.wire_grid->size;
  Real again = REAL(0.0); /* how much of the last direction the next one keeps */
  for (uint32_t i = 0; i < cap && square > enough; i++) {
    if (i > 0) kernels->redirect(rows, again, work->direction, work->residual);
    kernels->product(rows, work->turned, work->weight, work->direction);
    product_of(solve, work->wires, work->turned, work->pushed, work->moved);
    const Real bend = kernels->turn(rows, work->turned, work->direction, work->weight, work->moved);
    const Real step = square / bend;
    const Real next =
      kernels->advance(rows, step, work->solution, work->direction, work->residual, work->turned);
    kernels->add_scaled(rows, work->product, step, work->moved);
    kernels->add_scaled(size, work->grid, step, work->pushed);
    again = next / square;
    square = next;
  }
}

#ifdef TB_FLOAT
/* Forces move as if each row's own yielding and the head's right below it were all. Returns the
 * largest change. */
static float aim(TbSolve *solve) {
  const TbSolveWorkF *work = &solve->workf;
  return solve->in.kernelsf->aim(total_rows(solve), work->law, work->slope, work->yield,
                                 work->force, work->weight, work->solution);
}

/* Goes on from there until forces and laws, were these lines, would agree to `enough`: with the
 * wires' own yielding the larger part, that often takes a single product. Returns the largest
 * |s|. */
static float newton_step(TbSolve *solve, float enough) {
  const TbKernelsF *kernels = solve->in.kernelsf;
  const TbSolveWorkF *work = &solve->workf;
  const uint32_t rows = total_rows(solve);
  memcpy(work->before, work->product, rows * sizeof(float));
  product_of(solve, true, work->force, work->grid, work->product);
  const TbResidualF left =
    kernels->left_over(rows, work->slope, work->yield, work->weight, work->solution, work->product,
                       work->before, work->residual, work->direction);
  if (left.largest > enough) {
    const float part = enough / left.largest;
    solve_inner(solve, left.square, solve->in.inner_cap, left.square * part * part);
  }
  return kernels->follow(rows, work->law, work->weight, work->solution, work->b, work->product,
                         work->force, work->s);
}
#else
/* r = s + M f - b with the laws' forces, whose response is left in `product` and `grid`, and in
 * `direction` what the step is to solve for. */
static TbResidual find_residual(TbSolve *solve) {
  const TbSolveWork *work = &solve->work;
  product_of(solve, work->wires, work->law, work->grid, work->product);
  return solve->in.kernels->weigh(total_rows(solve), work->slope, work->s, solve->in.b,
                                  work->product, work->weight, work->direction);
}

/* From the laws at s on, whose residual has been found; force, product, grid and s follow. Returns
 * the largest |s|. */
static double newton_step(TbSolve *solve, TbResidual found, uint32_t cap, double tolerance) {
  const TbSolveWork *work = &solve->work;
  const uint32_t rows = total_rows(solve);
  memset(work->solution, 0, rows * sizeof(double));
  memcpy(work->residual, work->direction, rows * sizeof(double));
  solve_inner(solve, found.square, cap, found.square * tolerance * tolerance);
  return solve->in.kernels->follow(rows, work->law, work->weight, work->solution, solve->in.b,
                                   work->product, work->force, work->s);
}
#endif

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

/* Where the work of the forces is what the laws say, with the sums at s to begin with, and leaves
 * that place's laws; false where there is no such place up to `reach` away. */
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
  kernels_of(solve)->end(rows, &end);
  return end;
}

/* Books what the laws lose, at the wires and at the slots' own forces. */
static void book(TbSolve *solve, Real wires_lost, uint32_t touching, TbSolveOutcome *outcome) {
  const Work *work = work_of(solve);
  double contact = (double)wires_lost, damper = 0.0;
  outcome->touching = touching;
  for (uint32_t slot = 0; solve->in.slot_mask >> slot; slot++) {
    if (!tb_slot_in_play(&solve->in, slot)) continue;
    const uint32_t row = solve->in.stride + slot;
    const bool hand = solve->in.slot_laws[slot].kind == TB_CONTACT_LAW_DAMPER;
    *(hand ? &damper : &contact) +=
      solve->s[row] * ((double)work->law[row] - (double)work->mean[row]);
  }
  outcome->contact_loss = 0.5 * contact;
  outcome->damper_loss = 0.5 * damper;
}

/* The same for the slots' rows; returns how many touch. */
static uint32_t give_slots(TbSolve *solve, Real t) {
  return solve->in.slot_mask ? give_rows(solve, solve->in.stride, TB_SLOTS, t).touching : 0u;
}

/* The forces where they are balanced, and what the laws lose there. */
static void give_back(TbSolve *solve, Move move, TbSolveOutcome *outcome) {
  const End wires = give_rows(solve, 0, solve->in.stride, move.t);
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

#ifdef TB_FLOAT
/* Newton's iteration from the last sample's forces on, with the laws at s; true if all is given
 * back. */
static bool iterate(TbSolve *solve, TbStartF size, TbSolveOutcome *outcome) {
  const TbSolveWorkF *work = &solve->workf;
  const size_t bytes = total_rows(solve) * sizeof(float);
  memcpy(work->force, work->force_last, bytes);
  memcpy(work->product, work->product_last, bytes);
  const float first = aim(solve);
  if (first == 0.0f) {
    give_back(solve, (Move){0.0f, 0.0f}, outcome);
    return true;
  }
  take_grid(solve);
  const float wanted = (float)solve->in.tolerance * first, noise = NOISE * size.force;
  for (uint32_t i = 0; i < solve->in.cap; i++) {
    outcome->iterations = i + 1;
    if (i > 0) aim(solve);
    const float way = newton_step(solve, (i > 0 ? NEXT_AIM : FIRST_AIM) * wanted + noise);
    if (goes_astray(way, size)) return false;
    if (settles(solve, wanted + noise, BALANCE_REACH, outcome)) return true;
  }
  return false;
}
#else
static void take_law_forces(TbSolve *solve) {
  const TbSolveWork *work = &solve->work;
  memcpy(work->force, work->law, total_rows(solve) * sizeof(double));
  solve->in.kernels->change(total_rows(solve), solve->in.b, work->product, work->s);
}

/* Newton's iteration; true if it came to its end and all is given back. */
static bool newton(TbSolve *solve, TbStart size, double enough, bool *astray,
                   TbSolveOutcome *outcome) {
  const TbSolveWork *work = &solve->work;
  const uint32_t cap = solve->in.cap;
  double way = 0.0;
  for (uint32_t i = 0;; i++) {
    outcome->iterations = i;
    *astray = goes_astray(way, size);
    if (*astray) return false;
    if (i > 0 && settles(solve, enough, BALANCE_REACH, outcome)) return true;
    if (i == cap && solve->in.tolerance > 0.0) return false;
    const TbResidual found = find_residual(solve);
    if (is_noise(found.largest, size)) {
      take_law_forces(solve);
      give_back(solve, (Move){0.0, 0.0}, outcome);
      return true;
    }
    if (i == cap) {
      product_of(solve, work->wires, work->force, work->grid, work->product);
      solve->in.kernels->change(total_rows(solve), solve->in.b, work->product, work->s);
      return false;
    }
    way = newton_step(solve, found, solve->in.inner_cap, solve->in.inner_tolerance);
  }
}

/* Newton's iteration with the laws at s, and a balance where it came to no end. */
static bool iterate(TbSolve *solve, TbStart size, TbSolveOutcome *outcome) {
  const TbSolveWork *work = &solve->work;
  const double first =
    solve->in.kernels->difference(total_rows(solve), work->law, work->force_last);
  if (first == 0.0) {
    give_back(solve, (Move){0.0, 0.0}, outcome);
    return true;
  }
  take_grid(solve);
  bool astray = false;
  if (newton(solve, size, solve->in.tolerance * first, &astray, outcome)) return true;
  outcome->capped = true;
  outcome->corrected = !astray && settles(solve, INFINITY, 0.5, outcome);
  return outcome->corrected;
}
#endif

#ifndef TB_FLOAT
static bool solve_contacts(TbSolve *solve, TbSolveOutcome *outcome) {
  const TbStart size = take_in(solve);
  outcome->iterations = 0;
  apply_laws(solve, solve->work.s);
  return iterate(solve, size, outcome);
}
#endif

/* ---- for others ----------------------------------------------------------------------------- */

#ifdef TB_FLOAT
static void product(TbSolve *solve, const double *x, double *grid, double *out) {
  const TbKernelsF *kernels = solve->in.kernelsf;
  const TbSolveWorkF *work = &solve->workf;
  const uint32_t rows = solve->in.stride + TB_SLOTS;
  kernels->narrow(rows, solve->in.own, work->own);
  kernels->narrow(rows, x, work->turned);
  product_of(solve, true, work->turned, work->grid, work->moved);
  kernels->widen(solve->in.wire_gridf->size, work->grid, grid);
  kernels->widen(rows, work->moved, out);
}
#else
static void product(TbSolve *solve, const double *x, double *grid, double *out) {
  product_of(solve, true, x, grid, out);
}

void tb_contact_newton_step(TbSolve *solve, uint32_t inner_cap, double inner_tolerance) {
  newton_step(solve, find_residual(solve), inner_cap, inner_tolerance);
}

const TbContactMethod tb_contact_method = {near, solve_contacts, product};
#endif
