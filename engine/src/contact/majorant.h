/* SPDX-License-Identifier: MIT */
/* The contact step (solve.h) for a sample in which Newton's iteration has not converged and no
 * balance is near. It is one linear step over parabolas that lie above the potential,
 *   f = V'(y) + C s/2.
 * C first covers the interval from y to the point's predicted end. If the outcome creates energy,
 * the step is repeated, and every point in contact takes the largest curvature of its potential.
 * Energy that the outcome would still create is reported as `excess`. In double alone.
 * Audio-safe. */
#ifndef TB_MAJORANT_H
#define TB_MAJORANT_H

#include "contact/solve.h"

/* Takes the step after a solve in double that did not settle. */
void tb_majorant(TbSolve *solve, TbSolveOutcome *outcome);

#endif
