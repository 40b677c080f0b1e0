/* SPDX-License-Identifier: MIT */
#include "step/solve.h"

#include <math.h>
#include <string.h>

#include "kernels/profile.h"
#include "step/singlesolve.h"

/* Newton has converged when the residual is rounding noise of what it is a difference of. */
static const double RELATIVE_TOLERANCE = 1e-14;
static const double PENETRATION_TOLERANCE = 4e-15;
/* A balance is exact to this part of the work that makes it up. */
static const double BALANCE_TOLERANCE = 1e-13;
static const uint32_t MOST_BALANCE_STEPS = 8;
/* A point goes no farther than this many times its free way and the depth of contacts. */
static const double FARTHEST = 100.0;
/* The majorant takes energy only where its linear system is really solved. */
static const uint32_t MAJORANT_CAP = 32;
static const double MAJORANT_TOLERANCE = 1e-10;

static uint32_t total_rows(const TbSolve *solve) { return solve->stride + TB_SLOTS; }

static bool in_play(const TbSolve *solve, uint32_t slot) { return solve->slot_mask >> slot & 1u; }

/* ---- M x ------------------------------------------------------------------------------------ */

void tb_solve_stretch(const TbSolve *solve, const double *pushed, const double *slots,
                      double *answer, double *out) {
  const uint32_t size = solve->bed->size;
  double along[2] = {0.0, 0.0};
  for (uint32_t h = 0; h < solve->stretch_count; h++) {
    along[h] = solve->kernels->dot(size, solve->stretch_grid[h], pushed) +
               solve->kernels->dot(TB_SLOTS, solve->stretch_slots[h], slots);
  }
  for (uint32_t h = 0; h < solve->stretch_count; h++) {
    const double *w = solve->stretch_weight[h];
    const double pull = -(w[0] * along[0] + w[1] * along[1]);
    solve->kernels->add_scaled(size, answer, pull, solve->stretch_grid[h]);
    solve->kernels->add_scaled(TB_SLOTS, out, pull, solve->stretch_slots[h]);
  }
}

void tb_solve_slots(const TbSolve *solve, const double *pushed, const double *slots, double *answer,
                    double *out) {
  const uint32_t size = solve->bed->size;
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    out[slot] = 0.0;
    if (!in_play(solve, slot)) continue;
    const double *coupling = solve->coupling + (uint64_t)slot * size;
    out[slot] = solve->kernels->dot(size, coupling, pushed);
    for (uint32_t other = 0; other < TB_SLOTS; other++) {
      out[slot] += solve->slot_coupling[slot * TB_SLOTS + other] * slots[other];
    }
    if (slots[slot] != 0.0) solve->kernels->add_scaled(size, answer, slots[slot], coupling);
  }
}

/* out = M x, and x on the grid; without `wires` x is 0 at all wire points. */
static void product_of(const TbSolve *solve, bool wires, const double *x, double *grid,
                       double *out) {
  const size_t bytes = solve->bed->size * sizeof(double);
  double *slots = out + solve->stride;
  if (wires) {
    tb_bed_contract(solve->bed, solve->kernels, x, solve->scratch, grid);
    tb_compliance_apply(solve->compliance, solve->kernels, grid, solve->answer);
  } else {
    memset(grid, 0, bytes);
    memset(solve->answer, 0, bytes);
  }
  tb_solve_slots(solve, grid, x + solve->stride, solve->answer, slots);
  tb_solve_stretch(solve, grid, x + solve->stride, solve->answer, slots);
  if (solve->lifted) {
    memset(out, 0, solve->stride * sizeof(double));
  } else {
    tb_bed_expand(solve->bed, solve->kernels, solve->answer, solve->scratch, out);
  }
  solve->kernels->add_product(total_rows(solve), out, solve->own, x);
}

void tb_solve_product(const TbSolve *solve, const double *x, double *grid, double *out) {
  if (tb_solves_in_single(solve)) {
    tb_single_product(solve, x, grid, out);
  } else {
    product_of(solve, true, x, grid, out);
  }
}

