/* SPDX-License-Identifier: MIT */
#include "solve.h"

#include <math.h>
#include <string.h>

/* Newton has converged when the residual is rounding noise of what it is a difference of. */
static const double RELATIVE_TOLERANCE = 1e-14;
static const double PENETRATION_TOLERANCE = 4e-15;
/* Inner solves stop here; the outer steps then still converge almost quadratically. */
static const double INNER_TOLERANCE = 1e-7;

static uint32_t total_rows(const TbSolve *solve) { return solve->stride + TB_SLOTS; }

static bool in_play(const TbSolve *solve, uint32_t slot) { return solve->slot_mask >> slot & 1u; }

/* ---- M x ------------------------------------------------------------------------------------ */

void tb_solve_stretch(const TbSolve *solve, const double *x, double *out) {
  double along[2] = {0.0, 0.0};
  for (uint32_t h = 0; h < solve->stretch_count; h++) {
    along[h] = solve->kernels->dot(total_rows(solve), solve->stretch_rows[h], x);
  }
  for (uint32_t h = 0; h < solve->stretch_count; h++) {
    const double pull =
      solve->stretch_weight[h][0] * along[0] + solve->stretch_weight[h][1] * along[1];
    solve->kernels->add_scaled(total_rows(solve), out, -pull, solve->stretch_rows[h]);
  }
}

void tb_solve_product(const TbSolve *solve, const double *x, double *out) {
  const uint32_t stride = solve->stride, total = total_rows(solve);
  for (uint32_t i = 0; i < total; i++) out[i] = solve->own[i] * x[i];
  for (uint32_t row = 0; row < solve->wire_rows; row++) {
    if (x[row] == 0.0) continue;
    solve->kernels->add_scaled(stride, out, x[row], solve->compliance + (uint64_t)row * stride);
  }
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    if (!in_play(solve, slot)) continue;
    const double *coupling = solve->coupling + (uint64_t)slot * total;
    out[stride + slot] += solve->kernels->dot(stride, coupling, x);
    if (x[stride + slot] != 0.0) solve->kernels->add_scaled(total, out, x[stride + slot], coupling);
  }
  tb_solve_stretch(solve, x, out);
}

/* ---- one evaluation ------------------------------------------------------------------------- */

static double largest_magnitude(uint32_t n, const double *x) {
  double most[8] = {0.0};
  for (uint32_t i = 0; i < n; i += 8) {
    for (uint32_t l = 0; l < 8; l++) {
      const double size = fabs(x[i + l]);
      most[l] = size > most[l] ? size : most[l];
    }
  }
  double largest = 0.0;
  for (uint32_t l = 0; l < 8; l++) largest = most[l] > largest ? most[l] : largest;
  return largest;
}

static bool could_touch(const TbSolve *solve) {
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    if (in_play(solve, slot) && solve->slot_laws[slot].kind == TB_LAW_DAMPER) return true;
  }
  for (uint32_t row = 0; row < total_rows(solve); row++) {
    if (solve->y[row] > 0.0 || solve->y[row] + solve->b[row] > 0.0) return true;
  }
  return false;
}

static void evaluate_row(TbSolve *solve, uint32_t row, uint32_t *touching) {
  const TbLawResult law = tb_law_force(tb_solve_law(solve, row), solve->y[row], solve->s[row]);
  solve->force[row] = law.force;
  solve->slope[row] = law.slope;
  if (law.slope > 0.0) solve->active[(*touching)++] = row;
}

/* Forces and slopes at s, the touching rows, M f, and r = s + M f - b; returns max |r|. */
static double evaluate(TbSolve *solve, uint32_t *touching) {
  *touching = 0;
  for (uint32_t row = 0; row < solve->wire_rows; row++) {
    if (solve->y[row] <= 0.0 && solve->y[row] + solve->s[row] <= 0.0) {
      solve->force[row] = 0.0;
    } else {
      evaluate_row(solve, row, touching);
    }
  }
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    if (in_play(solve, slot)) evaluate_row(solve, solve->stride + slot, touching);
  }
  tb_solve_product(solve, solve->force, solve->product);
  const uint32_t total = total_rows(solve);
  for (uint32_t i = 0; i < total; i++) {
    solve->residual[i] = solve->s[i] + solve->product[i] - solve->b[i];
  }
  return largest_magnitude(total, solve->residual);
}

/* ---- linear solves -------------------------------------------------------------------------- */

static void active_stretch(const TbSolve *solve, uint32_t n, const double *x, double *out) {
  double along[2] = {0.0, 0.0};
  for (uint32_t h = 0; h < solve->stretch_count; h++) {
    for (uint32_t i = 0; i < n; i++) along[h] += solve->stretch_rows[h][solve->active[i]] * x[i];
  }
  for (uint32_t h = 0; h < solve->stretch_count; h++) {
    const double pull =
      solve->stretch_weight[h][0] * along[0] + solve->stretch_weight[h][1] * along[1];
    for (uint32_t i = 0; i < n; i++) out[i] -= pull * solve->stretch_rows[h][solve->active[i]];
  }
}

