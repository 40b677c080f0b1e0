/* SPDX-License-Identifier: MIT */
#include "bodies/drum/single_head.h"

#include <math.h>

#include "bodies/drum/cavity_eigen.h"
#include "bodies/drum/rim_radiation.h"
#include "bodies/felt_ring.h"
#include "bodies/loaded_mode.h"
#include "bodies/sheet_waves.h"
#include "math/eigen.h"

static const double PI = 3.14159265358979323846;

/* Data of one order while it is built. */
typedef struct OrderWork {
  const TaborDrumDef *def;
  const TbRim *rim;
  double azimuth;     /* a_m */
  const double *ring; /* loss of a felt ring: see felt_ring.h */
  bool lossless;
} OrderWork;

/* Normal modes at low frequency: vectors by rows, unit modal mass, with the rim's lift (rim.h);
 * eigenvalues omega^2. */
static TaborStatus solve_order(const OrderWork *work, TbArena *scratch, const TbAirOrder *air,
                               double *eigenvalues, double *vectors) {
  const TaborDrumDef *def = work->def;
  const uint32_t n = air->count, size = n + work->rim->count;
  const double radius = def->shell.radius;
  double *mass = tb_arena_doubles(scratch, (size_t)size * size);
  double *stiffness = tb_arena_doubles(scratch, (size_t)size * size);
  double *own = tb_arena_doubles(scratch, n);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  if (def->air.density > 0.0 && !tb_load_matrix(def, scratch, air, size, mass))
    return TABOR_ERROR_MEMORY;
  for (uint32_t i = 0; i < n; i++) {
    const double norm = work->azimuth * radius * radius * 0.5 * air->slopes[i] * air->slopes[i];
    own[i] = norm * tb_sheet_stiffness(&def->batter, air->zeros[i] / radius);
    mass[i * size + i] += norm * def->batter.surface_density;
    stiffness[i * size + i] = own[i];
  }
  if (work->rim->count > 0) tb_rim_assemble(work->rim, air, 1, size, own, mass, stiffness);
  if (def->air.density > 0.0 || work->rim->count > 0) {
    if (!tb_eigen_symmetric(scratch, size, stiffness, mass, eigenvalues, vectors)) {
      return scratch->failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
    }
    for (uint32_t k = 0; k < size; k++) {
      tb_rim_add_lift(work->rim, air, 1, size, vectors + (size_t)k * size);
    }
    return TABOR_OK;
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

static TbOwnParts own_parts(const OrderWork *work, const TbAirOrder *air, const double *v) {
  const TaborHeadDef *batter = &work->def->batter;
  const double radius = work->def->shell.radius;
  const TbRimMotion rim = tb_rim_motion(work->rim, v + air->count);
  TbOwnParts own = {.mass = 0.0};
  for (uint32_t i = 0; i < air->count; i++) {
    const double wavenumber = air->zeros[i] / radius;
    const double bent = v[i] - rim.edge * tb_rim_lift(air, 0, i);
    const double norm = work->azimuth * radius * radius * 0.5 * air->slopes[i] * air->slopes[i];
    const double share = norm * v[i] * v[i], film = tb_sheet_film_loss(batter, wavenumber);
    const double lifted = norm * (v[i] * v[i] - bent * bent);
    own.mass += share * batter->surface_density;
    own.stiffness += (share - lifted) * tb_sheet_stiffness(batter, wavenumber);
    own.loss += share * batter->surface_density * (batter->damping_0 + film) -
                lifted * batter->surface_density * film;
  }
  own.loss += tb_felt_ring_loss(work->ring, air->count, v);
  own.mass += tb_rim_mass(work->rim, rim) + tb_rim_missing_mass(work->rim, air, rim);
  own.stiffness += tb_rim_stiffness(work->rim, rim);
  return own;
}

/* Replaces the air's low-frequency mass in mode `v` by its mass at the mode's own frequency, scales
 * v to unit mass, and computes decay rates and fields. `omega2` comes in from the low-frequency
 * problem. */
static bool finish_mode(const OrderWork *work, TbArena *scratch, const TbAirOrder *air,
                        double omega2, double *v, TbBodyMode *mode) {
  const TaborDrumDef *def = work->def;
  const TbOwnParts own = own_parts(work, air, v);
  mode->omega = sqrt(omega2);
  TbAirParts load;
  if (!tb_load_mode(def, scratch, air, &own, v, mode, &load)) return false;
  const double total = own.mass + load.mass;
  scale(v, air->count + work->rim->count, 1.0 / sqrt(total));
  scale(mode->fields, 2 * TABOR_MAX_MICS, 1.0 / sqrt(total));
  const TbRimMotion rim = tb_rim_motion(work->rim, v + air->count);
  mode->radiation_rate = 0.5 * fmax(0.0, load.resistance) / total;
  tb_rim_radiate(work->rim, def, rim, mode);
  if (work->lossless) {
    mode->radiation_rate = 0.0;
    return true;
  }
  mode->shell_rate = tb_rim_decay_rate(work->rim, rim, mode->omega);
  mode->decay_rate = 0.5 * own.loss / total + mode->radiation_rate + mode->shell_rate;
  return true;
}

/* Keeps what moves the head relative to its lifted edge, and the rim. */
static void keep_vector(const OrderWork *work, const TbAirOrder *air, const double *v,
                        TbBodyOrder *order) {
  const TbRimMotion rim = tb_rim_motion(work->rim, v + air->count);
  double *kept = order->vectors[0] + (size_t)order->mode_count * air->count;
  for (uint32_t i = 0; i < air->count; i++) {
    kept[i] = v[i] - rim.edge * tb_rim_lift(air, 0, i);
  }
  if (!order->edge[0]) return;
  order->edge[0][order->mode_count] = rim.edge;
  order->hoop[order->mode_count] = rim.hoop;
}

/* The Bessel function that moves most, from 1. */
static uint32_t strongest(const TbAirOrder *air, const double *v) {
  uint32_t most = 0;
  for (uint32_t i = 1; i < air->count; i++) {
    if (fabs(v[i] * air->slopes[i]) > fabs(v[most] * air->slopes[most])) most = i;
  }
  return most + 1u;
}

/* Finishes the modes up to `limit`, vectors by rows. */
static TaborStatus finish_modes(const OrderWork *work, TbArena *arena, const TbAirOrder *air,
                                const double *eigenvalues, double *vectors, TbModeLimits limit,
                                TbBodyOrder *order, TbBodyMode *modes, uint32_t room) {
  const uint32_t size = air->count + work->rim->count;
  for (uint32_t k = 0; k < size && order->mode_count < room; k++) {
    if (!(eigenvalues[k] <= limit.rim * limit.rim)) break;
    double *v = vectors + (size_t)k * size;
    const double rim_mass = tb_rim_mass(work->rim, tb_rim_motion(work->rim, v + air->count));
    if (!tb_rim_keeps(limit, sqrt(eigenvalues[k]), rim_mass)) continue;
    TbBodyMode *mode = &modes[order->mode_count];
    *mode = (TbBodyMode){.m = order->m, .n = k + 1, .index = k, .place = order->mode_count};
    if (work->rim->count > 0) mode->n = strongest(air, v);
    if (rim_mass > 0.5) mode->part = TABOR_PART_RIM;
    TbArena one;
    tb_arena_beside(&one, arena);
    const bool finished = finish_mode(work, &one, air, eigenvalues[k], v, mode);
    const bool failed = one.failed;
    tb_arena_release(&one);
    if (!finished) return failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
    keep_vector(work, air, v, order);
    order->mode_count++;
  }
  return TABOR_OK;
}

TaborStatus tb_single_head_order(const TaborDrumDef *def, TbArena *arena, TbArena *scratch,
                                 const TbAirOrder *air, const TbRim *rim, TbModeLimits limit,
                                 TbBodyOrder *order, TbBodyMode *modes, uint32_t room) {
  OrderWork work = {.def = def,
                    .rim = rim,
                    .azimuth = air->m ? PI : 2.0 * PI,
                    .lossless = def->quality.losses == 0};
  const uint32_t size = air->count + rim->count;
  double *eigenvalues = tb_arena_doubles(scratch, size);
  double *vectors = tb_arena_doubles(scratch, (size_t)size * size);
  order->vectors[0] = tb_arena_doubles(arena, (size_t)size * air->count);
  if (rim->count > 0) {
    order->edge[0] = tb_arena_doubles(arena, size);
    order->hoop = tb_arena_doubles(arena, size);
  }
  if (scratch->failed || arena->failed ||
      !tb_felt_ring_matrix(&def->batter, def->shell.radius, scratch, air, &work.ring)) {
    return TABOR_ERROR_MEMORY;
  }
  const TaborStatus status = solve_order(&work, scratch, air, eigenvalues, vectors);
  if (status != TABOR_OK) return status;
  return finish_modes(&work, arena, air, eigenvalues, vectors, limit, order, modes, room);
}
