/* SPDX-License-Identifier: MIT */
/* Symmetric positive definite systems: A = U^T U with U upper triangular [GolubVanLoan, 4.2].
 * All operations run in a fixed order. */
#ifndef TB_CHOLESKY_H
#define TB_CHOLESKY_H

#include "math/arena.h"

/* Replaces A, row-major n x n, by U in its upper and U^T in its lower triangle, so that every
 * substitution runs along rows. Returns false if A is not positive definite. */
bool tb_factor_positive(uint32_t n, double *matrix);
/* Row i of this, after all rows above it. */
bool tb_factor_row(uint32_t n, uint32_t i, double *matrix);

/* Solves A x = b with the factor from tb_factor_positive(); b becomes x. */
void tb_solve_with_factor(uint32_t n, const double *factor, double *right_hand_side);

/* Solves U x = b, the second half of tb_solve_with_factor(); b becomes x. */
void tb_solve_upper(uint32_t n, const double *factor, double *right_hand_side);

/* Solves A x = b for each b in the rows of `right_hand_sides`. A becomes its factor, b becomes x.
 * Returns false if A is not positive definite. */
bool tb_solve_positive(uint32_t n, double *matrix, uint32_t columns, double *right_hand_sides);

#endif