/* out = M x over the first n active rows alone; wire points come before slots. */
static void active_product(const TbSolve *solve, uint32_t n, const double *x, double *out) {
  const uint32_t stride = solve->stride, total = total_rows(solve);
  const uint32_t *active = solve->active;
  uint32_t wires = n;
  while (wires > 0 && active[wires - 1] >= stride) wires--;
  for (uint32_t i = 0; i < n; i++) out[i] = solve->own[active[i]] * x[i];
  for (uint32_t j = 0; j < wires; j++) {
    const double *column = solve->compliance + (uint64_t)active[j] * stride;
    for (uint32_t i = 0; i < wires; i++) out[i] += column[active[i]] * x[j];
  }
  for (uint32_t j = wires; j < n; j++) {
    const double *column = solve->coupling + (uint64_t)(active[j] - stride) * total;
    for (uint32_t i = 0; i < wires; i++) {
      out[i] += column[active[i]] * x[j];
      out[j] += column[active[i]] * x[i];
    }
    for (uint32_t i = wires; i < n; i++) out[i] += column[active[i]] * x[j];
  }
  active_stretch(solve, n, x, out);
}

/* Solves (I + W M W) p = right over the first n active rows by conjugate gradients from p = 0, W =
 * diag(weight). On return `scaled` holds W p, spread over all rows; `right` is used up. */
static void solve_inner(TbSolve *solve, uint32_t n) {
  double *d = solve->direction, *md = solve->turned, *right = solve->right;
  double *p = solve->solution, *wd = solve->work;
  const double *weight = solve->weight;
  double square = 0.0;
  for (uint32_t i = 0; i < n; i++) {
    p[i] = 0.0;
    d[i] = right[i];
    square += right[i] * right[i];
  }
  const double enough = square * INNER_TOLERANCE * INNER_TOLERANCE;
  for (uint32_t k = 0; k < solve->inner_cap && square > enough; k++) {
    for (uint32_t i = 0; i < n; i++) wd[i] = weight[i] * d[i];
    active_product(solve, n, wd, md);
    double bend = 0.0;
    for (uint32_t i = 0; i < n; i++) {
      md[i] = d[i] + weight[i] * md[i];
      bend += d[i] * md[i];
    }
    const double step = square / bend;
    double next = 0.0;
    for (uint32_t i = 0; i < n; i++) {
      p[i] += step * d[i];
      right[i] -= step * md[i];
      next += right[i] * right[i];
    }
    const double turn = next / square;
    square = next;
    for (uint32_t i = 0; i < n; i++) d[i] = right[i] + turn * d[i];
  }
  for (uint32_t i = 0; i < total_rows(solve); i++) solve->scaled[i] = 0.0;
  for (uint32_t i = 0; i < n; i++) solve->scaled[solve->active[i]] = weight[i] * p[i];
}

static void newton_step(TbSolve *solve, uint32_t touching) {
  for (uint32_t i = 0; i < touching; i++) {
    const uint32_t row = solve->active[i];
    solve->weight[i] = sqrt(solve->slope[row]);
    solve->right[i] = -solve->weight[i] * solve->residual[row];
  }
  solve_inner(solve, touching);
  tb_solve_product(solve, solve->scaled, solve->work);
  for (uint32_t i = 0; i < total_rows(solve); i++) {
    solve->s[i] -= solve->residual[i] + solve->work[i];
  }
}

/* ---- remedies ------------------------------------------------------------------------------- */

/* h(gamma) and its derivative; leaves s = b - gamma M f. `product` holds M f. */
typedef struct WorkBalance {
  double value, derivative, scale;
} WorkBalance;

static void add_balance(TbSolve *solve, uint32_t row, double gamma, WorkBalance *h) {
  const TbLaw *law = tb_solve_law(solve, row);
  const double f = solve->force[row], mf = solve->product[row];
  const double s = solve->b[row] - gamma * mf;
  solve->s[row] = s;
  h->value += tb_law_work(law, solve->y[row], s) - gamma * f * s;
  h->derivative += -tb_law_static_force(law, solve->y[row] + s) * mf - f * s + gamma * f * mf;
  h->scale += fabs(f * s);
}

static WorkBalance work_balance(TbSolve *solve, double gamma) {
  WorkBalance h = {0.0, 0.0, 0.0};
  for (uint32_t row = 0; row < solve->wire_rows; row++) add_balance(solve, row, gamma, &h);
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    if (in_play(solve, slot)) add_balance(solve, solve->stride + slot, gamma, &h);
  }
  return h;
}

static double balance_tolerance(WorkBalance h) { return 1e-15 * h.scale; }

/* Scales the forces by the gamma nearest 1 that creates no energy; false if there is none. Newton's
 * steps on a convex function approach its zero from outside and never pass it. */
