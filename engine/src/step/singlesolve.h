/* SPDX-License-Identifier: MIT */
/* The contact solve of solve.h in single precision, for `draft` and `live`: the same steps to the same
 * equations, with twice as many numbers in a register, half as many bytes to move, and all wires taking part.
 *
 * States, what the forces do to them, and the ledger stay double. So nothing drifts; but the work that forces do
 * and the energy that contacts keep agree only to rounding, some 1e-7 of the energy that goes through the contacts in
 * a sample, either way. The iteration ends where forces would lose up to 3e-6 of that energy, and what is lost so
 * is booked as lost in contacts.
 *
 * Wires whose laws have no kernel, and what does not settle within the caps, are left to the solve in double.
 * Audio-safe. */
#ifndef TB_SINGLE_SOLVE_H
#define TB_SINGLE_SOLVE_H

#include "step/solve.h"

/* Whether contacts are solved here at all. */
static inline bool tb_solves_in_single(const TbSolve *solve) {
  return solve->single.kernels && !solve->lifted;
}

/* As tb_solve() where something may touch; false, and nothing but scratch written, where it does not settle. */
bool tb_single_solve(TbSolve *solve, TbSolveOutcome *outcome);

/* out = M x and x on the grid, as this solve computes them. */
void tb_single_product(const TbSolve *solve, const double *x, double *grid, double *out);

#endif
