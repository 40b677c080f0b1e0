/* SPDX-License-Identifier: MIT */
#include "singlesolve.h"

#include <math.h>
#include <string.h>

#include "profile.h"

/* Forces are balanced (solve.h) where they lose this part of the work that makes up the balance, and as far on
 * either side: sums of single precision are right to a tenth of it. */
static const float BALANCE_AIM = 1.5e-6f, BALANCE_WINDOW = 1.5e-6f;
static const uint32_t MOST_BALANCE_STEPS = 4;
static const float BALANCE_REACH = 0.1f;
/* As in solve.c. */
static const float FARTHEST = 100.0f;

static uint32_t total_rows(const TbSolve *solve) { return solve->stride + TB_SLOTS; }

/* ---- M x ------------------------------------------------------------------------------------ */

/* What the slots and the stretching of the heads add: few numbers, in double as ever. */
static void add_slots_and_stretch(const TbSolve *solve, const float *x, const float *grid,
                                  float *out) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  const uint32_t size = single->bed->size;
  _Alignas(64) double pushed[TB_SLOTS], moved[TB_SLOTS];
  kernels->widen(size, grid, solve->pushed);
  kernels->widen(size, single->answer, solve->answer);
  kernels->widen(TB_SLOTS, x + solve->stride, pushed);
  tb_solve_slots(solve, solve->pushed, pushed, solve->answer, moved);
  tb_solve_stretch(solve, solve->pushed, pushed, solve->answer, moved);
  kernels->narrow(size, solve->answer, single->answer);
  kernels->narrow(TB_SLOTS, moved, out + solve->stride);
}

static void product_of(const TbSolve *solve, const float *x, float *grid, float *out) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  TB_STAGE(PRODUCT);
  kernels->contract(single->bed, x, single->scratch, grid);
  kernels->comply(single->bed, grid, single->answer);
  add_slots_and_stretch(solve, x, grid, out);
  kernels->expand(single->bed, single->answer, single->scratch, out);
  kernels->add_product(total_rows(solve), out, single->own, x);
  TB_STAGE(LAWS);
}

void tb_single_product(const TbSolve *solve, const double *x, double *grid, double *out) {
  const TbSingle *single = &solve->single;
  const uint32_t rows = total_rows(solve);
  single->kernels->narrow(rows, solve->own, single->own);
  single->kernels->narrow(rows, x, single->work);
  product_of(solve, single->work, single->grid, single->moved);
  single->kernels->widen(single->bed->size, single->grid, grid);
  single->kernels->widen(rows, single->moved, out);
}

/* ---- laws ----------------------------------------------------------------------------------- */

static void slot_laws(const TbSolve *solve, const float *s) {
  const TbSingle *single = &solve->single;
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    const uint32_t row = solve->stride + slot;
    TbLawResult law = {0.0, 0.0, 0.0};
    if (solve->slot_mask >> slot & 1u) {
      law = tb_law_force(&solve->slot_laws[slot], (double)single->y[row], (double)s[row]);
    }
    single->law[row] = (float)law.force;
    single->slope[row] = (float)law.slope;
    single->mean[row] = (float)law.mean;
  }
}

static void apply_laws(const TbSolve *solve, const float *s) {
  const TbSingle *single = &solve->single;
  single->kernels->laws(single->bed->wires, single->bed->lanes, solve->wire_laws, single->y, s,
                        single->law, single->slope, single->mean);
  slot_laws(solve, s);
}

/* ---- one Newton step ------------------------------------------------------------------------ */

/* (I + W M W) p = d by conjugate gradients, as solve.c does it; adds M W p to `work`, which is M f of the laws'
 * forces, and W p on the grid to `grid`. */
static void solve_inner(const TbSolve *solve, float square) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  const uint32_t rows = total_rows(solve);
  const float tolerance = (float)solve->inner_tolerance;
  const float enough = square * tolerance * tolerance;
  memset(single->solution, 0, rows * sizeof(float));
  memcpy(single->residual, single->direction, rows * sizeof(float));
  for (uint32_t i = 0; i < solve->inner_cap && square > enough; i++) {
    kernels->product(rows, single->turned, single->weight, single->direction);
    product_of(solve, single->turned, single->pushed, single->moved);
    const float bend =
      kernels->turn(rows, single->turned, single->direction, single->weight, single->moved);
    const float step = square / bend;
    const float next = kernels->advance(rows, step, single->solution, single->direction,
                                        single->residual, single->turned);
    kernels->add_scaled(rows, single->work, step, single->moved);
    kernels->add_scaled(single->bed->size, single->grid, step, single->pushed);
    kernels->redirect(rows, next / square, single->direction, single->residual);
    square = next;
  }
}

/* From the laws at s on; force, product, grid and s follow. */
static void newton_step(const TbSolve *solve) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  const uint32_t rows = total_rows(solve);
  product_of(solve, single->law, single->grid, single->work);
  const float square = kernels->weigh(rows, single->slope, single->work, single->product,
                                      single->weight, single->direction);
  solve_inner(solve, square);
  memcpy(single->force, single->law, rows * sizeof(float));
  kernels->add_product(rows, single->force, single->weight, single->solution);
  memcpy(single->product, single->work, rows * sizeof(float));
  kernels->subtract(rows, single->b, single->product, single->s);
}

