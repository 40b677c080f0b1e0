/* SPDX-License-Identifier: MIT */
#include "acoustics/single_head.h"

#include <math.h>

#include "acoustics/cavity_eigen.h"
#include "math/eigen.h"

static const double PI = 3.14159265358979323846;

/* What one order needs while it is built. */
typedef struct OrderWork {
  const TaborDrumDef *def;
  double azimuth; /* a_m */
  bool lossless;
} OrderWork;

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
    stiffness[i * n + i] = norm * tb_head_stiffness(&def->batter, air->zeros[i] / radius);
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
    stiffness += share * tb_head_stiffness(batter, wavenumber);
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
    /* The mass of the lowest modes changes most: they get a second pass, and all digits. */
    const bool exact = x < 3.0;
    for (int pass = exact ? 0 : 1; pass < 2; pass++) {
      TbAirLoad load;
      x = mode->omega * radius / def->air.sound_speed;
      if (!tb_air_load(air, scratch, boundary, exact && pass == 1, v, x, points,
                       pass == 1 ? def->mic_count : 0, &load, mode->fields)) {
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

/* Finishes the modes up to `limit` [rad/s], vectors by rows. */
static TaborStatus finish_modes(const OrderWork *work, TbArena *arena, const TbAirOrder *air,
                                const double *eigenvalues, double limit, TbHeadOrder *order,
                                TbHeadMode *modes, uint32_t room) {
  for (uint32_t k = 0; k < air->count && order->mode_count < room; k++) {
    if (!(eigenvalues[k] <= limit * limit)) break;
    TbHeadMode *mode = &modes[order->mode_count];
    *mode = (TbHeadMode){.m = order->m, .n = k + 1, .index = k, .place = k};
    TbArena one;
    tb_arena_prepare(&one, &arena->allocator);
    const bool finished = finish_mode(work, &one, air, eigenvalues[k],
                                      order->vectors[0] + (size_t)k * air->count, mode);
    const bool failed = one.failed;
    tb_arena_release(&one);
    if (!finished) return failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
    order->mode_count++;
  }
  return TABOR_OK;
}

TaborStatus tb_single_head_order(const TaborDrumDef *def, TbArena *arena, TbArena *scratch,
                                 const TbAirOrder *air, double limit, TbHeadOrder *order,
                                 TbHeadMode *modes, uint32_t room) {
  const OrderWork work = {
    .def = def, .azimuth = air->m ? PI : 2.0 * PI, .lossless = def->quality.losses == 0};
  const uint32_t n = air->count;
  double *eigenvalues = tb_arena_doubles(scratch, n);
  order->vectors[0] = tb_arena_doubles(arena, (size_t)n * n);
  if (scratch->failed || arena->failed) return TABOR_ERROR_MEMORY;
  const TaborStatus status = solve_order(&work, scratch, air, eigenvalues, order->vectors[0]);
  if (status != TABOR_OK) return status;
  return finish_modes(&work, arena, air, eigenvalues, limit, order, modes, room);
}