/* ---- laws ----------------------------------------------------------------------------------- */

static bool wires_touch(const TbSolve *solve, const double *s) {
  return solve->kernels->touches(solve->stride, solve->y, s, solve->force);
}

static void slot_laws(TbSolve *solve, const double *s) {
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    const uint32_t row = solve->stride + slot;
    TbLawResult law = {0.0, 0.0, 0.0};
    if (in_play(solve, slot)) law = tb_law_force(&solve->slot_laws[slot], solve->y[row], s[row]);
    solve->law_force[row] = law.force;
    solve->slope[row] = law.slope;
    solve->mean[row] = law.mean;
  }
}

/* Forces, slopes and means of the laws at s. */
static void apply_laws(TbSolve *solve, const double *s) {
  const uint32_t lanes = solve->bed->lanes;
  for (uint32_t at = 0; solve->wires && at < solve->stride; at += lanes) {
    tb_law_forces(&solve->wire_laws[at / lanes], solve->kernels, lanes, solve->y + at, s + at,
                  solve->law_force + at, solve->slope + at, solve->mean + at);
  }
  slot_laws(solve, s);
}

/* The laws at s; returns the largest difference from the forces that led there. */
static double evaluate(TbSolve *solve) {
  solve->wires = solve->wires || wires_touch(solve, solve->s);
  apply_laws(solve, solve->s);
  return solve->kernels->difference(total_rows(solve), solve->law_force, solve->force);
}

static uint32_t count_touching(const TbSolve *solve) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < total_rows(solve); i++) count += solve->slope[i] > 0.0;
  return count;
}

/* ---- one Newton step ------------------------------------------------------------------------ */

/* r = s + M f - b with the laws' forces, whose response is left in `product` and `grid`; returns
 * max |r|. */
static double find_residual(TbSolve *solve) {
  TB_STAGE(PRODUCT);
  product_of(solve, solve->wires, solve->law_force, solve->grid, solve->product);
  TB_STAGE(LAWS);
  return solve->kernels->residual(total_rows(solve), solve->s, solve->b, solve->product,
                                  solve->residual);
}

/* Solves (I + W M W) p = right, given in `residual`, by conjugate gradients from p = 0, W = diag(weight),
 * into `solution`; adds M W p to `product`, and W p on the grid to `grid`. */
static void solve_inner(TbSolve *solve, uint32_t cap, double tolerance) {
  const TbKernels *kernels = solve->kernels;
  const uint32_t length = total_rows(solve);
  double *right = solve->residual, *d = solve->direction;
  memset(solve->solution, 0, length * sizeof(double));
  memcpy(d, right, length * sizeof(double));
  double square = kernels->dot(length, right, right);
  const double enough = square * tolerance * tolerance;
  for (uint32_t i = 0; i < cap && square > enough; i++) {
    kernels->product(length, solve->work, solve->weight, d);
    TB_STAGE(PRODUCT);
    product_of(solve, solve->wires, solve->work, solve->pushed, solve->moved);
    TB_STAGE(LAWS);
    const double bend = kernels->turn(length, solve->turned, d, solve->weight, solve->moved);
    const double step = square / bend;
    const double next = kernels->advance(length, step, solve->solution, d, right, solve->turned);
    kernels->add_scaled(length, solve->product, step, solve->moved);
    kernels->add_scaled(solve->bed->size, solve->grid, step, solve->pushed);
    kernels->redirect(length, next / square, d, right);
    square = next;
  }
}

/* s = b - M f */
static void follow(TbSolve *solve) {
  solve->kernels->subtract(total_rows(solve), solve->b, solve->product, solve->s);
}

static void take_law_forces(TbSolve *solve) {
  memcpy(solve->force, solve->law_force, total_rows(solve) * sizeof(double));
  follow(solve);
}

/* force = law_force + weight solution, and s with it. */
static void newton_step(TbSolve *solve, uint32_t inner_cap, double inner_tolerance) {
  solve->kernels->weigh(total_rows(solve), solve->slope, solve->weight, solve->residual);
  solve_inner(solve, inner_cap, inner_tolerance);
  solve->kernels->add_product(total_rows(solve), solve->law_force, solve->weight, solve->solution);
  take_law_forces(solve);
}

