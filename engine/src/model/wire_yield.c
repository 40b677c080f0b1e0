/* SPDX-License-Identifier: MIT */
#include "model/wire_yield.h"

#include <math.h>
#include <string.h>

#include "bodies/sheet_waves.h"
#include "math/bessel.h"
#include "math/bessel_table.h"
#include "math/eigen.h"
#include "math/portable_math.h"
#include "model/model.h"

static const double PI = 3.14159265358979323846;

/* No oscillator is faster than this part of the rate. */
static const double FASTEST = 0.35;

/* Addition to the diagonals of A and B, relative to the largest of A: A then has an inverse even if
 * no mode moves some shapes of the grid. */
static const double FLOOR = 1e-6;

/* Least ratio of the top to the two-way bandwidth. */
static const double LEAST_RATIO = 1.2;

enum { MOST_ZEROS = 96 };

/* The contact points of a quarter of the bed, or of as much as has no mirror image. */
typedef struct Places {
  uint32_t count, *row; /* count is a multiple of 8 */
  double *radius;       /* over the head's */
  double *cosine, *sine;
  double *c[2], *s[2]; /* cos and sin of m theta, and of (m - 1) theta */
  double *bessel;
} Places;

typedef struct Builder {
  const TaborHeadDef *material;
  const TaborAirDef *air;
  double radius;
  const TbWires *wires;
  const TbProjection *projection;
  const TbKernels *kernels;
  Places places;
  TbBesselTable table;
  double bottom, top;                      /* [rad/s] */
  double *norm;                            /* [grid] diagonal of contract after expand */
  double *shape, *grid, *fold;             /* of one mode: [stride], [grid] */
  double *inverse_mass[4], *compliance[4]; /* A and B of each class */
} Builder;

/* ---- places ---------------------------------------------------------------------------------- */

static bool is_image(const TbWires *wires, uint32_t row) {
  return (wires->mirrored && row % wires->lanes > wires->middle) ||
         (wires->balanced && row / wires->lanes > (wires->count - 1u) / 2u);
}

static bool prepare_places(Builder *b, TbArena *scratch) {
  const TbWires *wires = b->wires;
  Places *p = &b->places;
  p->row = tb_arena_take(scratch, wires->stride + 8u, sizeof *p->row);
  double **arrays[] = {&p->radius, &p->cosine, &p->sine, &p->c[0],
                       &p->c[1],   &p->s[0],   &p->s[1], &p->bessel};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
    *arrays[i] = tb_arena_doubles(scratch, wires->stride + 8u);
  }
  if (scratch->failed) return false;
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0 || is_image(wires, row)) continue;
    const double x = wires->row_x[row], y = wires->row_y[row], r = sqrt(x * x + y * y);
    const uint32_t i = p->count++;
    p->row[i] = row;
    p->radius[i] = r / b->radius;
    p->cosine[i] = r > 0.0 ? x / r : 1.0;
    p->sine[i] = r > 0.0 ? y / r : 0.0;
  }
  for (; p->count % 8u; p->count++) p->row[p->count] = TB_NO_MODE;
  return true;
}

/* Goes on to the angular functions of order m. */
static void turn_places(Places *p, uint32_t m) {
  for (uint32_t i = 0; i < p->count; i++) {
    const double c = p->cosine[i], s = p->sine[i];
    const double c0 = p->c[0][i], s0 = p->s[0][i];
    p->c[0][i] = m == 0 ? 1.0 : (m == 1 ? c : 2.0 * c * c0 - p->c[1][i]);
    p->s[0][i] = m == 0 ? 0.0 : (m == 1 ? s : 2.0 * c * s0 - p->s[1][i]);
    p->c[1][i] = c0;
    p->s[1][i] = s0;
  }
}

/* ---- one mode -------------------------------------------------------------------------------- */

/* Values of J_m at all places, and at their mirror images. */
static void fill_shape(const Builder *b, uint32_t m, bool sine, double scale) {
  const TbWires *wires = b->wires;
  const Places *p = &b->places;
  const double *angular = sine ? p->s[0] : p->c[0];
  const double along = (m % 2 == 0) == sine ? -1.0 : 1.0, across = sine ? -1.0 : 1.0;
  for (uint32_t i = 0; i < p->count; i++) {
    const uint32_t row = p->row[i];
    if (row == TB_NO_MODE) continue;
    const double value = scale * p->bessel[i] * angular[i];
    const uint32_t lane = row % wires->lanes, wire = row / wires->lanes;
    b->shape[row] = value;
    if (wires->mirrored) b->shape[wire * wires->lanes + 2u * wires->middle - lane] = along * value;
    if (!wires->balanced) continue;
    const uint32_t image = (wires->count - 1u - wire) * wires->lanes;
    b->shape[image + lane] = across * value;
    if (wires->mirrored) b->shape[image + 2u * wires->middle - lane] = along * across * value;
  }
}

static uint32_t class_of(const TbWireGrid *grid, uint32_t m, bool sine) {
  const uint32_t along = grid->halves == 2 && (m % 2 == 0) == sine;
  return tb_wire_grid_class(grid, along, grid->quarters == 2 && sine);
}

