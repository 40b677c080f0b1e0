/* SPDX-License-Identifier: MIT */
/* Complex linear systems by Gauss' elimination with row exchanges [GolubVanLoan, 3.4]. */
#ifndef TB_LU_H
#define TB_LU_H

#include <stdbool.h>
#include <stdint.h>

/* Solves A x = b: A row-major n x n, all numbers (re, im) pairs. A is destroyed, b becomes x.
 * Returns false if A is singular. */
bool tb_solve_complex(uint32_t n, double *a, double *b);

#endif
