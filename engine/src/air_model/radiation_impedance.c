/* SPDX-License-Identifier: MIT */
/* Load and field of one mode at its frequency; the formulas are in air.h. */
#include <math.h>

#include "air_model/radiated_field.h"
#include "math/ldlt.h"
#include "math/portable_math.h"
#include "math/quadrature.h"

static const double PI = 3.14159265358979323846;

/* Sixteen nodes integrate a wave of 12.5 radians to rounding, one of 30 radians to 1e-7. */
static const TbAirPrecision EXACT = {.digits = 10.5, .panel = 12.5};
/* For short waves, and for drums, whose resistance is itself an interpolation: parts down to 60 dB
 * below the loudest are right to 0.1 dB, resistances to 1e-4 of the damping. */
static const TbAirPrecision FINE = {.digits = 4.5, .panel = 30.0};
static const TbAirPrecision COARSE = {.digits = 4.0, .panel = 30.0};

/* ---- the open head --------------------------------------------------------------------------- */

/* How much of the expansion one shape needs. Its terms n beyond (z - m)/2 vanish fast, z the
 * highest zero that takes part: for 10.5 digits with 1e-3 of the largest part, which changes the
 * load by 1e-6. */
static void widen_reach(const TbAirOrder *order, const double *v, TbAirPlan *plan) {
  double largest = 0.0;
  for (uint32_t i = 0; i < order->count; i++) largest = fmax(largest, fabs(v[i]));
  const double least = largest * tb_exp(-plan->precision.digits / 3.5 * tb_log(10.0));
  uint32_t last = 0;
  for (uint32_t i = 0; i < order->count; i++) {
    if (fabs(v[i]) > least) last = i;
  }
  plan->zero = fmax(plan->zero, order->zeros[last]);
  plan->terms = (uint32_t)fmax(0.0, 0.5 * (fmax(plan->zero, plan->x) - (double)order->m)) + 13u;
  if (plan->terms > order->terms) plan->terms = order->terms;
}

/* Lower triangles, row-major. */
typedef struct Matrix {
  uint32_t n;
  double *re, *im;
} Matrix;

/* out[a][b] += Sum_l factor[l] rows[l][a] rows[l][b], b <= a, over eight rows. */
static void add_outer8(uint32_t n, double *restrict out, const double factor[8],
                       const double *restrict rows) {
  for (uint32_t a = 0; a < n; a++) {
    double *restrict line = out + (size_t)a * n;
    const double f0 = factor[0] * rows[a], f1 = factor[1] * rows[n + a];
    const double f2 = factor[2] * rows[2 * n + a], f3 = factor[3] * rows[3 * n + a];
    const double f4 = factor[4] * rows[4 * n + a], f5 = factor[5] * rows[5 * n + a];
    const double f6 = factor[6] * rows[6 * n + a], f7 = factor[7] * rows[7 * n + a];
    if (f7 == 0.0) continue; /* far below its turning point, and more so in the rows before */
    for (uint32_t b = 0; b <= a; b++) {
      line[b] += f0 * rows[b] + f1 * rows[n + b] + (f2 * rows[2 * n + b] + f3 * rows[3 * n + b]) +
                 (f4 * rows[4 * n + b] + f5 * rows[5 * n + b] +
                  (f6 * rows[6 * n + b] + f7 * rows[7 * n + b]));
    }
  }
}

/* The rest of k^-2 sqrt(k^2 - x^2), k > x, without its first two terms 1/k and -x^2/(2 k^3),
 * for which Int_0^inf J_mu J_mu' dk is known ([DLMF] 10.22.57): 1/(2 mu) on the diagonal; for k^-3
 * 1/(4 (mu - 1) mu (mu + 1)) there and 1/(8 mu (mu + 1) (mu + 2)) beside it. It falls like x^4/(8
 * k^5). */
static double remainder_above(double x, double kappa, double root) {
  const double ratio = x / kappa, square = ratio * ratio;
  if (square < 1e-2) { /* the series, where the difference would cancel */
    return -square * square / (8.0 * kappa) *
           (1.0 + square * (0.5 + square * (0.3125 + 0.21875 * square)));
  }
  return (root - kappa + 0.5 * x * ratio) / (kappa * kappa);
}

/* Beyond the last node k the Bessel product counts as its mean (-1)^(n-n')/(pi k). */
static double tail_of(double x, double k) {
  return -x * x * x * x / (40.0 * PI * k * k * k * k * k);
}

