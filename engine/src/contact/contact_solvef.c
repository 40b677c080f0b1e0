/* SPDX-License-Identifier: MIT */
/* The contact solve in single precision. Forces that move as if rows did not feel each other, and a
 * balance along this change, are accepted in some 97 of 100 samples of the stock snare. So this is
 * tried first, in few passes over the rows that keep nothing of the laws; the iteration takes the
 * other samples from the beginning. */
#define TB_FLOAT
#include "contact/contact_solve_tmpl.h"

/* Forces of single precision are right to this part of the largest: near a drum's rest that is all
 * they change. */
static const float NOISE = 2e-6f;
/* The part of the accepted difference between forces and laws that a step aims at, the first and
 * the next ones: laws are no lines. */
static const float FIRST_AIM = 0.8f, NEXT_AIM = 0.2f;

/* ---- input ---------------------------------------------------------------------------------- */

/* The input rounded. */
static const float *b_of(const TbSolve *solve) { return solve->workf.b; }
static const float *y_of(const TbSolve *solve) { return solve->workf.y; }
static const float *contact_compliance_of(const TbSolve *solve) {
  return solve->workf.contact_compliance;
}
static const float *root_of(const TbSolve *solve) { return solve->workf.root; }
static const float *yield_of(const TbSolve *solve) { return solve->workf.yield; }

static bool wires_touch(const TbSolve *solve, const float *s) {
  (void)solve, (void)s;
  return true;
}

static bool near(const TbSolve *solve) { return solve->in.near; }

/* Adds the head's compliance to the slots' own. */
static void yield_at_slots(TbSolve *solve) {
  for (uint32_t slot = 0; solve->in.slot_mask >> slot; slot++) {
    if (!tb_contacts_have_slot(&solve->in, slot)) continue;
    const double head = solve->in.slot_coupling[slot * (TB_SLOTS + 1u)];
    solve->workf.yield[tb_slot_row(&solve->in.rows, slot)] += (float)head;
  }
}

/* The start from row `from` on: everything in single precision, s = b - M f of the last sample's
 * forces. */