static void add_outer(uint32_t n, const double *c, double part, double *matrix) {
  for (uint32_t i = 0; i < n; i++) {
    const double x = part * c[i];
    for (uint32_t j = 0; j <= i; j++) matrix[(size_t)i * n + j] += x * c[j];
  }
}

static void add_mode(const Builder *b, uint32_t m, bool sine, double omega, double scale) {
  const TbWireGrid *grid = &b->projection->wire_grid;
  const uint32_t g = class_of(grid, m, sine), first = grid->first[g];
  const uint32_t n = b->projection->group[g].used;
  fill_shape(b, m, sine, scale);
  b->kernels->rows_to_grid(grid, b->shape, b->fold, b->grid);
  double *c = b->grid + first;
  for (uint32_t i = 0; i < n; i++) {
    c[i] = b->norm[first + i] > 0.0 ? c[i] / b->norm[first + i] : 0.0;
  }
  add_outer(n, c, 1.0, b->inverse_mass[g]);
  add_outer(n, c, 1.0 / (omega * omega), b->compliance[g]);
}

static void add_zero(Builder *b, uint32_t m, double zero) {
  Places *p = &b->places;
  double mass;
  const double omega = tb_sheet_wave_frequency(b->material, b->air, zero / b->radius, &mass);
  if (omega < b->bottom || omega >= b->top) return;
  const double slope = tb_bessel_j(m + 1, zero), radius = b->radius;
  const double norm = (m ? PI : 2.0 * PI) * radius * radius * 0.5 * slope * slope;
  tb_bessel_table_values(&b->table, m, p->count, zero, p->radius, p->bessel);
  for (uint32_t copy = 0; copy < (m ? 2u : 1u); copy++) {
    add_mode(b, m, copy == 1, omega, 1.0 / sqrt(mass * norm));
  }
}

static double top_zero(const Builder *b) {
  return fmin(TB_TOP_ZERO, b->radius * tb_sheet_wave_number(b->material, b->air, b->top));
}

static bool add_all(Builder *b, TbArena *watched) {
  const double top = top_zero(b);
  for (uint32_t m = 0; (double)m < top; m++) {
    double zeros[MOST_ZEROS];
    const uint32_t count = tb_bessel_zeros(m, top, zeros, MOST_ZEROS);
    if (count == 0) break;
    if (!tb_arena_go_on_at(watched, (double)m / top)) return false;
    turn_places(&b->places, m);
    for (uint32_t i = 0; i < count && tb_arena_go_on(watched); i++) add_zero(b, m, zeros[i]);
  }
  return !watched->failed;
}

/* ---- what stands for them -------------------------------------------------------------------- */

/* How far a grid point's unit motion comes back through the wires' points. */
static bool find_norms(Builder *b, TbArena *watched) {
  const TbWireGrid *grid = &b->projection->wire_grid;
  for (uint32_t g = 0; g < b->projection->groups; g++) {
    for (uint32_t i = 0; i < b->projection->group[g].used; i++) {
      if (!tb_arena_go_on(watched)) return false;
      memset(b->grid, 0, grid->size * sizeof *b->grid);
      b->grid[grid->first[g] + i] = 1.0;
      b->kernels->grid_to_rows(grid, b->grid, b->fold, b->shape);
      b->kernels->rows_to_grid(grid, b->shape, b->fold, b->grid);
      b->norm[grid->first[g] + i] = b->grid[grid->first[g] + i];
    }
  }
  memset(b->shape, 0, b->wires->stride * sizeof *b->shape);
  return true;
}

static bool allocate(Builder *b, TbArena *scratch) {
  const TbWireGrid *grid = &b->projection->wire_grid;
  b->norm = tb_arena_doubles(scratch, grid->size);
  b->grid = tb_arena_doubles(scratch, grid->size);
  b->shape = tb_arena_doubles(scratch, b->wires->stride);
  b->fold = tb_arena_doubles(scratch, tb_wire_grid_scratch(grid));
  for (uint32_t g = 0; g < b->projection->groups; g++) {
    const size_t n = b->projection->group[g].used;
    b->inverse_mass[g] = tb_arena_doubles(scratch, n * n);
    b->compliance[g] = tb_arena_doubles(scratch, n * n);
  }
  const double top = top_zero(b);
  return tb_bessel_table_prepare(&b->table, scratch, (uint32_t)top + 1u, top) && !scratch->failed;
}

/* Fills the other half of both, and gives them a floor. */
static void complete(uint32_t n, double omega, double *a, double *b) {
  double most = 0.0;
  for (uint32_t i = 0; i < n; i++) most = fmax(most, a[(size_t)i * n + i]);
  for (uint32_t i = 0; i < n; i++) {
    a[(size_t)i * n + i] += FLOOR * most;
    b[(size_t)i * n + i] += FLOOR * most / (omega * omega);
    for (uint32_t j = 0; j < i; j++) {
      a[(size_t)j * n + i] = a[(size_t)i * n + j];
      b[(size_t)j * n + i] = b[(size_t)i * n + j];
    }
  }
}

