/* SPDX-License-Identifier: MIT */
/* J_m of many orders on an even grid, for the many arguments in the air's integrals.
 *
 * Between grid points, the error of the polynomial through the eight nearest points is within (3.5
 * 2.5 1.5 0.5)^2 h^8 max|J^(8)|/8! = 3e-11, h = 1/8. One recurrence gives all orders at a point, so
 * the table costs little more than one order would. Set-up only. */
#ifndef TB_BESSEL_TABLE_H
#define TB_BESSEL_TABLE_H

#include "math/arena.h"

typedef struct TbBesselTable {
  uint32_t orders, count;
  double *values; /* [orders][count] */
} TbBesselTable;

/* Prepares orders below `orders` and arguments to `top`; a smaller `top` is used if the table would
 * get too large. Returns false if memory ran out. */
bool tb_bessel_table_prepare(TbBesselTable *table, TbArena *arena, uint32_t orders, double top);

/* j[q] = J_m(scale x[q]), q < count, a multiple of 8. Without a table (NULL), and for arguments
 * beyond the table, each value is computed singly. */
void tb_bessel_table_values(const TbBesselTable *table, uint32_t m, uint32_t count, double scale,
                            const double *x, double *j);

/* J_m(x) by a table that holds m and x. */
double tb_bessel_table_value(const TbBesselTable *table, uint32_t m, double x);

#endif