static void closed_part(const TbAirPlan *plan, double tail, Matrix *c) {
  const uint32_t n = c->n;
  const double half_square = 0.5 * plan->x * plan->x;
  for (uint32_t a = 0; a < n; a++) {
    const double mu = (double)plan->order->m + 2.0 * a + 1.5;
    for (uint32_t b = 0; b <= a; b++) c->re[a * n + b] = (a + b) % 2 ? -tail : tail;
    c->re[a * n + a] += 0.5 / mu - half_square * 0.25 / ((mu - 1.0) * mu * (mu + 1.0));
    if (a > 0) c->re[a * n + a - 1] -= half_square * 0.125 / ((mu - 2.0) * (mu - 1.0) * mu);
  }
}

/* C(x) from the first `count` nodes, which end at k = `end`. */
static void open_matrix(const TbAirPlan *plan, const TbWavenumberNodes *nodes, uint32_t count,
                        double end, const double *rows, Matrix *c) {
  const double x = plan->x;
  closed_part(plan, tail_of(x, end), c);
  for (uint32_t q = 0; q < count; q += 8) {
    const bool below = q < nodes->below;
    double re[8], im[8];
    for (uint32_t l = 0; l < 8; l++) {
      const double kappa = nodes->kappa[q + l], root = nodes->root[q + l];
      const double weight = nodes->weights[q + l] * root / (below ? x : kappa); /* dkappa */
      re[l] = weight * (below ? (0.5 * x * x / kappa - kappa) / (kappa * kappa)
                              : remainder_above(x, kappa, root));
      im[l] = weight * root / (kappa * kappa);
    }
    add_outer8(c->n, c->re, re, rows + (size_t)q * c->n);
    if (below) add_outer8(c->n, c->im, im, rows + (size_t)q * c->n);
  }
}

/* Factors C(x) and solves for the expansions of all sources; keeps P at the nodes if fields ask. */
typedef struct Open {
  Matrix c;
  double *rows; /* half-order functions at the nodes */
  double *b;    /* one source's right-hand side */
} Open;

static bool open_prepare(Open *open, const TbAirPlan *plan, TbArena *scratch,
                         const TbWavenumberNodes *nodes, double top) {
  const size_t n = plan->terms;
  open->c = (Matrix){.n = plan->terms,
                     .re = tb_arena_doubles(scratch, n * n),
                     .im = tb_arena_doubles(scratch, n * n)};
  open->rows = tb_arena_doubles(scratch, n * nodes->count);
  open->b = tb_arena_doubles(scratch, n);
  if (scratch->failed ||
      !tb_air_half_orders(plan->order->m, plan->terms, scratch, nodes, open->rows)) {
    return false;
  }
  uint32_t count = nodes->count; /* whole panels up to `top` in t */
  while (count > nodes->below + TB_PANEL && nodes->root[count - TB_PANEL - 1] > top) {
    count -= TB_PANEL;
  }
  const double t = 0.5 * (nodes->root[count - TB_PANEL] + nodes->root[count - 1]) +
                   0.5 * nodes->panel; /* the panel's middle, and half of it */
  open_matrix(plan, nodes, count, tb_hypot(plan->x, t), open->rows, &open->c);
  return tb_factor_symmetric(scratch, plan->terms, open->c.re, open->c.im);
}

/* b_n = Sum_i v_i z_i^{-3/2} J_{mu_n}(z_i), a = C^-1 b, and P. */
static bool open_source(Open *open, const TbAirPlan *plan, TbArena *scratch,
                        const TbWavenumberNodes *nodes, TbAirSource *source) {
  const TbAirOrder *order = plan->order;
  source->a = tb_arena_doubles(scratch, 2 * (size_t)plan->terms);
  source->p = tb_arena_doubles(scratch, 2 * (size_t)nodes->count);
  if (scratch->failed) return false;
  for (uint32_t n = 0; n < plan->terms; n++) {
    open->b[n] = 0.0;
    for (uint32_t i = 0; i < order->count; i++) {
      open->b[n] += source->v[i] * order->expansion[i * order->terms + n];
    }
    source->a[2 * n] = open->b[n];
    source->a[2 * n + 1] = 0.0;
  }
  tb_solve_factored(plan->terms, open->c.re, open->c.im, source->a);
  tb_air_jump_transform(nodes, plan->terms, open->rows, source->a, source->p);
  return true;
}

/* The end of the nodes of C(x): what is left changes a load by less than 1e-5, of a drum 1e-3.
 */
static double open_top(const TbAirPlan *plan) {
  if (plan->precision.digits < 8.0) return fmax(24.0, 2.0 * plan->x + 14.0);
  return fmax(30.0, fmax(2.0 * plan->x + 20.0, plan->zero + 10.0));
}

/* ---- one head -------------------------------------------------------------------------------- */

