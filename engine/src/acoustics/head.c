/* SPDX-License-Identifier: MIT */
#include "acoustics/head.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "acoustics/closed_drum_modes.h"
#include "acoustics/single_head.h"
#include "math/bessel.h"

static const double PI = 3.14159265358979323846;

/* Most of the air's integrals end at this many times the basis' highest zero. */
static const double AIR_REACH = 4.0;

/* Estimate with the air's mass rho0/K on each side: enough to choose the basis. */
static double frequency_at(const TaborDrumDef *def, const TaborHeadDef *head, double zero) {
  const double wavenumber = zero / def->shell.radius;
  const double mass = head->surface_density + 2.0 * def->air.density / wavenumber;
  return sqrt(tb_head_stiffness(head, wavenumber) / mass) / (2.0 * PI);
}

static double zero_at_frequency(const TaborDrumDef *def, const TaborHeadDef *head, double frequency,
                                double top) {
  double lo = 0.5, hi = top;
  if (frequency_at(def, head, hi) <= frequency) return hi;
  for (int i = 0; i < 60; i++) {
    const double middle = 0.5 * (lo + hi);
    if (frequency_at(def, head, middle) < frequency) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return hi;
}

static TaborStatus build_order(TbHead *head, TbArena *arena, const TaborDrumDef *def,
                               const TbBesselTable *table, const TbShellMesh *shell, double rim_top,
                               TbHeadOrder *order) {
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  const TbModeLimits limit = {2.0 * PI * head->bandwidth,
                              2.0 * PI * fmax(head->bandwidth, rim_top)};
  TbHeadMode *modes = head->modes + head->row_count;
  const uint32_t room = head->most_modes - head->row_count;
  TbAirOrder air;
  TbRim rim;
  tb_rim_prepare(&rim, def, order->m);
  TaborStatus status = TABOR_ERROR_MEMORY;
  if (tb_air_order_prepare(&air, &scratch, order->m, order->zeros, order->zero_count)) {
    air.table = table;
    status =
      tb_has_cavity(def)
        ? tb_closed_drum_order(def, arena, &scratch, &air, &rim, shell, limit, order, modes, room)
        : tb_single_head_order(def, arena, &scratch, &air, &rim, limit, order, modes, room);
  }
  order->rows = tb_arena_take(arena, order->mode_count + 1u, sizeof *order->rows);
  if (arena->failed) status = TABOR_ERROR_MEMORY;
  head->row_count += order->mode_count;
  tb_arena_release(&scratch);
  return status;
}

static int compare_modes(const void *a, const void *b) {
  const TbHeadMode *x = a, *y = b;
  if (x->omega != y->omega) return x->omega < y->omega ? -1 : 1;
  return x->m < y->m ? -1 : (x->m > y->m ? 1 : (x->index < y->index ? -1 : x->index > y->index));
}

/* Sorts the modes of all orders by frequency and tells each order where its own went. */
static void sort_modes(TbHead *head) {
  qsort(head->modes, head->row_count, sizeof *head->modes, compare_modes);
  for (uint32_t row = 0; row < head->row_count; row++) {
    const TbHeadMode *mode = &head->modes[row];
    head->orders[mode->m].rows[mode->place] = row;
  }
}

double tb_head_basis(const TaborDrumDef *def, double bandwidth, TbHeadLimits limits,
                     double *reached) {
  const uint32_t count = tb_is_two_headed(def) ? 2 : 1;
  const TaborHeadDef *const heads[TB_HEADS] = {&def->batter, &def->resonant};
  double top = 0.0;
  *reached = bandwidth;
  for (uint32_t h = 0; h < count; h++) {
    const double own = zero_at_frequency(def, heads[h], 1.03 * bandwidth, limits.zero);
    top = fmax(top, own);
    *reached = fmin(*reached, frequency_at(def, heads[h], own));
  }
  if (count == 2) *reached = tb_closed_drum_bandwidth(def, *reached, limits.modes);
  return top + (def->air.density > 0.0 ? 2.0 * PI : 0.0);
}

static TaborStatus build_orders(TbHead *head, TbArena *arena, const TaborDrumDef *def,
                                const TbBesselTable *table, const TbShellMesh *shell,
                                double basis_top, double rim_top, uint32_t most) {
  const uint32_t room = (uint32_t)(0.5 * basis_top) + 2u;
  for (uint32_t m = 0; m < most; m++) {
    if (!tb_arena_go_on_at(arena, (double)m / most)) return TABOR_ERROR_MEMORY;
    TbHeadOrder *order = &head->orders[m];
    order->m = m;
    order->first_zero = head->zero_count;
    order->zeros = tb_arena_doubles(arena, room);
    if (arena->failed) return TABOR_ERROR_MEMORY;
    order->zero_count = tb_bessel_zeros(m, basis_top, order->zeros, room);
    if (order->zero_count == 0) break;
    const TaborStatus status = build_order(head, arena, def, table, shell, rim_top, order);
    if (status != TABOR_OK) return status;
    head->zero_count += order->zero_count;
    head->order_count++;
  }
  return TABOR_OK;
}

TaborStatus tb_head_prepare(TbHead *head, TbArena *arena, const TaborDrumDef *def, double bandwidth,
                            TbHeadLimits limits) {
  *head = (TbHead){.heads = tb_is_two_headed(def) ? 2 : 1,
                   .most_modes = limits.modes,
                   .radius = def->shell.radius};
  const double basis_top = tb_head_basis(def, bandwidth, limits, &head->bandwidth);
  const uint32_t most_orders = (uint32_t)basis_top + 1u;
  head->orders = tb_arena_take(arena, most_orders, sizeof *head->orders);
  head->modes = tb_arena_take(arena, limits.modes, sizeof *head->modes);
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  TbBesselTable table;
  TbShellMesh shell;
  const bool outside = tb_has_cavity(def) && def->air.density > 0.0;
  TaborStatus status = TABOR_ERROR_MEMORY;
  if (tb_bessel_table_prepare(&table, &scratch, most_orders, AIR_REACH * basis_top) &&
      (!outside || tb_closed_drum_shell(def, &scratch, &shell)) && !arena->failed) {
    status = build_orders(head, arena, def, &table, outside ? &shell : NULL, basis_top, limits.rim,
                          most_orders);
  }
  tb_arena_release(&scratch);
  if (status == TABOR_OK) sort_modes(head);
  return status;
}

double tb_head_lowest(const TbHead *head) {
  uint32_t row = 0;
  while (row + 1u < head->row_count && head->modes[row].part == TABOR_PART_RIM) row++;
  return head->modes[row].omega;
}

TaborModeInfo tb_head_mode_info(const TbHeadMode *mode) {
  return (TaborModeInfo){.m = mode->m,
                         .n = mode->n,
                         .frequency = mode->omega / (2.0 * PI),
                         .decay_rate = mode->decay_rate,
                         .radiation_rate = mode->radiation_rate,
                         .part = (TaborModePart)mode->part,
                         .phase = mode->phase,
                         .multiplicity = mode->m ? 2 : 1};
}

double tb_head_slope_square(const TbHead *head, uint32_t which, const TbHeadMode *mode) {
  const TbHeadOrder *order = &head->orders[mode->m];
  const double *v = order->vectors[which] + (size_t)mode->place * order->zero_count;
  const double azimuth = mode->m ? PI : 2.0 * PI;
  double sum = 0.0;
  for (uint32_t i = 0; i < order->zero_count; i++) {
    const double slope = order->zeros[i] * tb_bessel_j(mode->m + 1, order->zeros[i]);
    sum += v[i] * v[i] * slope * slope;
  }
  const double edge = order->edge ? order->edge[mode->place] : 0.0;
  return 0.5 * azimuth * sum + azimuth * mode->m * edge * edge;
}

void tb_head_patch(const TbHead *head, double patch_radius, double *patch) {
  uint32_t index = 0;
  for (uint32_t m = 0; m < head->order_count; m++) {
    const TbHeadOrder *order = &head->orders[m];
    for (uint32_t i = 0; i < order->zero_count; i++, index++) {
      const double ka = order->zeros[i] * patch_radius / head->radius;
      patch[index] = ka > 1e-6 ? 2.0 * tb_bessel_j(1, ka) / ka : 1.0;
    }
  }
}

/* Values of all Bessel functions of one order at r, eight at a time. */
static void order_values(const TbHeadOrder *order, double r, const double *patch, double *values) {
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
static void order_radial(const TbHeadOrder *order, uint32_t which, const double *values,
                         double *radial) {
  for (uint32_t k = 0; k < order->mode_count; k++) {
    const double *v = order->vectors[which] + (size_t)k * order->zero_count;
    double sum = 0.0;
    for (uint32_t i = 0; i < order->zero_count; i++) sum += v[i] * values[i];
    radial[order->rows[k]] = sum;
  }
}

void tb_head_radial(const TbHead *head, uint32_t which, double r, const double *patch,
                    double *radial) {
  double values[TB_MAX_ZEROS];
  for (uint32_t m = 0; m < head->order_count; m++) {
    const TbHeadOrder *order = &head->orders[m];
    order_values(order, r / head->radius, patch ? patch + order->first_zero : NULL, values);
    order_radial(order, which, values, radial);
  }
}

void tb_head_add_lift(const TbHead *head, double r, double *radial) {
  double power = 1.0; /* (r/R)^m */
  for (uint32_t m = 0; m < head->order_count; m++, power *= r / head->radius) {
    const TbHeadOrder *order = &head->orders[m];
    for (uint32_t k = 0; order->edge && k < order->mode_count; k++) {
      radial[order->rows[k]] += order->edge[k] * power;
    }
  }
}

void tb_head_hoop(const TbHead *head, double *radial) {
  for (uint32_t m = 0; m < head->order_count; m++) {
    const TbHeadOrder *order = &head->orders[m];
    for (uint32_t k = 0; k < order->mode_count; k++) {
      radial[order->rows[k]] = order->hoop ? order->hoop[k] : 0.0;
    }
  }
}

void tb_head_radial_tabled(const TbHead *head, const TbBesselTable *table, uint32_t which, double r,
                           const double *patch, double *radial) {
  double values[TB_MAX_ZEROS];
  for (uint32_t m = 0; m < head->order_count; m++) {
    const TbHeadOrder *order = &head->orders[m];
    for (uint32_t i = 0; i < order->zero_count; i++) {
      values[i] = patch[order->first_zero + i] *
                  tb_bessel_table_value(table, m, order->zeros[i] * r / head->radius);
    }
    order_radial(order, which, values, radial);
  }
}
