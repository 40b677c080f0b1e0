/* SPDX-License-Identifier: MIT */
#include "air_model/shell_radiation.h"

#include <math.h>

#include "air_model/radiated_field.h"
#include "math/least_squares.h"
#include "math/lu.h"
#include "math/portable_math.h"
#include "math/quadrature.h"

/* ---- the shell ------------------------------------------------------------------------------- */

/* Points inside, as parts of radius and half depth: on no surface where many resonances vanish. */
enum { INNER = 5 };
static const TbCircle INSIDE[INNER] = {
  {0.32, 0.27}, {0.53, 0.61}, {0.71, 0.16}, {0.79, 0.47}, {0.88, 0.73}};

/* With twelve nodes on a cap the loads of low modes are right to 1e-4 up to here. The largest x is
 * lower if a wave has room for many turns along the side, so that the side's nodes stay few. */
static const double TOP = 6.0, MOST_TURNS = 18.0;
enum { CAP = 12, ORDERS = 12 };

/* Below this part of the lowest resonance of the soft cylinder the equations on the surface do
 * alone. */
static const double SAFE = 0.9;

static const double PI = 3.14159265358979323846;

bool tb_shell_prepare(TbShellMesh *mesh, TbArena *arena, double depth, const TbAirPoint *points,
                      uint32_t point_count) {
  const double half = 0.5 * depth, top = fmin(TOP, MOST_TURNS / half);
  const TbShellSize size = {.half = half,
                            .top = top,
                            .cap = CAP,
                            .side = 6u + (uint32_t)(0.6 * half * top),
                            .orders = ORDERS};
  TbCircle inner[INNER], outer[TB_SHELL_POINTS];
  for (uint32_t p = 0; p < INNER; p++) inner[p] = (TbCircle){INSIDE[p].r, half * INSIDE[p].z};
  for (uint32_t p = 0; p < point_count; p++) {
    outer[p] = (TbCircle){points[p].radius, points[p].height + half};
  }
  return tb_shell_mesh_prepare(mesh, arena, size, inner, INNER, outer, point_count);
}

/* ---- one order ------------------------------------------------------------------------------- */

/* Int (polynomial of j) J_m(z_i r) r dr, r = g(t). */
static bool prepare_moments(TbShellOrder *order, TbArena *scratch) {
  enum { PANELS = 6, POINTS = PANELS * TB_PANEL };
  const TbShellMesh *mesh = order->mesh;
  const TbAirOrder *air = order->air;
  double t[POINTS], weights[POINTS], r[POINTS], j[POINTS];
  double *basis = tb_arena_doubles(scratch, (size_t)POINTS * mesh->cap);
  if (!basis) return false;
  tb_quadrature(0.0, 1.0, PANELS, t, weights);
  for (uint32_t q = 0; q < POINTS; q++) {
    r[q] = tb_shell_grade(t[q]);
    weights[q] *= tb_shell_grade_slope(t[q]) * r[q];
    tb_shell_basis(mesh->parameters, mesh->cap, air->m % 2, t[q], basis + (size_t)q * mesh->cap);
  }
  for (uint32_t i = 0; i < air->count; i++) {
    double *row = order->moments + (size_t)i * mesh->cap;
    tb_bessel_table_values(air->table, air->m, POINTS, air->zeros[i], r, j);
    for (uint32_t q = 0; q < POINTS; q++) {
      const double *values = basis + (size_t)q * mesh->cap;
      for (uint32_t n = 0; n < mesh->cap; n++) row[n] += weights[q] * j[q] * values[n];
    }
  }
  return true;
}

static const TbShellRow *row_of(const TbShellMesh *mesh, const TbShellRow *rows, uint32_t target,
                                uint32_t odd) {
  return rows + ((size_t)target * 2 + odd) * mesh->nodes;
}

