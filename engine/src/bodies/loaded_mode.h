/* SPDX-License-Identifier: MIT */
/* The air's load on a mode of a single surface that moves at its own frequency: mass, resistance
 * and sound.
 *
 * The air's mass in a mode depends on the frequency, which depends on the mass: from the frequency
 * omega of the low-frequency problem,
 *   omega^2 = K/(M + M_air(omega)),
 * is passed through twice for the lowest modes, whose mass changes most, and once for the others.
 * Set-up only. */
#ifndef TB_LOADED_MODE_H
#define TB_LOADED_MODE_H

#include "bodies/body.h"

/* A mode's mass without the air [kg], its stiffness [N/m], and its loss [kg/s]. */
typedef struct TbOwnParts {
  double mass, stiffness, loss;
} TbOwnParts;

typedef struct TbAirParts {
  double mass, resistance; /* [kg, kg/s] */
} TbAirParts;

/* Low-frequency mass of the air on both sides, in units of the surface's amplitudes: adds it to the
 * first rows and columns of matrix[size][size]. Returns false if memory ran out. */
bool tb_load_matrix(const TaborDrumDef *def, TbArena *scratch, const TbAirOrder *air, uint32_t size,
                    double *matrix);

/* For the motion y[air->count] with these own parts, improves mode->omega and writes mode->fields,
 * per unit amplitude. Returns false if memory ran out. */
bool tb_load_mode(const TaborDrumDef *def, TbArena *scratch, const TbAirOrder *air,
                  const TbOwnParts *own, const double *y, TbBodyMode *mode, TbAirParts *load);

#endif