static bool correct_work(TbSolve *solve, TbSolveOutcome *outcome) {
  double gamma = 1.0;
  WorkBalance h = work_balance(solve, gamma);
  const double side = h.derivative;
  for (uint32_t i = 0; i < 24 && h.value > balance_tolerance(h); i++) {
    if (h.derivative == 0.0 || (h.derivative > 0.0) != (side > 0.0)) return false;
    gamma -= (h.value + 0.5 * balance_tolerance(h)) / h.derivative;
    if (!(gamma >= 0.0 && gamma < 16.0)) return false;
    h = work_balance(solve, gamma);
  }
  if (h.value > balance_tolerance(h)) return false;
  if (gamma == 1.0) return true;
  outcome->corrected = true;
  for (uint32_t i = 0; i < total_rows(solve); i++) {
    solve->force[i] *= gamma;
    solve->product[i] *= gamma;
  }
  return true;
}

/* Curvature of the parabola through V(y) with slope V'(y) that lies above V between y and y + sp. */
static double majorant_curvature(const TbLaw *law, double y, double b, double free) {
  double sp = free > 0.0 ? free : 0.0;
  if (b > sp) sp = 0.5 * (sp + b);
  const double size = fabs(y) > sp ? fabs(y) : sp;
  if (sp <= 1e-9 * size) return tb_law_curvature(law, y);
  const double bend = tb_law_work(law, y, sp) - tb_law_static_force(law, y) * sp;
  return bend > 0.0 ? 2.0 * bend / (sp * sp) : 0.0;
}

/* Force at s = 0 and half the curvature of one row's majorant; `work` holds M times the last forces. */
static void prepare_majorant(TbSolve *solve, uint32_t row, uint32_t *count) {
  const TbLaw *law = tb_solve_law(solve, row);
  const double y = solve->y[row], b = solve->b[row];
  solve->force[row] = tb_law_static_force(law, y);
  solve->slope[row] = law->kind == TB_LAW_DAMPER
                        ? law->loss
                        : 0.5 * majorant_curvature(law, y, b, b - solve->work[row]);
  if (solve->slope[row] > 0.0) solve->active[(*count)++] = row;
}

/* `previous` holds the last sample's forces on entry. */
static void majorant_step(TbSolve *solve) {
  uint32_t count = 0;
  tb_solve_product(solve, solve->previous, solve->work);
  for (uint32_t row = 0; row < solve->wire_rows; row++) prepare_majorant(solve, row, &count);
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    if (in_play(solve, slot)) prepare_majorant(solve, solve->stride + slot, &count);
  }
  tb_solve_product(solve, solve->force, solve->product);
  for (uint32_t i = 0; i < count; i++) {
    const uint32_t row = solve->active[i];
    solve->weight[i] = sqrt(solve->slope[row]);
    solve->right[i] = solve->weight[i] * (solve->b[row] - solve->product[row]);
  }
  solve_inner(solve, count);
  tb_solve_product(solve, solve->scaled, solve->work);
  for (uint32_t i = 0; i < count; i++) {
    const uint32_t row = solve->active[i];
    const double s = solve->b[row] - solve->product[row] - solve->work[row];
    solve->force[row] += solve->slope[row] * s;
  }
  tb_solve_product(solve, solve->force, solve->product);
}

static void remedy(TbSolve *solve, TbSolveOutcome *outcome) {
  outcome->capped = true;
  if (correct_work(solve, outcome)) return;
  outcome->fallback = true;
  majorant_step(solve);
  const WorkBalance h = work_balance(solve, 1.0);
  if (h.value > balance_tolerance(h)) outcome->excess = h.value;
}

/* ---- the solve ------------------------------------------------------------------------------ */

static double tolerance(const TbSolve *solve) {
  double depth = 0.0;
  for (uint32_t i = 0; i < total_rows(solve); i++) {
    depth = solve->y[i] > depth ? solve->y[i] : depth;
  }
  return RELATIVE_TOLERANCE * largest_magnitude(total_rows(solve), solve->b) +
         PENETRATION_TOLERANCE * depth;
}

/* s = b - M f over all rows, those of the padding included. */
static void respond(TbSolve *solve) {
  for (uint32_t i = 0; i < total_rows(solve); i++) solve->s[i] = solve->b[i] - solve->product[i];
}

TbSolveOutcome tb_solve(TbSolve *solve) {
  TbSolveOutcome outcome = {0};
  const size_t bytes = total_rows(solve) * sizeof(double);
  if (!could_touch(solve)) {
    memset(solve->force, 0, bytes);
    memset(solve->product, 0, bytes);
    memcpy(solve->s, solve->b, bytes);
    return outcome;
  }
  outcome.contact = true;
  memcpy(solve->previous, solve->force, bytes);
  respond(solve);
  const double enough = tolerance(solve);
  double error = evaluate(solve, &outcome.touching);
  while (!(error <= enough) && outcome.iterations < solve->cap) {
    newton_step(solve, outcome.touching);
    outcome.iterations++;
    error = evaluate(solve, &outcome.touching);
  }
  if (error <= enough) {
    respond(solve);
  } else {
    remedy(solve, &outcome);
  }
  return outcome;
}