/* Shapes and frequencies from A and B. Returns false if memory ran out or there is no solution. */
static bool reduce(const Builder *b, TbArena *scratch, uint32_t g, double *omega, double *shapes) {
  const uint32_t n = b->projection->group[g].used, points = b->projection->group[g].points;
  double *mass = tb_arena_doubles(scratch, (size_t)n * n);
  double *lambda = tb_arena_doubles(scratch, n);
  double *vectors = tb_arena_doubles(scratch, (size_t)n * n);
  if (scratch->failed) return false;
  double *a = b->inverse_mass[g];
  complete(n, sqrt(b->bottom * b->top), a, b->compliance[g]);
  memcpy(mass, a, (size_t)n * n * sizeof *mass);
  if (!tb_eigen_symmetric(scratch, n, b->compliance[g], mass, lambda, vectors)) return false;
  for (uint32_t k = 0; k < n && tb_arena_go_on(scratch); k++) {
    omega[k] = fmin(b->top, fmax(b->bottom, 1.0 / sqrt(lambda[k])));
    for (uint32_t i = 0; i < n; i++) {
      double sum = 0.0;
      for (uint32_t j = 0; j < n; j++) sum += a[(size_t)i * n + j] * vectors[(size_t)k * n + j];
      shapes[(size_t)k * points + i] = sum;
    }
  }
  return !scratch->failed;
}

static bool reduce_class(const Builder *b, TbArena *arena, TbArena *scratch, uint32_t g,
                         TbWireYield *to) {
  const TbProjectionGroup *group = &b->projection->group[g];
  to->count[g] = tb_pad(group->used);
  to->omega[g] = tb_arena_doubles(arena, to->count[g]);
  to->shape[g] = tb_arena_doubles(arena, (size_t)to->count[g] * group->points);
  return !arena->failed && reduce(b, scratch, g, to->omega[g], to->shape[g]);
}

bool tb_wire_yields(const TaborModel *model) {
  return model->wires.count > 0 && model->top > LEAST_RATIO * model->body.bandwidth;
}

TaborStatus tb_wire_yield_prepare(TbWireYield *yield, TbArena *arena, const TaborModel *model,
                                  const TbProjection *projection) {
  const TaborDrumDef *def = &model->def;
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  Builder b = {.material = &model->body.sheet[model->wires.head],
               .air = &def->air,
               .radius = model->body.radius,
               .wires = &model->wires,
               .projection = projection,
               .kernels = model->kernels,
               .bottom = 2.0 * PI * model->body.bandwidth,
               .top = 2.0 * PI * model->top};
  *yield = (TbWireYield){.decay_rate = def->quality.losses ? 0.5 * (b.top - b.bottom) : 0.0};
  bool done = prepare_places(&b, &scratch) && allocate(&b, &scratch) && find_norms(&b, &scratch) &&
              add_all(&b, &scratch);
  for (uint32_t g = 0; done && g < projection->groups; g++) {
    done = reduce_class(&b, arena, &scratch, g, yield);
  }
  const bool starved = arena->failed || scratch.failed;
  tb_arena_release(&scratch);
  if (done) return TABOR_OK;
  return starved ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
}

/* ---- in the model ---------------------------------------------------------------------------- */

/* Mode k of a class, which is mode i of its group. */
static void apply_shape(const double *shape, double gain, TbProjectionGroup *group, uint32_t i) {
  for (uint32_t p = 0; p < group->used; p++) {
    group->gather[((size_t)(p / 8) * group->modes + i) * 8 + p % 8] = gain * shape[p];
    group->scatter[((size_t)(i / 8) * group->points + p) * 8 + i % 8] = gain * shape[p];
  }
}

void tb_wire_yield_apply(const TbWireYield *yield, TbModes *modes, TbProjection *projection,
                         double side, double time_step) {
  const double fastest = 2.0 * PI * FASTEST / time_step;
  for (uint32_t g = 0; g < modes->groups; g++) {
    TbProjectionGroup *group = &projection->group[g];
    const uint32_t from = group->modes - yield->count[g];
    for (uint32_t k = 0; k < yield->count[g]; k++) {
      if (yield->omega[g][k] == 0.0) continue;
      const uint32_t at = group->first + from + k;
      const double omega = fmin(yield->omega[g][k], fastest), turn = omega * time_step;
      const TbPole pole = tb_pole(omega, yield->decay_rate, time_step);
      modes->a[at] = pole.a;
      modes->b[at] = pole.b;
      modes->g[at] = pole.g;
      modes->pull[at] = -side * pole.g;
      modes->stiffness[at] = pole.stiffness;
      modes->loss_head[at] = pole.loss;
      /* The recursion answers a force too strongly by turn/sin(turn). */
      apply_shape(yield->shape[g] + (size_t)k * group->points, sqrt(tb_sin(turn) / turn), group,
                  from + k);
    }
  }
}