static TbAirPlan plan_of(const TbAirOrder *order, double x, const TbAirPoint *points,
                         uint32_t point_count, TbAirPrecision precision) {
  return (TbAirPlan){
    .order = order, .points = points, .point_count = point_count, .x = x, .precision = precision};
}

/* Nodes for the fields and for a load that needs `top` in t above x. */
static bool nodes_for(TbWavenumberNodes *nodes, const TbAirPlan *plan, TbArena *scratch,
                      double top) {
  const TbAirTurns turns = {.low = tb_air_plan_turns(plan),
                            .high = fmax(2.0, plan->stretch),
                            .top = fmax(top, plan->top),
                            .panel = plan->precision.panel};
  return tb_wavenumber_nodes_prepare(nodes, scratch, plan->order, plan->x, turns);
}

static bool transform(const TbAirPlan *plan, TbArena *scratch, const TbWavenumberNodes *nodes,
                      TbAirSource *source) {
  source->w = tb_arena_doubles(scratch, nodes->count);
  if (!source->w) return false;
  tb_air_transform(plan->order, nodes, source->v, source->w);
  return true;
}

/* Int W^2 over what radiates, times x: half of both sides' resistance. */
static double radiated(const TbWavenumberNodes *nodes, const double *w) {
  double sum = 0.0;
  for (uint32_t q = 0; q < nodes->below; q++) {
    sum += nodes->weights[q] * nodes->kappa[q] * w[q] * w[q];
  }
  return sum;
}

static TbAirLoad load_baffled(const TbWavenumberNodes *nodes, const double *w) {
  double stored = 0.0;
  for (uint32_t q = nodes->below; q < nodes->count; q++) {
    stored += nodes->weights[q] * w[q] * w[q];
  }
  return (TbAirLoad){.mass = 2.0 * stored, .resistance = 2.0 * radiated(nodes, w)};
}

static TbAirLoad load_open(const Open *open, const TbAirPlan *plan, const double *a) {
  double mass = 0.0, lost = 0.0;
  for (uint32_t n = 0; n < plan->terms; n++) {
    mass += open->b[n] * a[2 * n];
    lost += open->b[n] * a[2 * n + 1];
  }
  return (TbAirLoad){.mass = 2.0 * mass, .resistance = -2.0 * plan->x * lost};
}

bool tb_air_load(const TbAirOrder *order, TbArena *scratch, TaborBoundary boundary, bool exact,
                 const double *v, double x, const TbAirPoint *points, uint32_t point_count,
                 TbAirLoad *load, double *fields) {
  const bool is_open = boundary == TABOR_BOUNDARY_OPEN;
  TbAirPlan plan = plan_of(order, x, points, point_count, exact ? EXACT : FINE);
  TbAirSource source = {.v = v,
                        .up = 1.0,
                        .baffled = is_open ? 0.0 : 1.0,
                        .open = is_open ? 1.0 : 0.0,
                        .mirrored = !is_open};
  widen_reach(order, v, &plan);
  tb_air_plan_fields(&plan, &source, 1);
  const double top = is_open ? open_top(&plan) : fmax(60.0, 4.0 * order->zeros[order->count - 1]);
  TbWavenumberNodes nodes;
  if (!nodes_for(&nodes, &plan, scratch, top)) return false;
  if (is_open) {
    Open open;
    if (!open_prepare(&open, &plan, scratch, &nodes, top) ||
        !open_source(&open, &plan, scratch, &nodes, &source)) {
      return false;
    }
    *load = load_open(&open, &plan, source.a);
  } else {
    if (!transform(&plan, scratch, &nodes, &source)) return false;
    *load = load_baffled(&nodes, source.w);
  }
  return point_count == 0 || tb_air_fields(&plan, scratch, &nodes, &source, 1, fields);
}

bool tb_air_baffled(const TbAirOrder *order, TbArena *scratch, bool both_sides, const double *v,
                    double x, const TbAirPoint *points, uint32_t point_count, double *resistance,
                    double *fields) {
  TbAirPlan plan = plan_of(order, x, points, point_count, COARSE);
  TbAirSource source = {.v = v, .up = 1.0, .baffled = 1.0, .mirrored = both_sides};
  widen_reach(order, v, &plan);
  tb_air_plan_fields(&plan, &source, 1);
  TbWavenumberNodes nodes;
  if (!nodes_for(&nodes, &plan, scratch, 0.0) || !transform(&plan, scratch, &nodes, &source)) {
    return false;
  }
  *resistance = (both_sides ? 2.0 : 1.0) * radiated(&nodes, source.w);
  return point_count == 0 || tb_air_fields(&plan, scratch, &nodes, &source, 1, fields);
}

