/* SPDX-License-Identifier: MIT */
#include "model/lug_matrix.h"

#include <math.h>

#include "bodies/drum/lug_tension.h"
#include "math/bessel.h"
#include "math/portable_math.h"
#include "math/quadrature.h"

static const double PI = 3.14159265358979323846;

/* 48 radii integrate products of shapes with up to 20 nodal circles exactly enough. */
enum { PANELS = 3, RADII = PANELS * TB_PANEL, MOST_ANGLES = 2 * TB_MAX_ORDERS + TABOR_MAX_LUGS };

/* The modes on one head: radial shapes and their slopes, [mode][radius]. */
typedef struct Shapes {
  const TaborModel *model;
  const uint32_t *mode;
  uint32_t count, top_order;
  double radius[RADII], weight[RADII]; /* in units of the head's */
  double *value, *slope;
} Shapes;

static const TbBodyMode *mode_of(const Shapes *shapes, uint32_t i) {
  const TaborModel *model = shapes->model;
  return &model->body.modes[model->modes.row[shapes->mode[i]]];
}

bool tb_lugs_uneven(const TbBody *body) {
  TbLugTension field;
  return tb_lug_tension_prepare(&field, &body->sheet[0], 0.0) ||
         (body->surfaces == 2 && tb_lug_tension_prepare(&field, &body->sheet[1], 0.0));
}

/* J_m(z r) and its slope z J_m'(z r) = (m/r) J_m(z r) - z J_{m+1}(z r) at all radii, added to one
 * mode. */
static void add_bessel(const Shapes *shapes, uint32_t m, double zero, double amplitude,
                       double *value, double *slope) {
  const uint32_t own[8] = {m, m, m, m, m, m, m, m};
  const uint32_t next[8] = {m + 1, m + 1, m + 1, m + 1, m + 1, m + 1, m + 1, m + 1};
  for (uint32_t from = 0; from < RADII; from += 8) {
    double x[8], j[8], above[8];
    for (uint32_t l = 0; l < 8; l++) x[l] = zero * shapes->radius[from + l];
    tb_bessel_j8(own, x, j);
    tb_bessel_j8(next, x, above);
    for (uint32_t l = 0; l < 8; l++) {
      value[from + l] += amplitude * j[l];
      slope[from + l] += amplitude * (m / shapes->radius[from + l] * j[l] - zero * above[l]);
    }
  }
}

/* A part of a mode that is less than this of its largest adds nothing to speak of. */
static const double LEAST_PART = 1e-6;

static void radial_shape(const Shapes *shapes, uint32_t h, uint32_t i, double *value,
                         double *slope) {
  const TbBodyMode *mode = mode_of(shapes, i);
  const TbBodyOrder *order = &shapes->model->body.orders[mode->m];
  const double *v = order->vectors[h] + (size_t)mode->place * order->zero_count;
  double largest = 0.0;
  for (uint32_t k = 0; k < order->zero_count; k++) largest = fmax(largest, fabs(v[k]));
  for (uint32_t k = 0; k < order->zero_count; k++) {
    if (fabs(v[k]) <= LEAST_PART * largest) continue;
    add_bessel(shapes, mode->m, order->zeros[k], v[k], value, slope);
  }
}

/* The radial shapes of all modes on head `h`. */
static bool radial_shapes(Shapes *shapes, TbArena *scratch, uint32_t h) {
  shapes->value = tb_arena_doubles(scratch, (size_t)shapes->count * RADII);
  shapes->slope = tb_arena_doubles(scratch, (size_t)shapes->count * RADII);
  if (scratch->failed) return false;
  for (uint32_t i = 0; i < shapes->count; i++) {
    radial_shape(shapes, h, i, shapes->value + (size_t)i * RADII,
                 shapes->slope + (size_t)i * RADII);
  }
  return true;
}

/* The gradient of every mode at a point, along r and along the angle, and N - T times it. */
typedef struct Point {
  double *along, *across, *pull_along, *pull_across;
} Point;

static void gradients(const Shapes *shapes, uint32_t at, double angle, TbTension n, Point *point) {
  double c[TB_MAX_ORDERS], s[TB_MAX_ORDERS];
  double sin_angle, cos_angle;
  tb_sin_cos(angle, &sin_angle, &cos_angle);
  tb_angular_factors(shapes->top_order + 1, sin_angle, cos_angle, c, s);
  for (uint32_t i = 0; i < shapes->count; i++) {
    const uint32_t m = mode_of(shapes, i)->m;
    const bool sine = shapes->model->modes.sine[shapes->mode[i]];
    const double value = shapes->value[(size_t)i * RADII + at] * m / shapes->radius[at];
    point->along[i] = shapes->slope[(size_t)i * RADII + at] * (sine ? s[m] : c[m]);
    point->across[i] = value * (sine ? c[m] : -s[m]);
    point->pull_along[i] = n.rr * point->along[i] + n.rt * point->across[i];
    point->pull_across[i] = n.rt * point->along[i] + n.tt * point->across[i];
  }
}

static void add_point(uint32_t count, const Point *point, double weight, double *matrix) {
  for (uint32_t i = 0; i < count; i++) {
    const double along = weight * point->pull_along[i], across = weight * point->pull_across[i];
    double *row = matrix + (size_t)i * count;
    for (uint32_t j = 0; j <= i; j++) {
      row[j] += along * point->along[j] + across * point->across[j];
    }
  }
}

static bool add_head(Shapes *shapes, TbArena *scratch, uint32_t h, const TbLugTension *field,
                     double tension, double *matrix) {
  Point point;
  double **arrays[] = {&point.along, &point.across, &point.pull_along, &point.pull_across};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
    *arrays[i] = tb_arena_doubles(scratch, shapes->count);
  }
  if (scratch->failed || !radial_shapes(shapes, scratch, h)) return false;
  /* More angles than the product of two shapes and the field has waves: sums over them are exact.
   */
  const uint32_t angles = 2 * shapes->top_order + field->harmonics;
  for (uint32_t at = 0; at < RADII; at++) {
    for (uint32_t k = 0; k < angles; k++) {
      const double angle = 2.0 * PI * k / angles;
      const TbTension n = tb_lug_tension_at(field, shapes->radius[at], angle);
      gradients(shapes, at, angle, n, &point);
      add_point(shapes->count, &point,
                tension * shapes->weight[at] * shapes->radius[at] * 2.0 * PI / angles, matrix);
    }
  }
  return true;
}

static void mirror(uint32_t n, double *matrix) {
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t j = 0; j < i; j++) matrix[(size_t)j * n + i] = matrix[(size_t)i * n + j];
  }
}

bool tb_lug_matrix(const TaborModel *model, TbArena *scratch, const uint32_t *mode, uint32_t count,
                   double *matrix) {
  const TaborHeadDef *const sheet = model->body.sheet;
  Shapes shapes = {.model = model, .mode = mode, .count = count};
  tb_quadrature(0.0, 1.0, PANELS, shapes.radius, shapes.weight);
  for (uint32_t i = 0; i < count; i++) {
    if (mode_of(&shapes, i)->m > shapes.top_order) shapes.top_order = mode_of(&shapes, i)->m;
  }
  for (uint32_t h = 0; h < model->body.surfaces; h++) {
    TbLugTension field;
    const double turn = model->axis * PI / 180.0;
    if (!tb_lug_tension_prepare(&field, &sheet[h], turn)) continue;
    if (!add_head(&shapes, scratch, h, &field, sheet[h].tension, matrix)) return false;
  }
  mirror(count, matrix);
  return true;
}
