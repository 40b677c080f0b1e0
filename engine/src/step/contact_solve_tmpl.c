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

/* Forces are balanced where they lose this part of the work that makes up the balance, and as far on either side: in
 * single precision sums are right to a tenth of it, and nothing may be gained. */
static const Real BALANCE_AIM = REAL(SINGLE ? 1.5e-6 : 0.0);
static const Real BALANCE_WINDOW = REAL(SINGLE ? 1.5e-6 : 1e-13);
static const uint32_t MOST_BALANCE_STEPS = SINGLE ? 4 : 8;
static const Real BALANCE_REACH = REAL(0.1);
/* Forces of single precision are right to this part of the largest: near a drum's rest that is all they change. */
static const Real NOISE = REAL(SINGLE ? 2e-6 : 0.0);
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

/* Of the largest number to be found: none is known here. */
static bool is_noise(const TbSolve *solve, float residual, TbStartF size) {
  (void)solve, (void)residual, (void)size;
  return false;
}

static bool wires_touch(const TbSolve *solve, const float *s) {
  (void)solve, (void)s;
  return true;
}

static bool near(const TbSolve *solve) { return solve->in.near; }

/* Everything in single precision; s = b - M f of the last sample's forces. */
static TbStartF take_in(TbSolve *solve) {
  TbSolveWorkF *work = &solve->workf;
  TbStartF start = {.from_b = solve->in.b,
                    .from_p = solve->warm.product,
                    .from_y = solve->in.y,
                    .from_f = solve->warm.force,
                    .from_own = solve->in.own,
                    .p = work->product_last,
                    .f = work->force_last,
                    .s = work->s,
                    .b = work->b,
                    .y = work->y,
                    .root = work->root,
                    .own = work->own};
  solve->in.kernelsf->start(total_rows(solve), &start);
  for (uint32_t h = 0; h < solve->in.stretch_count; h++) {
    solve->in.kernelsf->narrow(solve->in.wire_gridf->size, solve->in.stretch_grid[h],
                               work->stretch[h]);
  }
  work->wires = true;
  return start;
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

/* Newton has converged when the residual is rounding noise of what it is a difference of. */
static bool is_noise(const TbSolve *solve, double residual, TbStart size) {
  static const double RELATIVE_TOLERANCE = 1e-14, PENETRATION_TOLERANCE = 4e-15;
  (void)solve;
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

/* r = s + M f - b with the laws' forces, whose response is left in `product` and `grid`, and in `direction` what the
 * step is to solve for. */
static Residual find_residual(TbSolve *solve) {
  const Work *work = work_of(solve);
  const uint32_t rows = total_rows(solve);
  const Real *before = work->product;
#ifdef TB_FLOAT
  memcpy(work->before, work->product, rows * sizeof *work->before);
  before = work->before;
#endif
  product_of(solve, work->wires, work->law, work->grid, work->product);
  return kernels_of(solve)->weigh(rows, work->slope, work->s, b_of(solve), work->product, before,
                                  work->weight, work->direction);
}

/* Solves (I + W M W) p = d, given in `direction` with its square, by conjugate gradients from p = 0, W = diag(weight),
 * into `solution`; adds M W p to `product`, and W p on the grid to `grid`. */
static void solve_inner(TbSolve *solve, Real square, uint32_t cap, Real tolerance) {
  const Kernels *kernels = kernels_of(solve);
  const Work *work = work_of(solve);
  const uint32_t rows = total_rows(solve), size = solve->in.wire_grid->size;
  const Real enough = square * tolerance * tolerance;
  memset(work->solution, 0, rows * sizeof(Real));
  memcpy(work->residual, work->direction, rows * sizeof(Real));
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

/* From the laws at s on, whose residual has been found; force, product, grid and s follow. Returns the largest |s|. */
static Real newton_step(TbSolve *solve, Residual found, uint32_t cap, double tolerance) {
  const Work *work = work_of(solve);
  solve_inner(solve, found.square, cap, (Real)tolerance);
  return kernels_of(solve)->follow(total_rows(solve), work->law, work->weight, work->solution,
                                   b_of(solve), work->product, work->force, work->s);
}

/* ---- the balance ---------------------------------------------------------------------------- */

static Balance balance_at(TbSolve *solve, const Real *s, Real t) {
  const Work *work = work_of(solve);
  return kernels_of(solve)->balance(total_rows(solve), t, s, work->law, work->slope, work->force,
                                    work->force_last, work->product, work->product_last);
}

/* How far forces have to move along their change, f~ + t g, and the energy that is left over then, lost. */
typedef struct Move {
  Real t, over;
} Move;

/* Where the work of the forces is what the laws say, with the sums at s to begin with, and leaves that place's laws;
 * false where there is no such place up to `reach` away. */
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
    sums = balance_at(solve, work->turned, t);
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

/* The forces where they are balanced, and what the laws lose there. */
static void give_back(TbSolve *solve, Move move, TbSolveOutcome *outcome) {
  const Work *work = work_of(solve);
  const uint32_t stride = solve->in.stride;
  const End wires = give_rows(solve, 0, stride, move.t);
  double contact = (double)(wires.lost + move.over), damper = 0.0;
  outcome->touching = wires.touching;
  if (solve->in.slot_mask) {
    outcome->touching += give_rows(solve, stride, TB_SLOTS, move.t).touching;
  }
  for (uint32_t slot = 0; solve->in.slot_mask >> slot; slot++) {
    if (!tb_slot_in_play(&solve->in, slot)) continue;
    const uint32_t row = stride + slot;
    const bool hand = solve->in.slot_laws[slot].kind == TB_CONTACT_LAW_DAMPER;
    *(hand ? &damper : &contact) +=
      solve->s[row] * ((double)work->law[row] - (double)work->mean[row]);
  }
  outcome->contact_loss = 0.5 * contact;
  outcome->damper_loss = 0.5 * damper;
}

/* Forces that no law changes stay as they are. */
static void stay(TbSolve *solve, TbSolveOutcome *outcome) {
  const Work *work = work_of(solve);
  const size_t bytes = total_rows(solve) * sizeof(Real);
  if (SINGLE) memcpy(work->force, work->force_last, bytes);
  if (SINGLE) memcpy(work->product, work->product_last, bytes);
  give_back(solve, (Move){REAL(0.0), REAL(0.0)}, outcome);
}

static void evaluate(TbSolve *solve) {
  Work *work = work_of(solve);
  work->wires = work->wires || wires_touch(solve, work->s);
  apply_laws(solve, work->s);
}

/* Whether forces and laws agree to `enough` at s, and forces balance up to `reach` away; then all is given back. It is
 * no end where wires touch there that took no part. */
static bool settles(TbSolve *solve, Real enough, Real reach, TbSolveOutcome *outcome) {
  const Work *work = work_of(solve);
  Move move;
  evaluate(solve);
  const Balance sums = balance_at(solve, work->s, REAL(0.0));
  if (!(sums.miss <= enough + NOISE * sums.most)) return false;
  if (balance(solve, sums, reach, &move)) {
    give_back(solve, move, outcome);
    kernels_of(solve)->extrapolate(solve->in.wire_grid->size, move.t, work->grid, work->grid_last,
                                   work->grid, work->grid);
    give_grid(solve);
    if (work->wires || !wires_touch(solve, work->s)) return true;
  }
  evaluate(solve); /* it has left the laws of another place */
  return false;
}

/* ---- the solve ------------------------------------------------------------------------------ */

#ifdef TB_FLOAT
static void relax_slots(TbSolve *solve) {
  const TbSolveWorkF *work = &solve->workf;
  const uint32_t at = solve->in.stride;
  _Alignas(64) float heads[TB_SLOTS];
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const double head = solve->in.slot_coupling[i * (TB_SLOTS + 1u)];
    heads[i] = tb_slot_in_play(&solve->in, i) ? (float)head : 0.0f;
  }
  solve->in.kernelsf->relax(TB_SLOTS, work->law + at, work->slope + at, work->own + at, heads,
                            work->force_last + at, work->force + at);
}

/* A first step: each row as if its own yielding and the head's right below it were all: with the wires' own the larger
 * part, that is nearly always enough, for one product instead of two. Returns the largest |s|. */
static float first_step(TbSolve *solve) {
  const TbKernelsF *kernels = solve->in.kernelsf;
  const TbSolveWorkF *work = &solve->workf;
  kernels->relax(solve->in.stride, work->law, work->slope, work->own, solve->in.yield,
                 work->force_last, work->force);
  if (solve->in.slot_mask) relax_slots(solve);
  product_of(solve, true, work->force, work->grid, work->product);
  return kernels->change(total_rows(solve), work->b, work->product, work->s);
}
#else
static double first_step(TbSolve *solve) {
  (void)solve;
  return 0.0;
}
#endif

static void take_law_forces(TbSolve *solve) {
  const Work *work = work_of(solve);
  memcpy(work->force, work->law, total_rows(solve) * sizeof(Real));
  kernels_of(solve)->change(total_rows(solve), b_of(solve), work->product, work->s);
}

/* Newton's iteration; true if it came to its end and all is given back. A step that was solved too coarsely, over
 * contacts too stiff for it, throws points about (`astray`); the next one would throw them farther, since forces with
 * loss grow with the square of s. */
static bool iterate(TbSolve *solve, Start size, Real enough, bool *astray,
                    TbSolveOutcome *outcome) {
  const Work *work = work_of(solve);
  const uint32_t cap = solve->in.cap;
  Real way = first_step(solve);
  for (uint32_t i = 0;; i++) {
    outcome->iterations = i;
    *astray = !(way <= FARTHEST * (size.change + size.depth));
    if (*astray) return false;
    if ((SINGLE || i > 0) && settles(solve, enough, BALANCE_REACH, outcome)) return true;
    if (i == cap && solve->in.tolerance > 0.0) return false;
    const Residual found = find_residual(solve);
    if (is_noise(solve, found.largest, size)) {
      take_law_forces(solve);
      give_back(solve, (Move){REAL(0.0), REAL(0.0)}, outcome);
      return true;
    }
    if (i == cap) {
      product_of(solve, work->wires, work->force, work->grid, work->product);
      kernels_of(solve)->change(total_rows(solve), b_of(solve), work->product, work->s);
      return false;
    }
    way = newton_step(solve, found, solve->in.inner_cap, solve->in.inner_tolerance);
  }
}

/* Where Newton came to no end. */
static bool recover(TbSolve *solve, bool astray, TbSolveOutcome *outcome) {
  if (SINGLE) return false;
  outcome->capped = true;
  outcome->corrected = !astray && settles(solve, REAL(INFINITY), REAL(0.5), outcome);
  return outcome->corrected;
}

static bool solve_contacts(TbSolve *solve, TbSolveOutcome *outcome) {
  const Work *work = work_of(solve);
  const Start size = take_in(solve);
  outcome->iterations = 0;
  apply_laws(solve, work->s);
  const Real first = kernels_of(solve)->difference(total_rows(solve), work->law, work->force_last);
  if (first == REAL(0.0)) {
    stay(solve, outcome);
    return true;
  }
  take_grid(solve);
  bool astray = false;
  return iterate(solve, size, (Real)solve->in.tolerance * first, &astray, outcome) ||
         recover(solve, astray, outcome);
}

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
#endif

static void step(TbSolve *solve, uint32_t inner_cap, double inner_tolerance) {
  newton_step(solve, find_residual(solve), inner_cap, inner_tolerance);
}

const TbContactMethod NAME_OF(tb_contact_method) = {near, solve_contacts, product, step};
