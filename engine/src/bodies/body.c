/* SPDX-License-Identifier: MIT */
#include "bodies/body.h"

#include <math.h>
#include <stdlib.h>

#include "bodies/sheet_waves.h"
#include "math/bessel.h"

static const double PI = 3.14159265358979323846;

/* Most of the air's integrals end at this many times the basis' highest zero. */
static const double AIR_REACH = 4.0;

static int compare_modes(const void *a, const void *b) {
  const TbBodyMode *x = a, *y = b;
  if (x->omega != y->omega) return x->omega < y->omega ? -1 : 1;
  return x->m < y->m ? -1 : (x->m > y->m ? 1 : (x->index < y->index ? -1 : x->index > y->index));
}

/* Sorts the modes of all orders by frequency and tells each order where its own went. */
static void sort_modes(TbBody *body) {
  qsort(body->modes, body->row_count, sizeof *body->modes, compare_modes);
  for (uint32_t row = 0; row < body->row_count; row++) {
    const TbBodyMode *mode = &body->modes[row];
    body->orders[mode->m].rows[mode->place] = row;
  }
}

static TaborStatus build_order(TbBody *body, TbArena *arena, const TbBesselTable *table,
                               TbBuildOrder *build, const void *context, TbBodyOrder *order) {
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  TbBodyMode *modes = body->modes + body->row_count;
  const uint32_t room = body->most_modes - body->row_count;
  TbAirOrder air;
  TaborStatus status = TABOR_ERROR_MEMORY;
  if (tb_air_order_prepare(&air, &scratch, order->m, order->zeros, order->zero_count)) {
    air.table = table;
    status = build(context, arena, &scratch, &air, order, modes, room);
  }
  order->rows = tb_arena_take(arena, order->mode_count + 1u, sizeof *order->rows);
  if (arena->failed) status = TABOR_ERROR_MEMORY;
  body->row_count += order->mode_count;
  tb_arena_release(&scratch);
  return status;
}

static TaborStatus build_orders(TbBody *body, TbArena *arena, const TbBesselTable *table,
                                double basis_top, uint32_t most, TbBuildOrder *build,
                                const void *context) {
  const uint32_t room = (uint32_t)(0.5 * basis_top) + 2u;
  for (uint32_t m = 0; m < most; m++) {
    if (!tb_arena_go_on_at(arena, (double)m / most)) return TABOR_ERROR_MEMORY;
    TbBodyOrder *order = &body->orders[m];
    order->m = m;
    order->first_zero = body->zero_count;
    order->zeros = tb_arena_doubles(arena, room);
    if (arena->failed) return TABOR_ERROR_MEMORY;
    order->zero_count = tb_bessel_zeros(m, basis_top, order->zeros, room);
    if (order->zero_count == 0) break;
    const TaborStatus status = build_order(body, arena, table, build, context, order);
    if (status != TABOR_OK) return status;
    body->zero_count += order->zero_count;
    body->order_count++;
  }
  return TABOR_OK;
}

TaborStatus tb_body_build_orders(TbBody *body, TbArena *arena, double basis_top, uint32_t orders,
                                 TbBuildOrder *build, const void *context) {
  body->orders = tb_arena_take(arena, orders, sizeof *body->orders);
  body->modes = tb_arena_take(arena, body->most_modes, sizeof *body->modes);
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  TbBesselTable table;
  TaborStatus status = TABOR_ERROR_MEMORY;
  if (tb_bessel_table_prepare(&table, &scratch, orders, AIR_REACH * basis_top) && !arena->failed) {
    status = build_orders(body, arena, &table, basis_top, orders, build, context);
  }
  tb_arena_release(&scratch);
  if (status == TABOR_OK) sort_modes(body);
  return status;
}

double tb_body_wave_zero(const TaborHeadDef *sheet, const TaborAirDef *air, double radius,
                         double frequency) {
  return fmin(TB_TOP_ZERO, radius * tb_sheet_wave_number(sheet, air, 2.0 * PI * frequency));
}

double tb_body_lowest(const TbBody *body) {
  uint32_t row = 0;
  while (row + 1u < body->row_count && body->modes[row].part == TABOR_PART_RIM) row++;
  return body->modes[row].omega;
}

TaborModeInfo tb_body_mode_info(const TbBodyMode *mode) {
  return (TaborModeInfo){.m = mode->m,
                         .n = mode->n,
                         .frequency = mode->omega / (2.0 * PI),
                         .decay_rate = mode->decay_rate,
                         .radiation_rate = mode->radiation_rate,
                         .part = (TaborModePart)mode->part,
                         .phase = mode->phase,
                         .multiplicity = mode->m ? 2 : 1};
}

/* Bessel amplitudes of a mode on a surface. */
static const double *amplitudes(const TbBodyOrder *order, uint32_t which, const TbBodyMode *mode) {
  return order->vectors[which] + (size_t)mode->place * order->zero_count;
}

static double edge_motion(const TbBodyOrder *order, uint32_t which, const TbBodyMode *mode) {
  return order->edge[which] ? order->edge[which][mode->place] : 0.0;
}