/* ---- the balance ---------------------------------------------------------------------------- */

/* x += t (x - before) */
static void move_on(const TbSingle *single, uint32_t n, float t, float *x, const float *before) {
  single->kernels->extrapolate(n, t, x, before, x, x);
}

/* As balance() in solve.c; the energy left over, lost, into *over. */
static bool balance(const TbSolve *solve, float *over) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  const uint32_t rows = total_rows(solve);
  const float *s = single->s;
  float t = 0.0f, sums[3];
  for (uint32_t i = 0;; i++) {
    kernels->balance(rows, t, s, single->law, single->slope, single->force, single->force_last,
                     single->product, single->product_last, sums);
    const float miss = sums[0] + BALANCE_AIM * sums[2];
    if (fabsf(miss) <= BALANCE_WINDOW * sums[2]) break;
    if (i == MOST_BALANCE_STEPS) return false;
    t -= miss / sums[1];
    if (!(fabsf(t) <= BALANCE_REACH)) return false;
    s = single->turned;
    kernels->extrapolate(rows, -t, single->product, single->product_last, single->s,
                         single->turned);
    apply_laws(solve, s);
  }
  *over = -sums[0];
  if (t == 0.0f) return true;
  move_on(single, rows, t, single->force, single->force_last);
  move_on(single, rows, t, single->product, single->product_last);
  move_on(single, single->bed->size, t, single->grid, single->grid_last);
  kernels->subtract(rows, single->b, single->product, single->s);
  return true;
}

/* ---- the solve ------------------------------------------------------------------------------ */

static void take_in(const TbSolve *solve) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  const uint32_t rows = total_rows(solve);
  kernels->narrow(rows, solve->y, single->y);
  kernels->narrow(rows, solve->b, single->b);
  kernels->narrow(rows, solve->own, single->own);
  kernels->narrow_difference(rows, solve->b, solve->product, single->s);
  kernels->narrow(rows, solve->force, single->force_last);
  kernels->narrow(rows, solve->product, single->product_last);
  kernels->narrow(single->bed->size, solve->grid, single->grid_last);
  memcpy(single->product, single->product_last, rows * sizeof(float));
}

static void give_back(TbSolve *solve) {
  const TbSingle *single = &solve->single;
  const uint32_t rows = total_rows(solve);
  single->kernels->widen(rows, single->force, solve->force);
  single->kernels->widen(rows, single->product, solve->product);
  single->kernels->widen(rows, single->s, solve->s);
  single->kernels->widen(single->bed->size, single->grid, solve->grid);
}

static void book(const TbSolve *solve, float over, TbSolveOutcome *outcome) {
  const TbSingle *single = &solve->single;
  double contact =
    (double)(single->kernels->lost(solve->stride, single->s, single->law, single->mean) + over);
  double damper = 0.0;
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    if (!(solve->slot_mask >> slot & 1u)) continue;
    const uint32_t row = solve->stride + slot;
    const bool hand = solve->slot_laws[slot].kind == TB_LAW_DAMPER;
    *(hand ? &damper : &contact) +=
      (double)single->s[row] * ((double)single->law[row] - (double)single->mean[row]);
  }
  outcome->contact_loss = 0.5 * contact;
  outcome->damper_loss = 0.5 * damper;
  outcome->touching = single->kernels->count(total_rows(solve), single->slope);
}

/* Forces that no law changes stay as they are. */
static void stay(TbSolve *solve, TbSolveOutcome *outcome) {
  const TbSingle *single = &solve->single;
  single->kernels->widen(total_rows(solve), single->s, solve->s);
  book(solve, 0.0f, outcome);
}

/* No s can be larger. */
static float farthest(const TbSolve *solve) {
  const TbPair size = solve->kernels->sizes(total_rows(solve), solve->b, solve->y);
  return FARTHEST * (float)(size.first + size.second);
}

bool tb_single_solve(TbSolve *solve, TbSolveOutcome *outcome) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  const uint32_t rows = total_rows(solve);
  take_in(solve);
  apply_laws(solve, single->s);
  const float first = kernels->difference(rows, single->law, single->force_last);
  if (first == 0.0f) {
    stay(solve, outcome);
    return true;
  }
  const float enough = (float)solve->tolerance * first, limit = farthest(solve);
  for (uint32_t i = 1; i <= solve->cap; i++) {
    newton_step(solve);
    if (!(kernels->largest(rows, single->s) <= limit)) return false;
    apply_laws(solve, single->s);
    if (!(kernels->difference(rows, single->law, single->force) <= enough)) continue;
    float over = 0.0f;
    if (!balance(solve, &over)) return false;
    give_back(solve);
    book(solve, over, outcome);
    outcome->iterations = i;
    return true;
  }
  return false;
}
