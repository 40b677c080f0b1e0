/* SPDX-License-Identifier: MIT */
/* Factors of complex symmetric matrices, dense, for set-up. All memory comes from an arena. */
#ifndef TB_LDLT_H
#define TB_LDLT_H

#include "math/arena.h"

/* Factors A = L D L^T for a complex symmetric A whose real part is positive definite and whose
 * imaginary part is semidefinite. For such an A no pivot is small, so no pivots are exchanged
 * [Higham1998]. Lower triangles, row-major, become L (without its unit diagonal) and D. Returns
 * false if memory ran out or A is singular. */
bool tb_factor_symmetric(TbArena *scratch, uint32_t n, double *re, double *im);

/* Solves A x = b with the factors from tb_factor_symmetric(); b as (re, im) pairs becomes x. */
void tb_solve_factored(uint32_t n, const double *re, const double *im, double *b);

#endif