/* I at the cap's nodes for a unit w at each of them, x -> 0, where everything is real. */
static bool prepare_still(TbShellOrder *order, TbArena *scratch, const TbShellRow *rows,
                          uint32_t odd) {
  const TbShellMesh *mesh = order->mesh;
  const uint32_t n = mesh->nodes, cap = mesh->cap;
  double *matrix = tb_arena_doubles(scratch, (size_t)n * n);
  double *sides = tb_arena_doubles(scratch, (size_t)cap * n);
  double *solution = tb_arena_doubles(scratch, (size_t)cap * n);
  if (scratch->failed) return false;
  for (uint32_t t = 0; t < n; t++) {
    const TbShellRow *row = row_of(mesh, rows, t, odd);
    for (uint32_t j = 0; j < n; j++) matrix[t * n + j] = (t == j ? 0.5 : 0.0) - row[j].dipole[0];
    for (uint32_t j = 0; j < cap; j++) sides[j * n + t] = row[j].single[0];
  }
  if (!tb_least_squares(scratch, n, n, matrix, cap, sides, solution)) return false;
  for (uint32_t t = 0; t < cap; t++) {
    for (uint32_t j = 0; j < cap; j++) order->still[odd][t * cap + j] = solution[j * n + t];
  }
  return true;
}

bool tb_shell_order_prepare(TbShellOrder *order, TbArena *arena, const TbShellMesh *mesh,
                            const TbAirOrder *air) {
  const size_t count = air->count, cap = mesh->cap;
  *order = (TbShellOrder){.mesh = mesh, .air = air};
  order->moments = tb_arena_doubles(arena, count * cap);
  order->baffled = tb_arena_doubles(arena, count * count);
  for (int odd = 0; odd < 2; odd++) order->still[odd] = tb_arena_doubles(arena, cap * cap);
  if (arena->failed) return false;
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  TbShellRow *rows = tb_arena_take(&scratch, (size_t)mesh->solved * 2 * mesh->nodes, sizeof *rows);
  bool done = rows != NULL;
  if (done) tb_shell_rows(mesh, air->m, 0.0, rows);
  done = done && tb_air_mass_baffled(air, &scratch, order->baffled) &&
         prepare_moments(order, &scratch) && prepare_still(order, &scratch, rows, 0) &&
         prepare_still(order, &scratch, rows, 1);
  tb_arena_release(&scratch);
  return done;
}

/* Int w_j r dr over the cap, by the rule. */
static double area(const TbShellMesh *mesh, uint32_t node) {
  return mesh->circles[node].r * mesh->weights[node];
}

/* [cap][cap]: what a finite shell and the other head add, at low frequency, to I of a baffled head,
 * which is twice its single layer; even and odd motions. */
static void still_changes(const TbShellOrder *order, const TbShellRow *rows, uint32_t odd,
                          double *changes) {
  const TbShellMesh *mesh = order->mesh;
  for (uint32_t t = 0; t < mesh->cap; t++) {
    const TbShellRow *even_row = row_of(mesh, rows, t, 0), *odd_row = row_of(mesh, rows, t, 1);
    for (uint32_t j = 0; j < mesh->cap; j++) {
      const double own =
        even_row[j].single[0] + odd_row[j].single[0]; /* the mirror image cancels */
      changes[t * mesh->cap + j] = order->still[odd][t * mesh->cap + j] - own;
    }
  }
}

/* result[i][k] += factor moments_i.changes.(projection of k), made symmetric. */
static void add_changes(const TbShellOrder *order, const double *changes, double factor,
                        double *result) {
  const TbShellMesh *mesh = order->mesh;
  const uint32_t cap = mesh->cap, count = order->air->count;
  for (uint32_t k = 0; k < count; k++) {
    double pressure[TB_SHELL_NODES] = {0.0};
    for (uint32_t j = 0; j < cap; j++) {
      const double w = order->moments[(size_t)k * cap + j] / area(mesh, j);
      for (uint32_t t = 0; t < cap; t++) pressure[t] += changes[t * cap + j] * w;
    }
    for (uint32_t i = 0; i < count; i++) {
      double sum = 0.0;
      for (uint32_t t = 0; t < cap; t++) sum += order->moments[(size_t)i * cap + t] * pressure[t];
      result[(size_t)i * count + k] += 0.5 * factor * sum;
      result[(size_t)k * count + i] += 0.5 * factor * sum;
    }
  }
}

