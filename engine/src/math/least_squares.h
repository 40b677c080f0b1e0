/* SPDX-License-Identifier: MIT */
/* Overdetermined linear systems by the normal equations [GolubVanLoan, 5.3.2]: for matrices whose
 * condition number is small, since it is squared. */
#ifndef TB_LEAST_SQUARES_H
#define TB_LEAST_SQUARES_H

#include "math/arena.h"

/* Minimises |A x - b| for each b in the rows of `b`: A is row-major rows x n, b is [columns][rows],
 * x is [columns][n]. Returns false if memory ran out or A has not rank n. */
bool tb_least_squares(TbArena *scratch, uint32_t rows, uint32_t n, const double *a,
                      uint32_t columns, const double *b, double *x);

#endif