/* ---- the balance ---------------------------------------------------------------------------- */

/* Sum s (f(s) - f~), its derivative in t, and Sum |s f~|, at f~ + t g and s - t M g. */
typedef struct Balance {
  double value, derivative, scale;
} Balance;

static Balance balance_at(const TbSolve *solve, const double *s, double t) {
  double sums[3];
  solve->kernels->balance(total_rows(solve), t, s, solve->law_force, solve->slope, solve->force,
                          solve->previous, solve->product, solve->previous_product, sums);
  return (Balance){sums[0], sums[1], sums[2]};
}

/* x += t (x - before) */
static void move_on(const TbSolve *solve, uint32_t n, double t, double *x, const double *before) {
  solve->kernels->extrapolate(n, t, x, before, x, x);
}

/* force += t g, and what follows from it. */
static void move_forces(TbSolve *solve, double t) {
  const uint32_t rows = total_rows(solve);
  move_on(solve, rows, t, solve->force, solve->previous);
  move_on(solve, rows, t, solve->product, solve->previous_product);
  move_on(solve, solve->bed->size, t, solve->grid, solve->previous_grid);
  follow(solve);
}

/* Moves the forces to where their work is what the laws say, and leaves that place's laws; false if that
 * is further than `reach` away, or where wires touch that took no part. The laws have just been evaluated at
 * s. */
static bool balance(TbSolve *solve, double reach) {
  double *s = solve->s, t = 0.0;
  Balance h = balance_at(solve, s, t);
  for (uint32_t i = 0; fabs(h.value) > BALANCE_TOLERANCE * h.scale; i++) {
    if (i == MOST_BALANCE_STEPS) return false;
    t -= h.value / h.derivative;
    if (!(fabs(t) <= reach)) return false;
    s = solve->work;
    solve->kernels->extrapolate(total_rows(solve), -t, solve->product, solve->previous_product,
                                solve->s, s);
    apply_laws(solve, s);
    h = balance_at(solve, s, t);
  }
  if (t == 0.0) return true;
  move_forces(solve, t);
  return solve->wires || !wires_touch(solve, solve->s);
}

/* What the laws lose in a step, with the values of the last evaluation, which was at s. */
static void book_losses(const TbSolve *solve, TbSolveOutcome *outcome) {
  double contact = solve->kernels->lost(solve->stride, solve->s, solve->law_force, solve->mean);
  double damper = 0.0;
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    if (!in_play(solve, slot)) continue;
    const uint32_t row = solve->stride + slot;
    const bool hand = solve->slot_laws[slot].kind == TB_LAW_DAMPER;
    *(hand ? &damper : &contact) += solve->s[row] * (solve->law_force[row] - solve->mean[row]);
  }
  outcome->contact_loss = 0.5 * contact;
  outcome->damper_loss = 0.5 * damper;
}

/* ---- the majorant --------------------------------------------------------------------------- */

/* Curvature of the parabola through V(y) with slope V'(y) that lies above V between y and y + sp. */
static double majorant_curvature(const TbLaw *law, double y, double b, double free) {
  double sp = free > 0.0 ? free : 0.0;
  if (b > sp) sp = 0.5 * (sp + b);
  const double size = fabs(y) > sp ? fabs(y) : sp;
  if (sp <= 1e-9 * size) return tb_law_curvature(law, y);
  const double bend = tb_law_work(law, y, sp) - tb_law_static_force(law, y) * sp;
  return bend > 0.0 ? 2.0 * bend / (sp * sp) : 0.0;
}

/* NULL for a slot that is not in play. */
static const TbLaw *law_of(const TbSolve *solve, uint32_t row) {
  if (row < solve->stride) return &solve->wire_laws[row / solve->bed->lanes];
  const uint32_t slot = row - solve->stride;
  return in_play(solve, slot) ? &solve->slot_laws[slot] : NULL;
}

