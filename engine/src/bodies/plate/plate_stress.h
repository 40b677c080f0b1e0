/* SPDX-License-Identifier: MIT */
/* The tables of bodies/membrane.h of a plate. The functions of stress are
 *   Psi_j = Sum_i a_ji g_i,  G a = mu W a,  a^T G a = 1,
 * G and W the compliance and the area of plate_forms.h: eigenfunctions of the middle surface, the
 * softest first. They are kept up to a part of the wavenumber of the highest mode that takes part:
 * with all of them the middle surface of a plate that bends at random stores V; with 17, 34, 76 and
 * 183 of them 57, 70, 89 and 99 % of it, and from 30 on third octaves of strokes hardly differ.
 *
 * Gauss's rule along the radius and the even one around it are right to rounding where products of
 * two modes and a function of stress have no more waves than these rules resolve. Set-up only. */
#ifndef TB_PLATE_STRESS_H
#define TB_PLATE_STRESS_H

#include "bodies/membrane.h"
#include "bodies/plate/plate_forms.h"

/* Prepares the points for modes whose waves on the flat disc have lambda up to `lambda`, and
 * `orders` orders without tables. Returns false if memory ran out. */
bool tb_plate_stress_begin(const TaborDrumDef *def, double lambda, uint32_t orders, TbArena *arena,
                           TbMembrane *membrane);

/* The highest lambda of the functions of stress that are kept. */
double tb_plate_stress_top(double lambda);

/* Fills the tables of order m for `count` modes, amplitudes[count][forms->count] of the disc's
 * modes in them. Returns TABOR_ERROR_MEMORY or TABOR_ERROR_NUMERICS on failure. */
TaborStatus tb_plate_stress_order(const TaborDrumDef *def, const TbBesselTable *table,
                                  double lambda, uint32_t m, const TbPlateForms *forms,
                                  uint32_t count, const double *amplitudes, TbArena *arena,
                                  TbArena *scratch, TbMembrane *membrane);

#endif
