/* SPDX-License-Identifier: MIT */
/* The symmetric eigenproblem, generalized, dense:  K v = lambda M v,  M positive definite.
 *
 *   1. M = U^T U                                      Cholesky's factor
 *   2. A = U^-T K U^-1,  A y = lambda y,  v = U^-1 y  the standard problem [GolubVanLoan, 8.7.2]
 *   3. Q^T A Q = T                                    tridiagonal, by Householder's reflections
 *   4. T = S diag(lambda) S^T,  y = Q S               implicit QL with Wilkinson's shifts
 *
 * Steps 3 and 4 are the algorithm of EISPACK's tred2 and imtql2 [WilkinsonReinsch, II/2, II/4]. The
 * error of an eigenvalue is a few rounding errors of the largest eigenvalue. Small eigenvalues are
 * most accurate if K grows from its first row to its last, as it does for modes sorted by
 * frequency.
 *
 * All operations run in a fixed order, so the same matrices give the same bits on every machine. */
#ifndef TB_EIGEN_H
#define TB_EIGEN_H

#include "math/arena.h"

/* K and M are row-major n x n and are destroyed; `mass` NULL stands for the unit matrix. On return,
 * row i of `vectors` is the i-th eigenvector with v^T M v = 1, eigenvalues ascending. Returns false
 * if memory ran out or the watch cancelled, if M is not positive definite, or if QL did not
 * converge, as with a NaN in K. */
bool tb_eigen_symmetric(TbArena *scratch, uint32_t n, double *stiffness, double *mass,
                        double *eigenvalues, double *vectors);

#endif