/* V'' is nowhere larger (law.h): this parabola lies above V whatever s turns out to be. */
static double largest_curvature(const TbLaw *law) { return tb_law_curvature(law, 1e3); }

/* Force at s = 0 and half the curvature of every row's majorant; `safe` where the last one failed: what
 * touched at its s takes the largest curvature. */
static void prepare_majorants(TbSolve *solve, bool safe) {
  for (uint32_t row = 0; row < total_rows(solve); row++) {
    const TbLaw *law = law_of(solve, row);
    solve->law_force[row] = solve->slope[row] = 0.0;
    if (!law) continue;
    const double y = solve->y[row], b = solve->b[row];
    const bool touches = y > 0.0 || y + solve->s[row] > 0.0;
    solve->law_force[row] = tb_law_static_force(law, y);
    if (law->kind == TB_LAW_DAMPER) {
      solve->slope[row] = law->loss;
    } else if (safe && touches) {
      solve->slope[row] = 0.5 * largest_curvature(law);
    } else {
      solve->slope[row] = 0.5 * majorant_curvature(law, y, b, b - solve->previous_product[row]);
    }
  }
}

/* Work still to be found for the growth of the potential: > 0 means energy was created; and what the
 * laws lose at s. */
static Balance majorant_work(const TbSolve *solve, double *contact, double *damper) {
  Balance h = {0.0, 0.0, 0.0};
  for (uint32_t row = 0; row < total_rows(solve); row++) {
    const TbLaw *law = law_of(solve, row);
    if (!law) continue;
    const double work = solve->force[row] * solve->s[row];
    h.value += tb_law_work(law, solve->y[row], solve->s[row]) - work;
    h.scale += fabs(work);
    *(law->kind == TB_LAW_DAMPER ? damper : contact) +=
      tb_law_loss(law, solve->y[row], solve->s[row]);
  }
  return h;
}

/* One linear step, f = V'(y) + C s/2. */
static void majorant_step(TbSolve *solve, bool safe, TbSolveOutcome *outcome) {
  const size_t bytes = total_rows(solve) * sizeof(double);
  solve->wires = true;
  prepare_majorants(solve, safe);
  memset(solve->s, 0, bytes);
  find_residual(solve);
  newton_step(solve, MAJORANT_CAP, MAJORANT_TOLERANCE);
  for (uint32_t row = 0; row < total_rows(solve); row++) {
    const TbLaw *law = law_of(solve, row);
    if (!law) continue;
    solve->force[row] = tb_law_static_force(law, solve->y[row]) + solve->slope[row] * solve->s[row];
  }
  product_of(solve, true, solve->force, solve->grid, solve->product);
  follow(solve);
  double contact = 0.0, damper = 0.0;
  const Balance h = majorant_work(solve, &contact, &damper);
  outcome->excess = h.value > BALANCE_TOLERANCE * h.scale ? h.value : 0.0;
  /* The laws' losses count as far as the work done covers them. */
  const double lost = contact + damper, covered = h.value < 0.0 ? -0.5 * h.value : 0.0;
  const double part = lost > covered ? covered / lost : 1.0;
  outcome->contact_loss = part * contact;
  outcome->damper_loss = part * damper;
}

/* ---- the solve ------------------------------------------------------------------------------ */

/* What rounding leaves of a residual, and how large no s can be. */
typedef struct Bounds {
  double noise, farthest;
} Bounds;

static Bounds bounds_of(const TbSolve *solve) {
  const TbPair size = solve->kernels->sizes(total_rows(solve), solve->b, solve->y);
  return (Bounds){RELATIVE_TOLERANCE * size.first + PENETRATION_TOLERANCE * size.second,
                  FARTHEST * (size.first + size.second)};
}

/* A Newton step that was solved too coarsely, over contacts too stiff for it, throws points about; the next
 * one would throw them farther, since forces with loss grow with the square of s. */
static bool went_astray(const TbSolve *solve, double farthest) {
  return !(solve->kernels->sizes(total_rows(solve), solve->s, solve->y).first <= farthest);
}