/* ---- a drum ---------------------------------------------------------------------------------- */

/* The bracket of air.h's resistance at one node below x; `second` may be NULL. */
static double drum_integrand(const TbWavenumberNodes *nodes, const TbAirSource *first,
                             const TbAirSource *second, double depth, uint32_t q) {
  const double root = nodes->root[q], square = root * root; /* x cos t */
  const double w1 = first->w[q], *p1 = first->p + 2 * q;
  const double sum = w1 * w1 + square * (p1[0] * p1[0] + p1[1] * p1[1]);
  if (!second) return sum;
  const double w2 = second->w[q], *p2 = second->p + 2 * q;
  double sine, cosine;
  tb_sin_cos(root * depth, &sine, &cosine);
  return sum + w2 * w2 + square * (p2[0] * p2[0] + p2[1] * p2[1]) +
         2.0 * cosine * (w1 * w2 - square * (p1[0] * p2[0] + p1[1] * p2[1])) -
         2.0 * sine * root * (w1 * p2[0] + w2 * p1[0]);
}

static double drum_resistance(const TbWavenumberNodes *nodes, const TbAirSource *first,
                              const TbAirSource *second, double depth) {
  double sum = 0.0; /* x^2 sin t dt = kappa (x dt) */
  for (uint32_t q = 0; q < nodes->below; q++) {
    sum += nodes->weights[q] * nodes->kappa[q] * drum_integrand(nodes, first, second, depth, q);
  }
  return 0.5 * sum;
}

/* Neither radiates nor is heard nearby. */
static bool is_silent(const TbAirPlan *plan) {
  return plan->degrees == 0 && plan->stretch == 0.0 &&
         (double)plan->order->m > tb_air_heard_to(plan->x, plan->precision.digits);
}

bool tb_air_drum_load(const TbAirOrder *order, TbArena *scratch, const double *upper,
                      const double *lower, double depth, double x, const TbAirPoint *points,
                      uint32_t point_count, double *resistance, double *fields) {
  const uint32_t heads = lower ? 2 : 1;
  TbAirPlan plan = plan_of(order, x, points, point_count, FINE);
  TbAirSource sources[2] = {{.v = upper, .up = 1.0, .baffled = 0.5, .open = 0.5},
                            {.v = lower, .plane = -depth, .up = -1.0, .baffled = 0.5, .open = 0.5}};
  for (uint32_t h = 0; h < heads; h++) widen_reach(order, sources[h].v, &plan);
  tb_air_plan_fields(&plan, sources, heads);
  *resistance = 0.0;
  if (is_silent(&plan)) {
    for (uint32_t i = 0; i < 2 * point_count; i++) fields[i] = 0.0;
    return true;
  }
  const double top = open_top(&plan);
  TbWavenumberNodes nodes;
  Open open;
  if (!nodes_for(&nodes, &plan, scratch, top) ||
      !open_prepare(&open, &plan, scratch, &nodes, top)) {
    return false;
  }
  for (uint32_t h = 0; h < heads; h++) {
    if (!transform(&plan, scratch, &nodes, &sources[h]) ||
        !open_source(&open, &plan, scratch, &nodes, &sources[h])) {
      return false;
    }
  }
  *resistance = drum_resistance(&nodes, &sources[0], lower ? &sources[1] : NULL, depth);
  return point_count == 0 || tb_air_fields(&plan, scratch, &nodes, sources, heads, fields);
}

bool tb_air_half_baffled(const TbAirOrder *order, TbArena *scratch, const double *upper,
                         const double *lower, double depth, double x, const TbAirPoint *points,
                         uint32_t point_count, double *fields) {
  const uint32_t heads = lower ? 2 : 1;
  TbAirPlan plan = plan_of(order, x, points, point_count, FINE);
  TbAirSource sources[2] = {{.v = upper, .up = 1.0, .baffled = 0.5},
                            {.v = lower, .plane = -depth, .up = -1.0, .baffled = 0.5}};
  for (uint32_t h = 0; h < heads; h++) widen_reach(order, sources[h].v, &plan);
  tb_air_plan_fields(&plan, sources, heads);
  for (uint32_t i = 0; i < 2 * point_count; i++) fields[i] = 0.0;
  if (point_count == 0 || is_silent(&plan)) return true;
  TbWavenumberNodes nodes;
  if (!nodes_for(&nodes, &plan, scratch, 0.0)) return false;
  for (uint32_t h = 0; h < heads; h++) {
    if (!transform(&plan, scratch, &nodes, &sources[h])) return false;
  }
  return tb_air_fields(&plan, scratch, &nodes, sources, heads, fields);
}
