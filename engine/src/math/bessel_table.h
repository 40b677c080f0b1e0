/* SPDX-License-Identifier: MIT */
/* J_m of many orders on an even grid, for the many arguments that the air's integrals ask for.
 *
 * Between grid points the polynomial through the eight nearest ones is within
 * (3.5 2.5 1.5 0.5)^2 h^8 max|J^(8)|/8! = 3e-11, h = 1/8. One recurrence gives all orders at a point, so
 * the table costs little more than one order would. Set-up only. */
#ifndef TB_BESSEL_TABLE_H
#define TB_BESSEL_TABLE_H

#include "math/arena.h"

typedef struct TbBesselTable {
  uint32_t orders, count;
  double *values; /* [orders][count] */
} TbBesselTable;

/* Orders below `orders`, arguments to `top`, which is cut where the table would get too large. False if
 * memory ran out. */
bool tb_bessel_table_prepare(TbBesselTable *table, TbArena *arena, uint32_t orders, double top);

/* j[q] = J_m(scale x[q]), q < count, a multiple of 8; computed one by one without a table (NULL) and
 * where it does not reach. */
void tb_bessel_table_values(const TbBesselTable *table, uint32_t m, uint32_t count, double scale,
                            const double *x, double *j);

#endif
