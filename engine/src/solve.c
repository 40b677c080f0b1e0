/* SPDX-License-Identifier: MIT */
#include "solve.h"

#include <math.h>

/* Newton has converged when the residual is rounding noise of what it is a difference of. */
static const double RELATIVE_TOLERANCE = 1e-13;
static const double PENETRATION_TOLERANCE = 4e-15;
/* Inner solves stop here; the outer steps then still converge almost quadratically. */
static const double INNER_TOLERANCE = 1e-7;

#define FOR_ROWS(solve, row)                                                                       \
  for (uint32_t row = tb_solve_next(solve, UINT32_MAX),                                            \
                row##_end = (solve)->stride + TB_SLOTS;                                            \
       row < row##_end; row = tb_solve_next(solve, row))

void tb_solve_product(const TbSolve *solve, const double *x, double *out) {
  const uint32_t stride = solve->stride, total = stride + TB_SLOTS;
  for (uint32_t i = 0; i < total; i++) out[i] = 0.0;
  FOR_ROWS(solve, row) {
    if (x[row] == 0.0) continue;
    if (row >= stride) {
      solve->kernels->add_scaled(total, out, x[row],
                                 solve->coupling + (uint64_t)(row - stride) * total);
    } else {
      solve->kernels->add_scaled(stride, out, x[row], solve->compliance + (uint64_t)row * stride);
      for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
        out[stride + slot] += x[row] * solve->coupling[(uint64_t)slot * total + row];
      }
    }
    out[row] += solve->own[row] * x[row];
  }
}

static bool could_touch(const TbSolve *solve) {
  FOR_ROWS(solve, row) {
    if (solve->y[row] > 0.0 || solve->y[row] + solve->b[row] > 0.0) return true;
    if (tb_solve_law(solve, row)->kind == TB_LAW_DAMPER) return true;
  }
  return false;
}

/* Forces and slopes at s, and r = s + M f - b; returns max |r|. */
static double evaluate(TbSolve *solve, uint32_t *touching) {
  *touching = 0;
  FOR_ROWS(solve, row) {
    const TbLawResult law = tb_law_force(tb_solve_law(solve, row), solve->y[row], solve->s[row]);
    solve->force[row] = law.force;
    solve->slope[row] = law.slope;
    *touching += law.slope > 0.0;
  }
  tb_solve_product(solve, solve->force, solve->product);
  double largest = 0.0;
  FOR_ROWS(solve, row) {
    const double r = solve->s[row] + solve->product[row] - solve->b[row];
    solve->residual[row] = r;
    if (fabs(r) > largest) largest = fabs(r);
  }
  return largest;
}

/* Solves (I + W M W) p = rhs, W = diag(weight), by conjugate gradients from p = 0; rhs is 0 where
 * weight is. On return `p` holds W p and `rhs` is used up. `direction`, `scaled`
 * and `work` are scratch. */
static void solve_inner(TbSolve *solve, double *rhs, double *p) {
  double *d = solve->direction, *md = solve->work;
  double square = 0.0;
  FOR_ROWS(solve, row) {
    p[row] = 0.0;
    d[row] = rhs[row];
    square += rhs[row] * rhs[row];
  }
  const double enough = square * INNER_TOLERANCE * INNER_TOLERANCE;
  for (uint32_t i = 0; i < solve->inner_cap && square > enough; i++) {
    FOR_ROWS(solve, row) { solve->scaled[row] = solve->weight[row] * d[row]; }
    tb_solve_product(solve, solve->scaled, md);
    double bend = 0.0;
    FOR_ROWS(solve, row) {
      md[row] = d[row] + solve->weight[row] * md[row];
      bend += d[row] * md[row];
    }
    const double step = square / bend;
    double next = 0.0;
    FOR_ROWS(solve, row) {
      p[row] += step * d[row];
      rhs[row] -= step * md[row];
      next += rhs[row] * rhs[row];
    }
    const double turn = next / square;
    square = next;
    FOR_ROWS(solve, row) { d[row] = rhs[row] + turn * d[row]; }
  }
  FOR_ROWS(solve, row) { p[row] *= solve->weight[row]; }
}

static void newton_step(TbSolve *solve) {
  double *rhs = solve->product, *p = solve->slope; /* both are free until the next evaluation */
  FOR_ROWS(solve, row) {
    solve->weight[row] = solve->slope[row] > 0.0 ? sqrt(solve->slope[row]) : 0.0;
    rhs[row] = -solve->weight[row] * solve->residual[row];
  }
  solve_inner(solve, rhs, p);
  tb_solve_product(solve, p, solve->work);
  FOR_ROWS(solve, row) { solve->s[row] -= solve->residual[row] + solve->work[row]; }
}

