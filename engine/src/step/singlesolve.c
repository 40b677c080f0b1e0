/* SPDX-License-Identifier: MIT */
#include "step/singlesolve.h"

#include <math.h>
#include <string.h>

#include "kernels/profile.h"

/* Forces are balanced (solve.h) where they lose this part of the work that makes up the balance, and as far on
 * either side: sums of single precision are right to a tenth of it. */
static const float BALANCE_AIM = 1.5e-6f, BALANCE_WINDOW = 1.5e-6f;
static const uint32_t MOST_BALANCE_STEPS = 4;
static const float BALANCE_REACH = 0.1f;
/* Forces of single precision are right to this part of the largest: near a drum's rest that is all they change. */
static const float NOISE = 2e-6f;
/* As in solve.c. */
static const float FARTHEST = 100.0f;

/* Those of the slots stand last, and for nothing while none is in play. */
static uint32_t total_rows(const TbSolve *solve) {
  return solve->stride + (solve->slot_mask ? TB_SLOTS : 0u);
}

/* ---- M x ------------------------------------------------------------------------------------ */

/* What the slots add: few numbers, in double as ever. */
static void add_slots(const TbSolve *solve, const float *x, const float *grid, float *out) {
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

/* What the stretching of the heads adds where no slot is in play. */
static void add_stretch(const TbSolve *solve, const float *grid, float *out) {
  const TbSingle *single = &solve->single;
  const uint32_t size = single->bed->size;
  float along[2] = {0.0f, 0.0f};
  for (uint32_t h = 0; h < solve->stretch_count; h++) {
    along[h] = single->kernels->dot(size, single->stretch[h], grid);
  }
  for (uint32_t h = 0; h < solve->stretch_count; h++) {
    const double *w = solve->stretch_weight[h];
    const float pull = -((float)w[0] * along[0] + (float)w[1] * along[1]);
    single->kernels->add_scaled(size, single->answer, pull, single->stretch[h]);
  }
  memset(out + solve->stride, 0, TB_SLOTS * sizeof *out);
}

static void product_of(const TbSolve *solve, const float *x, float *grid, float *out) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  TB_STAGE(PRODUCT);
  kernels->contract(single->bed, x, single->scratch, grid);
  kernels->comply(single->bed, grid, single->answer);
  if (solve->slot_mask) {
    add_slots(solve, x, grid, out);
  } else {
    add_stretch(solve, grid, out);
  }
  kernels->expand(single->bed, single->answer, single->scratch, out);
  kernels->add_product(total_rows(solve), out, single->own, x);
  TB_STAGE(LAWS);
}

void tb_single_product(const TbSolve *solve, const double *x, double *grid, double *out) {
  const TbSingle *single = &solve->single;
  const uint32_t rows = solve->stride + TB_SLOTS;
  single->kernels->narrow(rows, solve->own, single->own);
  single->kernels->narrow(rows, x, single->work);
  product_of(solve, single->work, single->grid, single->moved);
  single->kernels->widen(single->bed->size, single->grid, grid);
  single->kernels->widen(rows, single->moved, out);
}

/* ---- laws ----------------------------------------------------------------------------------- */

static void slot_laws(const TbSolve *solve, const float *s) {
  const TbSingle *single = &solve->single;
  float *const outputs[] = {single->law, single->slope, single->mean};
  if (!solve->slot_mask) return;
  for (int i = 0; i < 3; i++) memset(outputs[i] + solve->stride, 0, TB_SLOTS * sizeof(float));
  for (uint32_t slot = 0; solve->slot_mask >> slot; slot++) {
    const uint32_t row = solve->stride + slot;
    if (!(solve->slot_mask >> slot & 1u)) continue;
    const TbLawResult law =
      tb_law_force(&solve->slot_laws[slot], (double)single->y[row], (double)s[row]);
    single->law[row] = (float)law.force;
    single->slope[row] = (float)law.slope;
    single->mean[row] = (float)law.mean;
  }
}

static void apply_laws(const TbSolve *solve, const float *s) {
  const TbSingle *single = &solve->single;
  single->kernels->laws(single->bed->wires, single->bed->lanes, solve->wire_laws, single->y,
                        single->root, s, single->law, single->slope, single->mean);
  slot_laws(solve, s);
}

