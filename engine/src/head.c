/* SPDX-License-Identifier: MIT */
#include "head.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bessel.h"
#include "linear.h"

static const double PI = 3.14159265358979323846;

/* About z^2/4 - z/2 modes lie below z, sine copies counted: 2048 of them below this. */
static const double TOP_ZERO = 91.0;

/* What one order needs while it is built. */
typedef struct OrderWork {
  const TaborDrumDef *def;
  double azimuth; /* a_m */
  double limit;   /* highest frequency kept [rad/s] */
  bool lossless;
} OrderWork;

static double stiffness_at(const TaborHeadDef *head, double wavenumber) {
  const double k2 = wavenumber * wavenumber;
  return head->tension * k2 + head->bending_stiffness * k2 * k2;
}

/* Estimate with the air's mass rho0/K on each side: enough to choose the basis. */
static double frequency_at(const TaborDrumDef *def, double zero) {
  const double wavenumber = zero / def->shell.radius;
  const double mass = def->batter.surface_density + 2.0 * def->air.density / wavenumber;
  return sqrt(stiffness_at(&def->batter, wavenumber) / mass) / (2.0 * PI);
}

static double zero_at_frequency(const TaborDrumDef *def, double frequency) {
  double lo = 0.5, hi = TOP_ZERO;
  if (frequency_at(def, hi) <= frequency) return hi;
  for (int i = 0; i < 60; i++) {
    const double middle = 0.5 * (lo + hi);
    if (frequency_at(def, middle) < frequency) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return hi;
}

/* Normal modes at low frequency: vectors by rows, unit modal mass; eigenvalues omega^2. */
static TaborStatus solve_order(const OrderWork *work, TbArena *scratch, const TbAirOrder *air,
                               double *eigenvalues, double *vectors) {
  const TaborDrumDef *def = work->def;
  const uint32_t n = air->count;
  const double radius = def->shell.radius;
  double *mass = tb_arena_doubles(scratch, (size_t)n * n);
  double *stiffness = tb_arena_doubles(scratch, (size_t)n * n);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  double both_sides = def->air.density * radius * radius * radius * work->azimuth;
  if (def->air.density > 0.0) {
    if (def->shell.boundary == TABOR_BOUNDARY_OPEN) {
      tb_air_mass_open(air, mass);
    } else {
      if (!tb_air_mass_baffled(air, scratch, mass)) return TABOR_ERROR_MEMORY;
      both_sides *= 2.0;
    }
    for (uint32_t i = 0; i < n * n; i++) mass[i] *= both_sides;
  }
  for (uint32_t i = 0; i < n; i++) {
    const double norm = work->azimuth * radius * radius * 0.5 * air->slopes[i] * air->slopes[i];
    mass[i * n + i] += norm * def->batter.surface_density;
    stiffness[i * n + i] = norm * stiffness_at(&def->batter, air->zeros[i] / radius);
  }
  if (def->air.density > 0.0) {
    return tb_eigen_symmetric(scratch, n, stiffness, mass, eigenvalues, vectors)
             ? TABOR_OK
             : (scratch->failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS);
  }
  for (uint32_t i = 0; i < n; i++) { /* in vacuo the Bessel functions are the modes */
    eigenvalues[i] = stiffness[i * n + i] / mass[i * n + i];
    vectors[i * n + i] = 1.0 / sqrt(mass[i * n + i]);
  }
  return TABOR_OK;
}

static void scale(double *v, uint32_t n, double factor) {
  for (uint32_t i = 0; i < n; i++) v[i] *= factor;
}

/* Replaces the air's low-frequency mass in mode `v` by its mass at the mode's own frequency, and
 * computes decay rates and fields. `omega2` comes in from the low-frequency problem. */
static bool finish_mode(const OrderWork *work, TbArena *scratch, const TbAirOrder *air,
                        double omega2, double *v, TbHeadMode *mode) {
  const TaborDrumDef *def = work->def;
  const TaborHeadDef *batter = &def->batter;
  const double radius = def->shell.radius;
  double own_mass = 0.0, stiffness = 0.0, loss = 0.0;
  for (uint32_t i = 0; i < air->count; i++) {
    const double wavenumber = air->zeros[i] / radius;
    const double norm = work->azimuth * radius * radius * 0.5 * air->slopes[i] * air->slopes[i];
    const double share = norm * v[i] * v[i];
    own_mass += share * batter->surface_density;
    stiffness += share * stiffness_at(batter, wavenumber);
    loss += share * batter->surface_density *
            (batter->damping_0 + batter->damping_1 * wavenumber * wavenumber);
  }
  mode->omega = sqrt(omega2);
  double total = own_mass, resistance = 0.0;
  if (def->air.density > 0.0) {
    TbAirPoint points[TABOR_MAX_MICS];
    for (uint32_t p = 0; p < def->mic_count; p++) {
      points[p] = (TbAirPoint){def->mic[p].radius / radius, def->mic[p].height / radius};
    }
    const double unit = work->azimuth * def->air.density * radius * radius;
    const TaborBoundary boundary = (TaborBoundary)def->shell.boundary;
    double x = mode->omega * radius / def->air.sound_speed;
    /* The mass of the lowest modes changes most: they get a second pass. */
    for (int pass = x < 3.0 ? 0 : 1; pass < 2; pass++) {
      TbAirLoad load;
      x = mode->omega * radius / def->air.sound_speed;
      if (!tb_air_load(air, scratch, boundary, v, x, points, pass == 1 ? def->mic_count : 0, &load,
                       mode->fields)) {
        return false;
      }
      total = own_mass + unit * radius * load.mass;
      resistance = unit * def->air.sound_speed * load.resistance;
      mode->omega = sqrt(stiffness / total);
    }
  }
  scale(v, air->count, 1.0 / sqrt(total));
  scale(mode->fields, 2 * TABOR_MAX_MICS, 1.0 / sqrt(total));
  mode->radiation_rate = work->lossless ? 0.0 : 0.5 * fmax(0.0, resistance) / total;
  mode->decay_rate = work->lossless ? 0.0 : 0.5 * loss / total + mode->radiation_rate;
  return true;
}

static TaborStatus build_order(TbHead *head, TbArena *arena, const OrderWork *work,
                               TbHeadOrder *order, TbHeadMode *modes, uint32_t room) {
  TbArena scratch;
  tb_arena_prepare(&scratch, &arena->allocator);
  const uint32_t n = order->zero_count;
  TbAirOrder air;
  double *eigenvalues = tb_arena_doubles(&scratch, n);
  order->vectors = tb_arena_doubles(arena, (size_t)n * n);
  order->rows = tb_arena_take(arena, n, sizeof *order->rows);
  TaborStatus status = TABOR_ERROR_MEMORY;
  if (!scratch.failed && !arena->failed &&
      tb_air_order_prepare(&air, &scratch, order->m, order->zeros, n)) {
    status = solve_order(work, &scratch, &air, eigenvalues, order->vectors);
  }
  for (uint32_t k = 0; status == TABOR_OK && k < n && order->mode_count < room; k++) {
    if (!(eigenvalues[k] <= work->limit * work->limit)) break;
    TbHeadMode *mode = &modes[order->mode_count];
    *mode = (TbHeadMode){.m = order->m, .n = k + 1};
    TbArena one;
    tb_arena_prepare(&one, &arena->allocator);
    const bool finished =
      finish_mode(work, &one, &air, eigenvalues[k], order->vectors + (size_t)k * n, mode);
    if (!finished) status = one.failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
    tb_arena_release(&one);
    order->mode_count++;
  }
  head->row_count += order->mode_count;
  tb_arena_release(&scratch);
  return status;
}

static int compare_modes(const void *a, const void *b) {
  const TbHeadMode *x = a, *y = b;
  if (x->omega != y->omega) return x->omega < y->omega ? -1 : 1;
  return x->m < y->m ? -1 : (x->m > y->m ? 1 : (x->n < y->n ? -1 : x->n > y->n));
}

/* Sorts the modes of all orders by frequency and tells each order where its own went. */
static void sort_modes(TbHead *head) {
  qsort(head->modes, head->row_count, sizeof *head->modes, compare_modes);
  for (uint32_t row = 0; row < head->row_count; row++) {
    const TbHeadMode *mode = &head->modes[row];
    head->orders[mode->m].rows[mode->n - 1] = row;
  }
}

TaborStatus tb_head_prepare(TbHead *head, TbArena *arena, const TaborDrumDef *def,
                            double bandwidth) {
  const double top = zero_at_frequency(def, 1.03 * bandwidth);
  *head =
    (TbHead){.radius = def->shell.radius, .bandwidth = fmin(bandwidth, frequency_at(def, top))};
  const double basis_top = top + (def->air.density > 0.0 ? 2.0 * PI : 0.0);
  const uint32_t most_orders = (uint32_t)basis_top + 1u;
  const uint32_t room = (uint32_t)(0.5 * basis_top) + 2u;
  head->orders = tb_arena_take(arena, most_orders, sizeof *head->orders);
  head->modes = tb_arena_take(arena, TB_MAX_MODES, sizeof *head->modes);
  if (arena->failed) return TABOR_ERROR_MEMORY;

  OrderWork work = {
    .def = def, .limit = 2.0 * PI * head->bandwidth, .lossless = def->quality.losses == 0};
  for (uint32_t m = 0; m < most_orders; m++) {
    TbHeadOrder *order = &head->orders[m];
    const TbHeadOrder *last = m ? &head->orders[m - 1] : NULL;
    order->m = m;
    order->first_zero = head->zero_count;
    order->zeros = tb_arena_doubles(arena, room);
    if (arena->failed) return TABOR_ERROR_MEMORY;
    order->zero_count = tb_bessel_zeros(m, basis_top, last ? last->zeros : NULL,
                                        last ? last->zero_count : 0, order->zeros, room);
    if (order->zero_count == 0) break;
    work.azimuth = m ? PI : 2.0 * PI;
    const TaborStatus status = build_order(head, arena, &work, order, head->modes + head->row_count,
                                           TB_MAX_MODES - head->row_count);
    if (status != TABOR_OK) return status;
    head->zero_count += order->zero_count;
    head->order_count++;
  }
  sort_modes(head);
  return TABOR_OK;
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

void tb_head_radial(const TbHead *head, double r, const double *patch, double *radial) {
  double values[64]; /* an order has at most 2 + TOP_ZERO/2 + pi zeros */
  for (uint32_t m = 0; m < head->order_count; m++) {
    const TbHeadOrder *order = &head->orders[m];
    order_values(order, r / head->radius, patch ? patch + order->first_zero : NULL, values);
    for (uint32_t k = 0; k < order->mode_count; k++) {
      const double *v = order->vectors + (size_t)k * order->zero_count;
      double sum = 0.0;
      for (uint32_t i = 0; i < order->zero_count; i++) sum += v[i] * values[i];
      radial[order->rows[k]] = sum;
    }
  }
}