bool tb_shell_order_mass(const TbShellOrder *order, TbArena *scratch, double *own, double *mutual) {
  const TbShellMesh *mesh = order->mesh;
  const uint32_t size = order->air->count * order->air->count;
  TbShellRow *rows = tb_arena_take(scratch, (size_t)mesh->solved * 2 * mesh->nodes, sizeof *rows);
  double *changes = tb_arena_doubles(scratch, (size_t)mesh->cap * mesh->cap);
  if (scratch->failed) return false;
  tb_shell_rows(mesh, order->air->m, 0.0, rows);
  for (uint32_t i = 0; i < size; i++) {
    own[i] = order->baffled[i];
    mutual[i] = 0.0;
  }
  for (uint32_t odd = 0; odd < 2; odd++) {
    still_changes(order, rows, odd, changes);
    add_changes(order, changes, 0.5, own);
    add_changes(order, changes, odd ? -0.5 : 0.5, mutual);
  }
  return true;
}

/* ---- one motion ------------------------------------------------------------------------------ */

/* w at the cap's nodes: the part of one symmetry. */
static void project(const TbShellMotion *motion, uint32_t odd) {
  const TbShellOrder *order = motion->order;
  const uint32_t cap = order->mesh->cap;
  for (uint32_t i = 0; i < order->air->count; i++) {
    const double other = motion->lower ? motion->lower[i] : 0.0;
    const double v = 0.5 * (motion->upper[i] + (odd ? -other : other));
    for (uint32_t j = 0; j < cap; j++) {
      motion->w[odd][j] += v * order->moments[(size_t)i * cap + j] / area(order->mesh, j);
    }
  }
}

static void right_sides(const TbShellMotion *motion, const TbShellRow *rows, uint32_t odd,
                        uint32_t count, double *sides) {
  const TbShellMesh *mesh = motion->order->mesh;
  for (uint32_t t = 0; t < count; t++) {
    const TbShellRow *row = row_of(mesh, rows, t, odd);
    for (uint32_t j = 0; j < mesh->cap; j++) {
      sides[2 * t] += row[j].single[0] * motion->w[odd][j];
      sides[2 * t + 1] += row[j].single[1] * motion->w[odd][j];
    }
  }
}

/* Equations as they are, for as many nodes. */
static bool solve_square(const TbShellMotion *motion, TbArena *scratch, const TbShellRow *rows,
                         uint32_t odd, double *pressure) {
  const TbShellMesh *mesh = motion->order->mesh;
  const uint32_t n = mesh->nodes;
  double *matrix = tb_arena_doubles(scratch, 2 * (size_t)n * n);
  if (!matrix) return false;
  for (uint32_t t = 0; t < n; t++) {
    const TbShellRow *row = row_of(mesh, rows, t, odd);
    double *out = matrix + 2 * (size_t)t * n;
    for (uint32_t j = 0; j < n; j++) {
      out[2 * j] = (t == j ? 0.5 : 0.0) - row[j].dipole[0];
      out[2 * j + 1] = -row[j].dipole[1];
    }
  }
  right_sides(motion, rows, odd, n, pressure);
  return tb_solve_complex(n, matrix, pressure);
}

/* Equations of the points inside too: as real ones for (re, im) of I. */
static bool solve_overdetermined(const TbShellMotion *motion, TbArena *scratch,
                                 const TbShellRow *rows, uint32_t odd, double *pressure) {
  const TbShellMesh *mesh = motion->order->mesh;
  const uint32_t n = mesh->nodes;
  double *matrix = tb_arena_doubles(scratch, 4 * (size_t)mesh->solved * n);
  double *sides = tb_arena_doubles(scratch, 2 * (size_t)mesh->solved);
  if (scratch->failed) return false;
  for (uint32_t t = 0; t < mesh->solved; t++) {
    const TbShellRow *row = row_of(mesh, rows, t, odd);
    double *re = matrix + (size_t)(2 * t) * 2 * n, *im = re + 2 * n;
    for (uint32_t j = 0; j < n; j++) {
      re[2 * j] = im[2 * j + 1] = (t == j ? 0.5 : 0.0) - row[j].dipole[0];
      re[2 * j + 1] = row[j].dipole[1];
      im[2 * j] = -row[j].dipole[1];
    }
  }
  right_sides(motion, rows, odd, mesh->solved, sides);
  return tb_least_squares(scratch, 2 * mesh->solved, 2 * n, matrix, 1, sides, pressure);
}