/* ---- one step without the others ------------------------------------------------------------- */

static void relax_slots(const TbSolve *solve) {
  const TbSingle *single = &solve->single;
  const uint32_t at = solve->stride;
  _Alignas(64) float heads[TB_SLOTS];
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    heads[i] = solve->slot_mask >> i & 1u ? (float)solve->slot_coupling[i * (TB_SLOTS + 1u)] : 0.0f;
  }
  single->kernels->relax(TB_SLOTS, single->law + at, single->slope + at, single->own + at, heads,
                         single->force_last + at, single->force + at);
}

/* Each row as if its own yielding and the head's right below it were all: with the wires' own the larger
 * part, that is nearly always enough, for one product instead of two. Returns the largest |s|. */
static float relax(const TbSolve *solve) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  kernels->relax(solve->stride, single->law, single->slope, single->own, single->yield,
                 single->force_last, single->force);
  if (solve->slot_mask) relax_slots(solve);
  product_of(solve, single->force, single->grid, single->product);
  return kernels->change(total_rows(solve), single->b, single->product, single->s);
}

/* ---- one Newton step ------------------------------------------------------------------------ */

/* (I + W M W) p = d by conjugate gradients, as solve.c does it; adds M W p to `product`, which is M f of the
 * laws' forces, and W p on the grid to `grid`. */
static void solve_inner(const TbSolve *solve, float square) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  const uint32_t rows = total_rows(solve);
  const float tolerance = (float)solve->inner_tolerance;
  const float enough = square * tolerance * tolerance;
  memset(single->solution, 0, rows * sizeof(float));
  memcpy(single->residual, single->direction, rows * sizeof(float));
  float again = 0.0f; /* how much of the last direction the next one keeps */
  for (uint32_t i = 0; i < solve->inner_cap && square > enough; i++) {
    if (i > 0) kernels->redirect(rows, again, single->direction, single->residual);
    kernels->product(rows, single->turned, single->weight, single->direction);
    product_of(solve, single->turned, single->pushed, single->moved);
    const float bend =
      kernels->turn(rows, single->turned, single->direction, single->weight, single->moved);
    const float step = square / bend;
    const float next = kernels->advance(rows, step, single->solution, single->direction,
                                        single->residual, single->turned);
    kernels->add_scaled(rows, single->product, step, single->moved);
    kernels->add_scaled(single->bed->size, single->grid, step, single->pushed);
    again = next / square;
    square = next;
  }
}

/* From the laws at s on; force, product, grid and s follow. Returns the largest |s|. */
static float newton_step(const TbSolve *solve) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  const uint32_t rows = total_rows(solve);
  memcpy(single->work, single->product, rows * sizeof(float));
  product_of(solve, single->law, single->grid, single->product);
  const float square = kernels->weigh(rows, single->slope, single->product, single->work,
                                      single->weight, single->direction);
  solve_inner(solve, square);
  return kernels->follow(rows, single->law, single->weight, single->solution, single->b,
                         single->product, single->force, single->s);
}

/* ---- the balance ---------------------------------------------------------------------------- */

/* As balance() in solve.c, with the sums at s to begin with: how far to move, the energy left over, lost, into
 * *over; no number where there is no such place. */
static float balance(const TbSolve *solve, TbSingleSums sums, float *over) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  const uint32_t rows = total_rows(solve);
  float t = 0.0f;
  for (uint32_t i = 0;; i++) {
    const float miss = sums.value + BALANCE_AIM * sums.size;
    *over = -sums.value;
    if (fabsf(miss) <= BALANCE_WINDOW * sums.size) return t;
    t -= miss / sums.derivative;
    if (i == MOST_BALANCE_STEPS || !(fabsf(t) <= BALANCE_REACH)) return NAN;
    kernels->extrapolate(rows, -t, single->product, single->product_last, single->s,
                         single->turned);
    apply_laws(solve, single->turned);
    sums = kernels->balance(rows, t, single->turned, single->law, single->slope, single->force,
                            single->force_last, single->product, single->product_last);
  }
}

/* ---- the solve ------------------------------------------------------------------------------ */

