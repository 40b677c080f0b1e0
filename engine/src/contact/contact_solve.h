/* SPDX-License-Identifier: MIT */
/* The contact solve of solve.h in one precision; contact_solve.c and contact_solvef.c have one
 * each.
 *
 * Single precision (`draft` and `live`) solves the same equations with twice as many numbers per
 * register, half as many bytes to move, and all wires taking part. A Newton step does not begin at
 * the laws' own forces, whose response would cost a product with M, but at
 *   f~ + e/(1 + D c),  e = f(s) - f~,  c = the row's own compliance + the head's right below it,
 * as if rows did not feel each other. Conjugate gradients go on from there until the step, with
 * laws that are lines of slope D, would leave less than the accepted part of e/(1 + D c). Often
 * that is so at once; contact_solvef.c tries that first, in passes of its own. A difference between
 * forces and laws counts divided by 1 + D c, that is by what it would change. States, their
 * response to the forces, and the ledger stay double, so nothing drifts. The work of the forces and
 * the energy that contacts store agree only to rounding: about 1e-7 of the energy that goes through
 * the contacts in a sample, with either sign. The iteration ends where forces would lose up to 3e-6
 * of that energy; this loss is booked as lost in contacts. Near rest, where forces change by
 * rounding alone, they may lose or gain 1.5e-6 of it: of the stock snare drum's 1e-13 J a sample
 * then, 1e-14 W beside the 1e-8 W that a drum of 1e-9 J loses.
 *
 * In double, an iteration that does not converge is balanced once more, up to half of the forces'
 * change away. Audio-safe. */
#ifndef TB_CONTACT_SOLVE_H
#define TB_CONTACT_SOLVE_H

#include "contact/solve.h"

typedef struct TbContactMethod {
  /* True if wire points may touch. */
  bool (*near)(const TbSolve *solve);
  /* tb_solve() for a sample in which something may touch. Returns true with every output set.
   * Returns false if single precision does not settle; only the workspace is written then. */
  bool (*solve)(TbSolve *solve, TbSolveOutcome *outcome);
  /* out = M x; `grid` receives x on the grid. */
  void (*product)(TbSolve *solve, const double *x, double *grid, double *out);
} TbContactMethod;

extern const TbContactMethod tb_contact_method, tb_contact_methodf;

/* One Newton step in double. Reads s, law and slope from the workspace; updates force, product,
 * grid and s. */
void tb_contact_newton_step(TbSolve *solve, uint32_t inner_cap, double inner_tolerance);

#endif