/* True near the lowest resonance of the soft cylinder, and above. */
static bool may_resonate(const TbShellOrder *order, double x) {
  const double across = order->air->zeros[0], along = 0.5 * PI / order->mesh->half;
  return x > SAFE * tb_hypot(across, along);
}

/* Adds what one symmetry's pressure, less that at low frequency, does to both heads. */
static void add_load(TbShellMotion *motion, uint32_t odd) {
  const TbShellOrder *order = motion->order;
  const uint32_t cap = order->mesh->cap, count = order->air->count;
  double change[TB_SHELL_NODES], lost = 0.0;
  for (uint32_t t = 0; t < cap; t++) {
    change[t] = motion->pressure[odd][2 * t];
    for (uint32_t j = 0; j < cap; j++)
      change[t] -= order->still[odd][t * cap + j] * motion->w[odd][j];
    lost += area(order->mesh, t) * motion->w[odd][t] * motion->pressure[odd][2 * t + 1];
  }
  motion->resistance -= 2.0 * motion->x * lost;
  for (uint32_t i = 0; i < count; i++) {
    double sum = 0.0;
    for (uint32_t t = 0; t < cap; t++) sum += order->moments[(size_t)i * cap + t] * change[t];
    motion->inertia[i] += sum;
    if (motion->lower) motion->inertia[count + i] += odd ? -sum : sum;
  }
}

static bool solve_symmetry(TbShellMotion *motion, TbArena *scratch, const TbShellRow *rows,
                           uint32_t odd) {
  const TbShellMesh *mesh = motion->order->mesh;
  motion->w[odd] = tb_arena_doubles(scratch, mesh->cap);
  motion->pressure[odd] = tb_arena_doubles(scratch, 2 * (size_t)mesh->nodes);
  if (scratch->failed) return false;
  project(motion, odd);
  const bool done = may_resonate(motion->order, motion->x)
                      ? solve_overdetermined(motion, scratch, rows, odd, motion->pressure[odd])
                      : solve_square(motion, scratch, rows, odd, motion->pressure[odd]);
  if (done) add_load(motion, odd);
  return done;
}

bool tb_shell_solve(TbShellMotion *motion, TbArena *scratch, const TbShellOrder *order,
                    const double *upper, const double *lower, double x) {
  const TbShellMesh *mesh = order->mesh;
  *motion = (TbShellMotion){.order = order, .x = x, .upper = upper, .lower = lower};
  motion->inertia = tb_arena_doubles(scratch, 2 * (size_t)order->air->count);
  TbShellRow *rows = tb_arena_take(scratch, (size_t)mesh->solved * 2 * mesh->nodes, sizeof *rows);
  if (scratch->failed) return false;
  tb_shell_rows(mesh, order->air->m, x, rows);
  return solve_symmetry(motion, scratch, rows, 0) && solve_symmetry(motion, scratch, rows, 1);
}

/* ---- fields ---------------------------------------------------------------------------------- */

/* The double layer of I at a point outside. */
static void add_reflection(const TbShellMotion *motion, const TbShellRow *rows, double field[2]) {
  const uint32_t n = motion->order->mesh->nodes;
  for (uint32_t odd = 0; odd < 2; odd++) {
    const double *pressure = motion->pressure[odd];
    for (uint32_t j = 0; j < n; j++) {
      const double *d = rows[odd * n + j].dipole;
      field[0] += d[0] * pressure[2 * j] - d[1] * pressure[2 * j + 1];
      field[1] += d[0] * pressure[2 * j + 1] + d[1] * pressure[2 * j];
    }
  }
}

bool tb_shell_fields(const TbShellMotion *motion, TbArena *scratch, const TbAirPoint *points,
                     uint32_t point_count, double *fields) {
  const TbShellMesh *mesh = motion->order->mesh;
  TbShellRow *rows = tb_arena_take(scratch, 2 * (size_t)mesh->nodes, sizeof *rows);
  if (!rows || !tb_air_half_baffled(motion->order->air, scratch, motion->upper, motion->lower,
                                    2.0 * mesh->half, motion->x, points, point_count, fields)) {
    return false;
  }
  for (uint32_t p = 0; p < point_count; p++) {
    tb_shell_target_rows(mesh, motion->order->air->m, mesh->solved + p, motion->x, rows);
    add_reflection(motion, rows, fields + 2 * p);
  }
  return true;
}
