/* SPDX-License-Identifier: MIT */
/* Dense linear algebra for set-up. The only file that calls LAPACK; all memory comes from an arena. */
#ifndef TB_LINEAR_H
#define TB_LINEAR_H

#include "math/arena.h"

/* Solves K v = lambda M v, both symmetric, M positive definite, row-major n x n. On return row i of
 * `vectors` is the i-th eigenvector with v^T M v = 1, eigenvalues ascending. K and M are destroyed. */
bool tb_eigen_symmetric(TbArena *scratch, uint32_t n, double *stiffness, double *mass,
                        double *eigenvalues, double *vectors);

/* Solves A x = b for symmetric positive definite A, row-major; A is destroyed, b becomes x. */
bool tb_solve_positive(uint32_t n, double *matrix, uint32_t columns, double *right_hand_sides);

/* Cholesky's factor of a symmetric positive definite A, row-major, in its place; and A x = b with it. */
bool tb_factor_positive(uint32_t n, double *matrix);
bool tb_solve_with_factor(uint32_t n, const double *factor, double *right_hand_side);

/* A = L D L^T for a complex symmetric A whose real part is positive definite and whose imaginary part is
 * semidefinite: then no pivot is small and none need be exchanged [Higham1998]. Lower triangles, row-major,
 * become L (its unit diagonal left out) and D. False if memory ran out or A is singular. */
bool tb_factor_symmetric(TbArena *scratch, uint32_t n, double *re, double *im);

/* Solves A x = b with these factors; b as (re, im) pairs becomes x. */
void tb_solve_factored(uint32_t n, const double *re, const double *im, double *b);

#endif