static TbStartF start_at(TbSolve *solve, uint32_t from) {
  TbSolveWorkF *work = &solve->workf;
  return (TbStartF){.from_b = solve->in.b + from,
                    .from_p = solve->warm.product + from,
                    .from_y = solve->in.y + from,
                    .from_f = solve->warm.force + from,
                    .from_contact_compliance = solve->in.contact_compliance + from,
                    .p = work->product_last + from,
                    .f = work->force_last + from,
                    .s = work->s + from,
                    .b = work->b + from,
                    .y = work->y + from,
                    .root = work->root + from,
                    .contact_compliance = work->contact_compliance + from,
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

/* Adds the slots' part of M x: few numbers, in double as ever. */
static void add_slots(TbSolve *solve, const float *x, const float *grid, float *out) {
  const TbKernelsF *kernels = solve->in.kernelsf;
  TbSolveWorkF *work = &solve->workf;
  const uint32_t size = solve->in.wire_gridf->size;
  double *pushed = solve->work.pushed, *answer = solve->work.answer;
  _Alignas(64) double slots[TB_SLOTS], moved[TB_SLOTS];
  kernels->widen(size, grid, pushed);
  kernels->widen(size, work->answer, answer);
  kernels->widen(TB_SLOTS, x + tb_slot_row(&solve->in.rows, 0), slots);
  tb_solve_slots(&solve->in, pushed, slots, answer, moved);
  tb_solve_stretch(&solve->in, pushed, slots, answer, moved);
  kernels->narrow(size, answer, work->answer);
  kernels->narrow(TB_SLOTS, moved, out + tb_slot_row(&solve->in.rows, 0));
}

/* Adds the stretching of the heads while no slot is in play. */
static void add_stretch(TbSolve *solve, const float *grid, float *out) {
  const TbKernelsF *kernels = solve->in.kernelsf;
  TbSolveWorkF *work = &solve->workf;
  const uint32_t size = solve->in.wire_gridf->size;
  float along[TB_COUPLINGS] = {0.0f, 0.0f};
  for (uint32_t h = 0; h < solve->in.stretch_count; h++) {
    along[h] = kernels->dot(size, work->stretch[h], grid);
  }
  for (uint32_t h = 0; h < solve->in.stretch_count; h++) {
    const double *w = solve->in.stretch_weight[h];
    const float pull = -((float)w[0] * along[0] + (float)w[1] * along[1]);
    kernels->axpy(size, work->answer, pull, work->stretch[h]);
  }
  memset(out + tb_slot_row(&solve->in.rows, 0), 0, TB_SLOTS * sizeof *out);
}

static void add_others(TbSolve *solve, const float *x, const float *grid, float *out) {
  if (solve->in.slot_mask) {
    add_slots(solve, x, grid, out);
  } else {
    add_stretch(solve, grid, out);
  }
}

/* ---- Newton --------------------------------------------------------------------------------- */

/* Moves forces by the diagonal of M alone, each row's compliance and the head's right below
 * it. Returns the largest change. */
static float newton_diagonal(TbSolve *solve) {
  const TbSolveWorkF *work = &solve->workf;
  return solve->in.kernelsf->newton_diagonal(total_rows(solve), work->law, work->slope, work->yield,
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
    kernels->newton_residual(rows, work->slope, work->yield, work->weight, work->solution,
                             work->product, work->before, work->residual, work->direction);
  if (left.largest > enough) {
    const float part = enough / left.largest;
    solve_inner(solve, left.square, solve->in.inner_cap, left.square * part * part);
  }
  return kernels->newton_finish(rows, work->law, work->weight, work->solution, work->b,
                                work->product, work->force, work->s);
}

/* Newton's iteration from the last sample's forces on, with the laws at s; true if all is given
 * back. */
static bool iterate(TbSolve *solve, TbStartF size, TbSolveOutcome *outcome) {
  const TbSolveWorkF *work = &solve->workf;
  const size_t bytes = total_rows(solve) * sizeof(float);
  memcpy(work->force, work->force_last, bytes);
  memcpy(work->product, work->product_last, bytes);
  const float first = newton_diagonal(solve);
  if (first == 0.0f) {
    give_back(solve, (Move){0.0f, 0.0f}, outcome);
    return true;
  }
  take_grid(solve);
  const float wanted = (float)solve->in.tolerance * first, noise = NOISE * size.force;
  for (uint32_t i = 0; i < solve->in.cap; i++) {
    outcome->iterations = i + 1;
    if (i > 0) newton_diagonal(solve);
    const float way = newton_step(solve, (i > 0 ? NEXT_AIM : FIRST_AIM) * wanted + noise);
    if (goes_astray(way, size)) return false;
    if (settles(solve, wanted + noise, BALANCE_REACH, outcome)) return true;
  }
  return false;
}

/* ---- at once -------------------------------------------------------------------------------- */

static float larger_of(float x, float y) { return x > y ? x : y; }

/* The slots' rows of begin(): few, and each has its own law. */
static float begin_slots(TbSolve *solve, TbStartF *size) {
  const TbKernelsF *kernels = solve->in.kernelsf;
  const TbSolveWorkF *work = &solve->workf;
  const uint32_t at = tb_slot_row(&solve->in.rows, 0);
  TbStartF slots = start_at(solve, at);
  kernels->start(TB_SLOTS, &slots);
  yield_at_slots(solve);
  slot_laws(solve, work->s);
  memcpy(work->force + at, work->force_last + at, TB_SLOTS * sizeof(float));
  size->change = larger_of(slots.change, size->change);
  size->depth = larger_of(slots.depth, size->depth);
  size->force = larger_of(slots.force, size->force);
  return kernels->newton_diagonal(TB_SLOTS, work->law + at, work->slope + at, work->yield + at,
                                  work->force + at, work->weight + at, work->solution + at);
}

/* Takes the input in, and moves forces by the diagonal of M alone. Returns the largest change. */
static float begin(TbSolve *solve, TbStartF *size) {
  const TbWireGridF *grid = solve->in.wire_gridf;
  *size = start_at(solve, 0);
  const float wires = solve->in.kernelsf->start_newton_diagonal(
    grid->wires, grid->lanes, solve->in.wire_laws, size, solve->workf.force);
  take_stretch(solve);
  solve->workf.wires = true;
  return solve->in.slot_mask ? larger_of(begin_slots(solve, size), wires) : wires;
}

static TbTrial trial_of(const TbSolve *solve) {
  const TbSolveWorkF *work = &solve->workf;
  return (TbTrial){.wires = solve->in.wire_gridf->wires,
                   .lanes = solve->in.wire_gridf->lanes,
                   .laws = solve->in.wire_laws,
                   .b = work->b,
                   .y = work->y,
                   .root = work->root,
                   .yield = work->yield,
                   .f = work->force,
                   .f_last = work->force_last,
                   .p = work->product,
                   .p_last = work->product_last};
}

/* Adds the slots' rows to a trial at t; `yield` is NULL where the largest miss is not asked for. */
static void try_slots(TbSolve *solve, const float *yield, TbTrial *trial) {
  const TbKernelsF *kernels = solve->in.kernelsf;
  const TbSolveWorkF *work = &solve->workf;
  const uint32_t at = tb_slot_row(&solve->in.rows, 0);
  if (!solve->in.slot_mask) return;
  trial->way = larger_of(kernels->change(TB_SLOTS, work->b + at, work->product + at, work->s + at),
                         trial->way);
  kernels->extrapolate(TB_SLOTS, -trial->t, work->product + at, work->product_last + at,
                       work->s + at, work->turned + at);
  slot_laws(solve, work->turned);
  const TbBalanceF slots =
    kernels->balance(TB_SLOTS, trial->t, yield ? yield + at : NULL, work->turned + at,
                     work->law + at, work->slope + at, work->force + at, work->force_last + at,
                     work->product + at, work->product_last + at);
  TbBalanceF *sums = &trial->balance;
  *sums = (TbBalanceF){sums->value + slots.value, sums->derivative + slots.derivative,
                       sums->size + slots.size, larger_of(slots.miss, sums->miss)};
}

/* balance() from a trial at t = 0 on, without storing the laws. */
static bool balance_trial(TbSolve *solve, TbTrial *trial) {
  for (uint32_t i = 0;; i++) {
    const TbBalanceF sums = trial->balance;
    const float miss = sums.value + BALANCE_AIM * sums.size;
    if (REAL_SIZE(miss) <= BALANCE_WINDOW * sums.size) return true;
    trial->t -= miss / sums.derivative;
    if (i == MOST_BALANCE_STEPS || !(REAL_SIZE(trial->t) <= BALANCE_REACH)) return false;
    solve->in.kernelsf->trial_moved(trial);
    try_slots(solve, NULL, trial);
  }
}

static void give_trial(TbSolve *solve, const TbTrial *trial, TbSolveOutcome *outcome) {
  const TbSolveWorkF *work = &solve->workf;
  const TbEndF wires = {.t = trial->t,
                        .b = work->b,
                        .f = work->force,
                        .f_last = work->force_last,
                        .p = work->product,
                        .p_last = work->product_last,
                        .to_f = solve->warm.force,
                        .to_p = solve->warm.product,
                        .to_s = solve->s};
  solve->in.kernelsf->finish_forces(tb_wire_rows(&solve->in.rows), &wires);
  const uint32_t touching = trial->touching + give_slots(solve, trial->t);
  book(solve, trial->lost - trial->balance.value, touching, outcome);
  move_grid(solve, trial->t);
}

/* Whether the forces of begin() will do: they agree with the laws to `enough`, and balance.
 *
 * Near a drum's rest they agree to rounding, and change so little that no way along their change
 * balances them. Then they will do as they are if what they gain or lose is within the window of a
 * balance. If it is not, no iteration in this precision makes them better: `rounded`. */
static bool settles_at_once(TbSolve *solve, TbStartF size, float enough, bool *rounded,
                            TbSolveOutcome *outcome) {
  const TbSolveWorkF *work = &solve->workf;
  TbTrial trial = trial_of(solve);
  take_grid(solve);
  product_of(solve, true, work->force, work->grid, work->product);
  solve->in.kernelsf->trial_at_forces(&trial);
  try_slots(solve, work->yield, &trial);
  if (goes_astray(trial.way, size) || !(trial.balance.miss <= enough)) return false;
  const TbTrial still = trial;
  if (!balance_trial(solve, &trial)) {
    *rounded = still.balance.miss <= NOISE * size.force;
    if (!*rounded || REAL_SIZE(still.balance.value) > BALANCE_WINDOW * still.balance.size)
      return false;
    trial = still;
  }
  outcome->iterations = 1;
  give_trial(solve, &trial, outcome);
  return true;
}

static bool solve_contacts(TbSolve *solve, TbSolveOutcome *outcome) {
  const TbSolveWorkF *work = &solve->workf;
  TbStartF size;
  const float first = begin(solve, &size);
  const float enough = (float)solve->in.tolerance * first + NOISE * size.force;
  bool rounded = false;
  outcome->iterations = 0;
  if (solve->in.cap > 0 && first > 0.0f && settles_at_once(solve, size, enough, &rounded, outcome))
    return true;
  if (rounded) return false;
  solve->in.kernelsf->change(total_rows(solve), work->b, work->product_last, work->s);
  apply_laws(solve, work->s);
  return iterate(solve, size, outcome);
}

/* ---- for others ----------------------------------------------------------------------------- */

static void product(TbSolve *solve, const double *x, double *grid, double *out) {
  const TbKernelsF *kernels = solve->in.kernelsf;
  const TbSolveWorkF *work = &solve->workf;
  const uint32_t rows = tb_row_count(&solve->in.rows);
  kernels->narrow(rows, solve->in.contact_compliance, work->contact_compliance);
  kernels->narrow(rows, x, work->turned);
  product_of(solve, true, work->turned, work->grid, work->moved);
  kernels->widen(solve->in.wire_gridf->size, work->grid, grid);
  kernels->widen(rows, work->moved, out);
}

const TbContactMethod tb_contact_methodf = {near, solve_contacts, product};
