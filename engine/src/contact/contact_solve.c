/* SPDX-License-Identifier: MIT */
/* The contact solve in double. */
#include "contact/contact_solve_tmpl.h"

/* ---- input ---------------------------------------------------------------------------------- */

static const double *b_of(const TbSolve *solve) { return solve->in.b; }
static const double *y_of(const TbSolve *solve) { return solve->in.y; }
static const double *contact_compliance_of(const TbSolve *solve) {
  return solve->in.contact_compliance;
}
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
  return solve->in.kernels->touches(tb_wire_rows(&solve->in.rows), solve->in.y, s,
                                    solve->warm.force);
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
  const double *slots = x + tb_slot_row(&solve->in.rows, 0);
  double *answer = solve->work.answer, *moved = out + tb_slot_row(&solve->in.rows, 0);
  tb_solve_slots(&solve->in, grid, slots, answer, moved);
  tb_solve_stretch(&solve->in, grid, slots, answer, moved);
}

/* ---- Newton --------------------------------------------------------------------------------- */

/* r = s + M f - b with the laws' forces, whose response is left in `product` and `grid`, and in
 * `direction` what the step is to solve for. */
static TbResidual find_residual(TbSolve *solve) {
  const TbSolveWork *work = &solve->work;
  product_of(solve, work->wires, work->law, work->grid, work->product);
  return solve->in.kernels->newton_rhs(total_rows(solve), work->slope, work->s, solve->in.b,
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
  return solve->in.kernels->newton_finish(rows, work->law, work->weight, work->solution,
                                          solve->in.b, work->product, work->force, work->s);
}

static void take_law_forces(TbSolve *solve) {
  const TbSolveWork *work = &solve->work;
  memcpy(work->force, work->law, total_rows(solve) * sizeof(double));
  solve->in.kernels->change(total_rows(solve), solve->in.b, work->product, work->s);
}

/* M f~ and s of the forces f~. */
static void follow_forces(TbSolve *solve) {
  const TbSolveWork *work = &solve->work;
  product_of(solve, work->wires, work->force, work->grid, work->product);
  solve->in.kernels->change(total_rows(solve), solve->in.b, work->product, work->s);
}

/* A Newton step half the way: where slopes of laws with much loss break, whole steps may go round
 * in a circle of four. The output s is room for the forces before. */
static void half_step(TbSolve *solve, TbResidual found) {
  const TbSolveWork *work = &solve->work;
  const uint32_t rows = total_rows(solve);
  memcpy(solve->s, work->force, rows * sizeof(double));
  newton_step(solve, found, solve->in.inner_cap, solve->in.inner_tolerance);
  for (uint32_t i = 0; i < rows; i++) work->force[i] = 0.5 * (work->force[i] + solve->s[i]);
  follow_forces(solve);
}

enum { CIRCLE = 4 };            /* steps */
static const double LESS = 0.7; /* of a residual: what settles falls by more in so many steps */

/* Whether steps go round in a circle, from the sixth on. residuals[CIRCLE]: of the last ones. */
static bool circles(const TbSolve *solve, uint32_t step, double residual, double *residuals) {
  double *before = &residuals[step % CIRCLE];
  const bool does = solve->in.lossy && step > CIRCLE && residual > LESS * *before;
  *before = does ? INFINITY : residual;
  return does;
}

/* Newton's iteration; true if it came to its end and all is given back. */
static bool newton(TbSolve *solve, TbStart size, double enough, bool *astray,
                   TbSolveOutcome *outcome) {
  const uint32_t cap = solve->in.cap;
  double way = 0.0, residuals[CIRCLE];
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
      follow_forces(solve);
      return false;
    }
    if (circles(solve, i, found.largest, residuals)) {
      half_step(solve, found);
      continue;
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

static bool solve_contacts(TbSolve *solve, TbSolveOutcome *outcome) {
  const TbStart size = take_in(solve);
  outcome->iterations = 0;
  apply_laws(solve, solve->work.s);
  return iterate(solve, size, outcome);
}

/* ---- for others ----------------------------------------------------------------------------- */

static void product(TbSolve *solve, const double *x, double *grid, double *out) {
  product_of(solve, true, x, grid, out);
}

void tb_contact_newton_step(TbSolve *solve, uint32_t inner_cap, double inner_tolerance) {
  newton_step(solve, find_residual(solve), inner_cap, inner_tolerance);
}

const TbContactMethod tb_contact_method = {near, solve_contacts, product};