static TbSingleStart take_in(const TbSolve *solve) {
  const TbSingle *single = &solve->single;
  TbSingleStart start = {.from_b = solve->b,
                         .from_p = solve->product,
                         .from_y = solve->y,
                         .from_own = solve->own,
                         .from_f = solve->force,
                         .b = single->b,
                         .p = single->product_last,
                         .y = single->y,
                         .root = single->root,
                         .own = single->own,
                         .f = single->force_last,
                         .s = single->s};
  single->kernels->start(total_rows(solve), &start);
  for (uint32_t h = 0; h < solve->stretch_count; h++) {
    single->kernels->narrow(single->bed->size, solve->stretch_grid[h], single->stretch[h]);
  }
  return start;
}

/* Forces moved by t along their change, and what the laws lose there. */
static void give_back(TbSolve *solve, float t, float over, TbSolveOutcome *outcome) {
  const TbSingle *single = &solve->single;
  TbSingleEnd end = {.t = t,
                     .b = single->b,
                     .f = single->force,
                     .f_last = single->force_last,
                     .p = single->product,
                     .p_last = single->product_last,
                     .law = single->law,
                     .mean = single->mean,
                     .slope = single->slope,
                     .to_f = solve->force,
                     .to_p = solve->product,
                     .to_s = solve->s};
  single->kernels->end(total_rows(solve), &end);
  double contact = (double)(end.lost + over), damper = 0.0;
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    if (!(solve->slot_mask >> slot & 1u)) continue;
    if (solve->slot_laws[slot].kind != TB_LAW_DAMPER) continue;
    const uint32_t row = solve->stride + slot;
    damper += solve->s[row] * ((double)single->law[row] - (double)single->mean[row]);
  }
  outcome->contact_loss = 0.5 * (contact - damper);
  outcome->damper_loss = 0.5 * damper;
  outcome->touching = end.touching;
  outcome->contact = true;
}

/* Forces that no law changes stay as they are. */
static void stay(TbSolve *solve, TbSolveOutcome *outcome) {
  const TbSingle *single = &solve->single;
  const size_t bytes = total_rows(solve) * sizeof(float);
  memcpy(single->force, single->force_last, bytes);
  memcpy(single->product, single->product_last, bytes);
  give_back(solve, 0.0f, 0.0f, outcome);
}

/* Whether forces and laws agree to `enough` at s, and how forces have to move then to be balanced; no number
 * where they do not. */
static float judge(const TbSolve *solve, float enough, float *over) {
  const TbSingle *single = &solve->single;
  apply_laws(solve, single->s);
  const TbSingleSums sums = single->kernels->balance(
    total_rows(solve), 0.0f, single->s, single->law, single->slope, single->force,
    single->force_last, single->product, single->product_last);
  if (!(sums.miss <= enough + NOISE * sums.most)) return NAN;
  const float t = balance(solve, sums, over);
  if (isnan(t)) apply_laws(solve, single->s); /* it has left the laws of another place */
  return t;
}

bool tb_single_solve(TbSolve *solve, TbSolveOutcome *outcome) {
  const TbSingle *single = &solve->single;
  const TbSingleKernels *kernels = single->kernels;
  const uint32_t size = single->bed->size;
  const TbSingleStart start = take_in(solve);
  apply_laws(solve, single->s);
  const float first = kernels->difference(total_rows(solve), single->law, single->force_last);
  if (first == 0.0f) {
    stay(solve, outcome);
    return true;
  }
  kernels->narrow(size, solve->grid, single->grid_last);
  const float enough = (float)solve->tolerance * first;
  const float farthest = FARTHEST * (start.change + start.depth); /* no s can be larger */
  for (uint32_t i = 0; i <= solve->cap; i++) {
    const float way = i == 0 ? relax(solve) : newton_step(solve);
    if (!(way <= farthest)) return false;
    float over = 0.0f;
    const float t = judge(solve, enough, &over);
    if (isnan(t)) continue;
    give_back(solve, t, over, outcome);
    kernels->extrapolate(size, t, single->grid, single->grid_last, single->grid, single->grid);
    kernels->widen(size, single->grid, solve->grid);
    outcome->iterations = i;
    return true;
  }
  return false;
}
