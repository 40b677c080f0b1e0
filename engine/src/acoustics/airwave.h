/* SPDX-License-Identifier: MIT */
/* Outgoing spherical waves of one moving head (airfield.h has the formulas). Set-up only. */
#ifndef TB_AIRWAVE_H
#define TB_AIRWAVE_H

#include "acoustics/airfield.h"

typedef struct TbAirWaves {
  uint32_t m, degrees; /* waves m .. degrees */
  double x;
  double *c; /* [2 (degrees + 1)] (re, im) */
} TbAirWaves;

/* True if the waves come by projection of the far field, whose nodes must then resolve them. */
bool tb_air_waves_project(const TbAirPlan *plan);

bool tb_air_waves_prepare(TbAirWaves *waves, const TbAirPlan *plan, TbArena *scratch,
                          const TbAirNodes *nodes, const TbAirSource *source);

/* The field at a point outside the unit sphere about the head's centre. */
void tb_air_waves_at(const TbAirWaves *waves, double radius, double height, double field[2]);

#endif
