/* SPDX-License-Identifier: MIT */
#include "bodies/drum/cavity_eigen.h"

#include <math.h>

#include "bodies/sheet_waves.h"
#include "math/eigen.h"

static const double PI = 3.14159265358979323846;

/* Head h by itself. */
static void add_head(const TbCavityEigen *drum, const TbAirOrder *air, uint32_t h, uint32_t size,
                     double *mass, double *stiffness, double *own) {
  const uint32_t n = air->count;
  const double radius = drum->cavity.radius, azimuth = air->m ? PI : 2.0 * PI;
  for (uint32_t i = 0; i < n; i++) {
    const double norm = azimuth * radius * radius * 0.5 * air->slopes[i] * air->slopes[i];
    const size_t diagonal = (size_t)(h * n + i) * size + h * n + i;
    mass[diagonal] += norm * drum->heads[h]->surface_density;
    own[h * n + i] = norm * tb_sheet_stiffness(drum->heads[h], air->zeros[i] / radius);
    stiffness[diagonal] += own[h * n + i];
  }
}

/* The air outside, between heads a and b. */
static void add_outside(const TbCavityEigen *drum, const TbAirOrder *air, uint32_t a, uint32_t b,
                        uint32_t size, double *mass) {
  const double *outside = a == b ? drum->own : drum->mutual;
  if (!outside) return;
  const uint32_t n = air->count;
  const double radius = drum->cavity.radius, azimuth = air->m ? PI : 2.0 * PI;
  const double unit = drum->outside * azimuth * radius * radius * radius;
  for (uint32_t i = 0; i < n; i++) {
    double *row = mass + (size_t)(a * n + i) * size + b * n;
    for (uint32_t k = 0; k < n; k++) row[k] += unit * outside[i * n + k];
  }
}

TaborStatus tb_cavity_eigen_solve(const TbCavityEigen *drum, TbArena *scratch,
                                  const TbAirOrder *air, const TbCavityOrder *cavity,
                                  double *eigenvalues, double *vectors) {
  const uint32_t size = tb_cavity_eigen_size(cavity, drum, air), heads = drum->cavity.heads;
  double *mass = tb_arena_doubles(scratch, (size_t)size * size);
  double *stiffness = tb_arena_doubles(scratch, (size_t)size * size);
  double *own = tb_arena_doubles(scratch, (size_t)heads * air->count);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  for (uint32_t a = 0; a < heads; a++) {
    add_head(drum, air, a, size, mass, stiffness, own);
    for (uint32_t b = 0; b < heads; b++) add_outside(drum, air, a, b, size, mass);
  }
  tb_cavity_assemble(cavity, &drum->cavity, air, size, mass, stiffness);
  const bool moves = tb_cavity_eigen_rim(drum) > 0;
  if (moves) tb_rim_assemble(drum->rim, air, heads, size, own, mass, stiffness);
  if (!tb_eigen_symmetric(scratch, size, stiffness, mass, eigenvalues, vectors)) {
    return scratch->failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
  }
  for (uint32_t k = 0; moves && k < size; k++) {
    tb_rim_add_lift(drum->rim, air, heads, size, vectors + (size_t)k * size);
  }
  return TABOR_OK;
}
