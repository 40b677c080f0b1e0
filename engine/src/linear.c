/* SPDX-License-Identifier: MIT */
#include "linear.h"

#include <lapacke.h>
#include <string.h>

/* Symmetric matrices read the same by rows and by columns, so column-major calls serve throughout;
 * then eigenvectors arrive in columns, which are our rows. */

bool tb_eigen_symmetric(TbArena *scratch, uint32_t n, double *stiffness, double *mass,
                        double *eigenvalues, double *vectors) {
  const lapack_int size = (lapack_int)n;
  const lapack_int work_size = 34 * size;
  double *work = tb_arena_doubles(scratch, (size_t)work_size);
  if (!work) return false;
  const lapack_int info = LAPACKE_dsygv_work(LAPACK_COL_MAJOR, 1, 'V', 'U', size, stiffness, size,
                                             mass, size, eigenvalues, work, work_size);
  if (info != 0) return false;
  memcpy(vectors, stiffness, (size_t)n * n * sizeof *vectors);
  return true;
}

bool tb_solve_positive(uint32_t n, double *matrix, uint32_t columns, double *right_hand_sides) {
  if (n == 0) return true;
  const lapack_int size = (lapack_int)n;
  return LAPACKE_dposv_work(LAPACK_COL_MAJOR, 'U', size, (lapack_int)columns, matrix, size,
                            right_hand_sides, size) == 0;
}

bool tb_factor_positive(uint32_t n, double *matrix) {
  const lapack_int size = (lapack_int)n;
  return n == 0 || LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'U', size, matrix, size) == 0;
}

bool tb_solve_factored(uint32_t n, const double *factor, double *right_hand_side) {
  const lapack_int size = (lapack_int)n;
  return n == 0 || LAPACKE_dpotrs_work(LAPACK_COL_MAJOR, 'U', size, 1, factor, size,
                                       right_hand_side, size) == 0;
}

bool tb_solve_complex(TbArena *scratch, uint32_t n, double *matrix, uint32_t columns,
                      double *right_hand_sides) {
  const lapack_int size = (lapack_int)n;
  lapack_int *pivots = tb_arena_take(scratch, n, sizeof *pivots);
  if (!pivots) return false;
  return LAPACKE_zgesv_work(LAPACK_COL_MAJOR, size, (lapack_int)columns,
                            (lapack_complex_double *)(void *)matrix, size, pivots,
                            (lapack_complex_double *)(void *)right_hand_sides, size) == 0;
}
