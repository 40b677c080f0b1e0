/* SPDX-License-Identifier: MIT */
/* Outgoing spherical waves of one moving head (radiated_field.h has the formulas). Set-up only. */
#ifndef TB_MULTIPOLES_H
#define TB_MULTIPOLES_H

#include "air_model/radiated_field.h"

typedef struct TbMultipoles {
  uint32_t m, degrees; /* waves m .. degrees */
  double x;
  double *c;         /* [2 (degrees + 1)] (re, im) */
  double *couplings; /* [degrees + 2] g_n of u L_n = g_{n+1} L_{n+1} + g_n L_{n-1} */
} TbMultipoles;

/* True if the waves are projected from the far field. The far field's nodes must then resolve the
 * waves. */
bool tb_multipoles_project(const TbAirPlan *plan);

bool tb_multipoles_prepare(TbMultipoles *waves, const TbAirPlan *plan, TbArena *scratch,
                           const TbWavenumberNodes *nodes, const TbAirSource *source);

/* The field at a point outside the unit sphere around the head's centre. */
void tb_multipoles_at(const TbMultipoles *waves, double radius, double height, double field[2]);

#endif
