/* SPDX-License-Identifier: MIT */
#include "acoustics/cavity_eigen.h"

#include <math.h>

#include "math/eigen.h"

static const double PI = 3.14159265358979323846;

double tb_head_stiffness(const TaborHeadDef *head, double wavenumber) {
  const double k2 = wavenumber * wavenumber;
  return head->tension * k2 + head->bending_stiffness * k2 * k2;
}

/* Head h by itself, with the air outside it. */
static void add_head(const TbCavityEigen *drum, const TbAirOrder *air, uint32_t h, uint32_t size,
                     const double *outside, double *mass, double *stiffness) {
  const uint32_t n = air->count;
  const double radius = drum->cavity.radius, azimuth = air->m ? PI : 2.0 * PI;
  const double unit = 0.5 * drum->outside * azimuth * radius * radius * radius;
  for (uint32_t i = 0; i < n; i++) {
    const double norm = azimuth * radius * radius * 0.5 * air->slopes[i] * air->slopes[i];
    double *mass_row = mass + (size_t)(h * n + i) * size + h * n;
    for (uint32_t k = 0; k < n; k++) mass_row[k] += unit * outside[i * n + k];
    mass_row[i] += norm * drum->heads[h]->surface_density;
    stiffness[(size_t)(h * n + i) * size + h * n + i] +=
      norm * tb_head_stiffness(drum->heads[h], air->zeros[i] / radius);
  }
}

TaborStatus tb_cavity_eigen_solve(const TbCavityEigen *drum, TbArena *scratch,
                                  const TbAirOrder *air, const TbCavityOrder *cavity,
                                  double *eigenvalues, double *vectors) {
  const uint32_t n = air->count, size = tb_cavity_eigen_size(cavity, drum, air);
  double *outside = tb_arena_doubles(scratch, (size_t)n * n);
  double *mass = tb_arena_doubles(scratch, (size_t)size * size);
  double *stiffness = tb_arena_doubles(scratch, (size_t)size * size);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  tb_air_mass_open(air, outside);
  for (uint32_t h = 0; h < drum->cavity.heads; h++) {
    add_head(drum, air, h, size, outside, mass, stiffness);
  }
  tb_cavity_assemble(cavity, &drum->cavity, air, size, mass, stiffness);
  if (tb_eigen_symmetric(scratch, size, stiffness, mass, eigenvalues, vectors)) return TABOR_OK;
  return scratch->failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
}
