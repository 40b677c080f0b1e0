/* SPDX-License-Identifier: MIT */
/* Defines TbSolveWork and TbSolveWorkF, the workspace of a contact solve: see solve.h and
 * both.h. */
typedef struct TB_TYPE(TbSolveWork) {
  bool wires;               /* wire points take part */
  TB_REAL *s;               /* [rows], as all arrays before `grid` */
  TB_REAL *force, *product; /* f~ and M f~ */
  TB_REAL *force_last, *product_last;
  TB_REAL *law, *slope, *mean;
  TB_REAL *weight, *residual, *direction, *turned, *moved, *solution;
  TB_REAL *grid, *grid_last, *pushed, *answer; /* [grid size] */
  TB_REAL *scratch;                            /* [tb_wire_grid_scratch] */
#if TB_REAL_IS_FLOAT
  float *b, *y, *root, *contact_compliance, *before; /* [rows] */
  float *yield;                 /* [rows]: contact_compliance and the head's right below */
  float *stretch[TB_COUPLINGS]; /* [grid size] */
#endif
} TB_TYPE(TbSolveWork);