/* h(gamma) and its derivative; leaves s = b - gamma M f. `product` holds M f. */
typedef struct WorkBalance {
  double value, derivative, scale;
} WorkBalance;

static WorkBalance work_balance(TbSolve *solve, double gamma) {
  WorkBalance h = {0.0, 0.0, 0.0};
  FOR_ROWS(solve, row) {
    const TbLaw *law = tb_solve_law(solve, row);
    const double f = solve->force[row], mf = solve->product[row];
    const double s = solve->b[row] - gamma * mf;
    solve->s[row] = s;
    h.value += tb_law_work(law, solve->y[row], s) - gamma * f * s;
    h.derivative += -tb_law_static_force(law, solve->y[row] + s) * mf - f * s + gamma * f * mf;
    h.scale += fabs(f * s);
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
  if (gamma != 1.0) {
    outcome->corrected = true;
    FOR_ROWS(solve, row) { solve->force[row] *= gamma; }
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

/* `previous` holds the last sample's forces on entry. */
static void majorant_step(TbSolve *solve, const double *previous) {
  double *curvature = solve->slope, *rhs = solve->residual, *p = solve->product;
  tb_solve_product(solve, previous, solve->work);
  FOR_ROWS(solve, row) {
    const TbLaw *law = tb_solve_law(solve, row);
    const double free = solve->b[row] - solve->work[row];
    const double half = law->kind == TB_LAW_DAMPER
                            ? law->loss
                            : 0.5 * majorant_curvature(law, solve->y[row], solve->b[row], free);
    curvature[row] = half;
    solve->weight[row] = sqrt(half);
    solve->force[row] = tb_law_static_force(law, solve->y[row]);
  }
  tb_solve_product(solve, solve->force, solve->work);
  FOR_ROWS(solve, row) {
    solve->s[row] = solve->b[row] - solve->work[row];
    rhs[row] = solve->weight[row] * solve->s[row];
  }
  solve_inner(solve, rhs, p);
  tb_solve_product(solve, p, solve->work);
  FOR_ROWS(solve, row) { solve->force[row] += curvature[row] * (solve->s[row] - solve->work[row]); }
  tb_solve_product(solve, solve->force, p);
}

static void remedy(TbSolve *solve, const double *previous, TbSolveOutcome *outcome) {
  outcome->capped = true;
  if (correct_work(solve, outcome)) return;
  outcome->fallback = true;
  majorant_step(solve, previous);
  const WorkBalance h = work_balance(solve, 1.0);
  if (h.value > balance_tolerance(h)) outcome->excess = h.value;
}

static double tolerance(const TbSolve *solve) {
  double change = 0.0, depth = 0.0;
  FOR_ROWS(solve, row) {
    if (fabs(solve->b[row]) > change) change = fabs(solve->b[row]);
    if (solve->y[row] > depth) depth = solve->y[row];
  }
  return RELATIVE_TOLERANCE * change + PENETRATION_TOLERANCE * depth;
}

TbSolveOutcome tb_solve(TbSolve *solve) {
  TbSolveOutcome outcome = {0};
  const uint32_t total = solve->stride + TB_SLOTS;
  if (!could_touch(solve)) {
    for (uint32_t row = 0; row < total; row++) {
      solve->force[row] = 0.0;
      solve->s[row] = solve->b[row];
    }
    return outcome;
  }
  outcome.contact = true;
  double *previous = solve->previous;
  for (uint32_t row = 0; row < total; row++) previous[row] = solve->force[row];

  tb_solve_product(solve, solve->force, solve->product);
  FOR_ROWS(solve, row) { solve->s[row] = solve->b[row] - solve->product[row]; }
  const double enough = tolerance(solve);
  double error = evaluate(solve, &outcome.touching);
  while (!(error <= enough) && outcome.iterations < solve->cap) {
    newton_step(solve);
    outcome.iterations++;
    error = evaluate(solve, &outcome.touching);
  }
  if (error <= enough) {
    FOR_ROWS(solve, row) { solve->s[row] = solve->b[row] - solve->product[row]; }
  } else {
    remedy(solve, previous, &outcome);
  }
  return outcome;
}
