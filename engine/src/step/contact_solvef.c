/* SPDX-License-Identifier: MIT */
/* The contact solve in single precision. Forces that move as if rows did not feel each other, and a balance along this change,
 * are accepted in some 97 of 100 samples of the stock snare. So this is tried first, in few passes over the rows that keep
 * nothing of the laws; the iteration of contact_solve_tmpl.c takes the other samples from the beginning. */
#define TB_FLOAT
#include "step/contact_solve_tmpl.c"

static float larger_of(float x, float y) { return x > y ? x : y; }

/* The slots' rows of begin(): few, and each has its own law. */
static float begin_slots(TbSolve *solve, TbStartF *size) {
  const TbKernelsF *kernels = solve->in.kernelsf;
  const TbSolveWorkF *work = &solve->workf;
  const uint32_t at = solve->in.stride;
  TbStartF slots = start_at(solve, at);
  kernels->start(TB_SLOTS, &slots);
  yield_at_slots(solve);
  slot_laws(solve, work->s);
  memcpy(work->force + at, work->force_last + at, TB_SLOTS * sizeof(float));
  size->change = larger_of(slots.change, size->change);
  size->depth = larger_of(slots.depth, size->depth);
  size->force = larger_of(slots.force, size->force);
  return kernels->aim(TB_SLOTS, work->law + at, work->slope + at, work->yield + at,
                      work->force + at, work->weight + at, work->solution + at);
}

/* Takes the input in, and moves forces as if each row's own yielding and the head's right below it were all. Returns the
 * largest change. */
static float begin(TbSolve *solve, TbStartF *size) {
  const TbWireGridF *grid = solve->in.wire_gridf;
  *size = start_at(solve, 0);
  const float wires = solve->in.kernelsf->begin(grid->wires, grid->lanes, solve->in.wire_laws, size,
                                                solve->workf.force);
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
  const uint32_t at = solve->in.stride;
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
    solve->in.kernelsf->try_moved(trial);
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
  solve->in.kernelsf->give(solve->in.stride, &wires);
  const uint32_t touching = trial->touching + give_slots(solve, trial->t);
  book(solve, trial->lost - trial->balance.value, touching, outcome);
  move_grid(solve, trial->t);
}

/* Whether the forces of begin() will do: they agree with the laws to `enough`, and balance. */
static bool settles_at_once(TbSolve *solve, TbStartF size, float enough, TbSolveOutcome *outcome) {
  const TbSolveWorkF *work = &solve->workf;
  TbTrial trial = trial_of(solve);
  take_grid(solve);
  product_of(solve, true, work->force, work->grid, work->product);
  solve->in.kernelsf->try_forces(&trial);
  try_slots(solve, work->yield, &trial);
  if (goes_astray(trial.way, size) || !(trial.balance.miss <= enough)) return false;
  if (!balance_trial(solve, &trial)) return false;
  outcome->iterations = 1;
  give_trial(solve, &trial, outcome);
  return true;
}

static bool solve_contacts(TbSolve *solve, TbSolveOutcome *outcome) {
  const TbSolveWorkF *work = &solve->workf;
  TbStartF size;
  const float first = begin(solve, &size);
  const float enough = (float)solve->in.tolerance * first + NOISE * size.force;
  outcome->iterations = 0;
  if (solve->in.cap > 0 && first > 0.0f && settles_at_once(solve, size, enough, outcome))
    return true;
  solve->in.kernelsf->change(total_rows(solve), work->b, work->product_last, work->s);
  apply_laws(solve, work->s);
  return iterate(solve, size, outcome);
}

const TbContactMethod tb_contact_methodf = {near, solve_contacts, product};
