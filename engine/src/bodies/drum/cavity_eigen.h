/* SPDX-License-Identifier: MIT */
/* One angular order of a drum with air inside: both heads (or one over a rigid bottom), the cavity,
 * and the air outside as mass, as one symmetric eigenproblem K v = omega^2 M v.
 *
 * Unknowns: outward amplitudes of the Bessel functions of the upper head, those of the lower head,
 * then the cavity's coordinates u_c (cavity.h). The air outside adds its low-frequency mass to each
 * head and between them (shell_radiation.h). A rim that moves has the last coordinates (rim.h); the
 * heads' amplitudes in the vectors then include its lift. Vectors have unit modal mass. Set-up
 * only. */
#ifndef TB_CAVITY_EIGEN_H
#define TB_CAVITY_EIGEN_H

#include "bodies/drum/cavity.h"
#include "bodies/drum/rim.h"

typedef struct TbCavityEigen {
  TbCavity cavity;
  const TaborHeadDef *heads[2]; /* upper, lower; the second NULL over a rigid bottom */
  double outside;               /* density of the air outside [kg/m3] */
  /* Its mass matrices in units of a_m rho0 R^3, [count][count] row-major: of each head, and between
   * the heads. NULL: no mass. */
  const double *own, *mutual;
  const TbRim *rim; /* NULL: at rest */
} TbCavityEigen;

static inline uint32_t tb_cavity_eigen_rim(const TbCavityEigen *drum) {
  return drum->rim ? drum->rim->count : 0u;
}

static inline uint32_t tb_cavity_eigen_size(const TbCavityOrder *cavity, const TbCavityEigen *drum,
                                            const TbAirOrder *air) {
  return drum->cavity.heads * air->count + cavity->mode_count + tb_cavity_eigen_rim(drum);
}

/* eigenvalues[size] ascending [rad^2/s^2], vectors[size][size] by rows. Returns TABOR_ERROR_MEMORY
 * or TABOR_ERROR_NUMERICS on failure. */
TaborStatus tb_cavity_eigen_solve(const TbCavityEigen *drum, TbArena *scratch,
                                  const TbAirOrder *air, const TbCavityOrder *cavity,
                                  double *eigenvalues, double *vectors);

#endif