/* Whether a striker, hand or muffler may touch. */
static bool slots_act(const TbSolve *solve) {
  for (uint32_t slot = 0; solve->slot_mask >> slot; slot++) {
    const uint32_t row = solve->stride + slot;
    if (!in_play(solve, slot)) continue;
    if (solve->slot_laws[slot].kind == TB_LAW_DAMPER) return true;
    if (solve->y[row] > 0.0 || solve->y[row] + solve->b[row] > 0.0) return true;
    if (solve->force[row] != 0.0) return true;
  }
  return false;
}

void tb_solve_forget(TbSolve *solve) {
  memset(solve->force, 0, total_rows(solve) * sizeof(double));
  memset(solve->product, 0, total_rows(solve) * sizeof(double));
  memset(solve->grid, 0, solve->bed->size * sizeof(double));
}

static void come_to_rest(TbSolve *solve) {
  tb_solve_forget(solve);
  memcpy(solve->s, solve->b, total_rows(solve) * sizeof(double));
}

/* Newton's iteration; true if it came to its end, with forces, product, grid and s set. */
static bool iterate(TbSolve *solve, TbSolveOutcome *outcome, bool *astray) {
  const Bounds bounds = bounds_of(solve);
  double first = 0.0;
  for (;;) {
    *astray = outcome->iterations > 0 && went_astray(solve, bounds.farthest);
    if (*astray) return false;
    const double miss = evaluate(solve);
    if (miss == 0.0) return true;
    if (outcome->iterations == 0) first = miss;
    if (outcome->iterations > 0 && miss <= solve->tolerance * first) {
      if (balance(solve, 0.1)) return true;
      evaluate(solve); /* it may have left the laws of another place */
    }
    if (solve->tolerance > 0.0 && outcome->iterations == solve->cap) return false;
    const double error = find_residual(solve);
    if (error <= bounds.noise) {
      take_law_forces(solve);
      return true;
    }
    if (outcome->iterations == solve->cap) {
      product_of(solve, solve->wires, solve->force, solve->grid, solve->product);
      follow(solve);
      return false;
    }
    newton_step(solve, solve->inner_cap, solve->inner_tolerance);
    outcome->iterations++;
  }
}

/* Where Newton came to no end. */
static void remedy(TbSolve *solve, bool astray, TbSolveOutcome *outcome) {
  outcome->capped = true;
  if (!astray) {
    evaluate(solve);
    if (balance(solve, 0.5)) {
      outcome->corrected = true;
      book_losses(solve, outcome);
      return;
    }
  }
  outcome->fallback = true;
  majorant_step(solve, false, outcome);
  if (outcome->excess > 0.0) majorant_step(solve, true, outcome);
}

static void start(TbSolve *solve) {
  const size_t bytes = total_rows(solve) * sizeof(double);
  memcpy(solve->previous, solve->force, bytes);
  memcpy(solve->previous_product, solve->product, bytes);
  memcpy(solve->previous_grid, solve->grid, solve->bed->size * sizeof(double));
  follow(solve);
  solve->wires = wires_touch(solve, solve->s);
  if (solve->wires) return;
  memset(solve->law_force, 0, bytes);
  memset(solve->slope, 0, bytes);
  memset(solve->mean, 0, bytes);
}

TbSolveOutcome tb_solve(TbSolve *solve) {
  TbSolveOutcome outcome = {0};
  const bool near = tb_solves_in_single(solve) ? solve->near : wires_touch(solve, solve->b);
  if (!near && !slots_act(solve)) {
    come_to_rest(solve);
    return outcome;
  }
  if (tb_solves_in_single(solve) && tb_single_solve(solve, &outcome)) return outcome;
  outcome.contact = true;
  /* What single precision left is rounded. */
  if (tb_solves_in_single(solve)) {
    product_of(solve, true, solve->force, solve->grid, solve->product);
  }
  start(solve);
  bool astray = false;
  if (iterate(solve, &outcome, &astray)) {
    book_losses(solve, &outcome);
  } else {
    remedy(solve, astray, &outcome);
  }
  outcome.touching = count_touching(solve);
  return outcome;
}