double tb_body_slope_square(const TbBody *body, uint32_t which, const TbBodyMode *mode) {
  const TbBodyOrder *order = &body->orders[mode->m];
  const double *v = amplitudes(order, which, mode);
  const double azimuth = mode->m ? PI : 2.0 * PI;
  double sum = 0.0;
  for (uint32_t i = 0; i < order->zero_count; i++) {
    const double slope = order->zeros[i] * tb_bessel_j(mode->m + 1, order->zeros[i]);
    sum += v[i] * v[i] * slope * slope;
  }
  const double edge = edge_motion(order, which, mode);
  return 0.5 * azimuth * sum + azimuth * mode->m * edge * edge;
}

double tb_body_shape(const TbBody *body, uint32_t which, const TbBodyMode *mode, double r) {
  const TbBodyOrder *order = &body->orders[mode->m];
  const double *v = amplitudes(order, which, mode), part = r / body->radius;
  double sum = 0.0, edge = edge_motion(order, which, mode);
  for (uint32_t i = 0; i < order->zero_count; i++)
    sum += v[i] * tb_bessel_j(mode->m, order->zeros[i] * part);
  for (uint32_t i = 0; i < mode->m; i++) edge *= part;
  return sum + edge;
}

double tb_body_volume(const TbBody *body, uint32_t which, const TbBodyMode *mode) {
  if (mode->m > 0) return 0.0;
  const TbBodyOrder *order = &body->orders[0];
  const double *v = amplitudes(order, which, mode);
  double sum = edge_motion(order, which, mode);
  for (uint32_t i = 0; i < order->zero_count; i++)
    sum += 2.0 * v[i] * tb_bessel_j(1, order->zeros[i]) / order->zeros[i];
  return PI * body->radius * body->radius * sum;
}

void tb_body_patch(const TbBody *body, double patch_radius, double *patch) {
  uint32_t index = 0;
  for (uint32_t m = 0; m < body->order_count; m++) {
    const TbBodyOrder *order = &body->orders[m];
    for (uint32_t i = 0; i < order->zero_count; i++, index++) {
      const double ka = order->zeros[i] * patch_radius / body->radius;
      patch[index] = ka > 1e-6 ? 2.0 * tb_bessel_j(1, ka) / ka : 1.0;
    }
  }
}

/* Values of all Bessel functions of one order at r, eight at a time. */
static void order_values(const TbBodyOrder *order, double r, const double *patch, double *values) {
  const uint32_t m = order->m;
  const uint32_t orders[8] = {m, m, m, m, m, m, m, m};
  for (uint32_t i = 0; i < order->zero_count; i += 8) {
    double argument[8], j[8];
    for (uint32_t l = 0; l < 8; l++) {
      argument[l] = i + l < order->zero_count ? order->zeros[i + l] * r : 0.0;
    }
    tb_bessel_j8(orders, argument, j);
    for (uint32_t l = 0; l < 8 && i + l < order->zero_count; l++) {
      values[i + l] = patch ? j[l] * patch[i + l] : j[l];
    }
  }
}

/* Sums the Bessel functions of one order, values[zero_count], to its modes. */
static void order_radial(const TbBodyOrder *order, uint32_t which, const double *values,
                         double *radial) {
  for (uint32_t k = 0; k < order->mode_count; k++) {
    const double *v = order->vectors[which] + (size_t)k * order->zero_count;
    double sum = 0.0;
    for (uint32_t i = 0; i < order->zero_count; i++) sum += v[i] * values[i];
    radial[order->rows[k]] = sum;
  }
}

void tb_body_radial(const TbBody *body, uint32_t which, double r, const double *patch,
                    double *radial) {
  double values[TB_MAX_ZEROS];
  for (uint32_t m = 0; m < body->order_count; m++) {
    const TbBodyOrder *order = &body->orders[m];
    order_values(order, r / body->radius, patch ? patch + order->first_zero : NULL, values);
    order_radial(order, which, values, radial);
  }
}

void tb_body_add_lift(const TbBody *body, uint32_t which, double r, double *radial) {
  double power = 1.0; /* (r/R)^m */
  for (uint32_t m = 0; m < body->order_count; m++, power *= r / body->radius) {
    const TbBodyOrder *order = &body->orders[m];
    const double *edge = order->edge[which];
    for (uint32_t k = 0; edge && k < order->mode_count; k++) {
      radial[order->rows[k]] += edge[k] * power;
    }
  }
}

void tb_body_hoop(const TbBody *body, double *radial) {
  for (uint32_t m = 0; m < body->order_count; m++) {
    const TbBodyOrder *order = &body->orders[m];
    for (uint32_t k = 0; k < order->mode_count; k++) {
      radial[order->rows[k]] = order->hoop ? order->hoop[k] : 0.0;
    }
  }
}

void tb_body_radial_tabled(const TbBody *body, const TbBesselTable *table, uint32_t which, double r,
                           const double *patch, double *radial) {
  double values[TB_MAX_ZEROS];
  for (uint32_t m = 0; m < body->order_count; m++) {
    const TbBodyOrder *order = &body->orders[m];
    for (uint32_t i = 0; i < order->zero_count; i++) {
      values[i] = patch[order->first_zero + i] *
                  tb_bessel_table_value(table, m, order->zeros[i] * r / body->radius);
    }
    order_radial(order, which, values, radial);
  }
}
