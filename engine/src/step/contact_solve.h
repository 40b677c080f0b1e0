/* SPDX-License-Identifier: MIT */
/* The contact solve of solve.h in one precision; contact_solve_tmpl.c is compiled for each.
 *
 * In single precision (`draft` and `live`) the same steps lead to the same equations, with twice as many numbers in a
 * register, half as many bytes to move, and all wires taking part. States, what the forces do to them, and the
 * ledger stay double. So nothing drifts; but the work that forces do and the energy that contacts keep agree only to
 * rounding, some 1e-7 of the energy that goes through the contacts in a sample, either way. The iteration ends where
 * forces would lose up to 3e-6 of that energy, and what is lost so is booked as lost in contacts.
 *
 * In double an iteration that comes to no end is balanced once more, up to half of the forces' change away.
 * Audio-safe. */
#ifndef TB_CONTACT_SOLVE_H
#define TB_CONTACT_SOLVE_H

#include "step/solve.h"

typedef struct TbContactMethod {
  /* Whether wire points may touch. */
  bool (*near)(const TbSolve *solve);
  /* tb_solve() where something may touch: true with everything set, or false where it does not settle, in single
   * precision with nothing but the workspace written. */
  bool (*solve)(TbSolve *solve, TbSolveOutcome *outcome);
  /* out = M x and x on the grid. */
  void (*product)(TbSolve *solve, const double *x, double *grid, double *out);
  /* One Newton step from what stands in the workspace as s, law and slope: force, product, grid and s follow. */
  void (*step)(TbSolve *solve, uint32_t inner_cap, double inner_tolerance);
} TbContactMethod;

extern const TbContactMethod tb_contact_method, tb_contact_methodf;

#endif
