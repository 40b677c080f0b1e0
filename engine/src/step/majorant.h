/* SPDX-License-Identifier: MIT */
/* The contact step (solve.h) for a sample in which Newton's iteration has not converged and no
 * balance is near. It is one linear step over parabolas that lie above the potential,
 *   f = V'(y) + C s/2.
 * The first attempt bounds the curvature between y and the point's predicted end. Points that went
 * further are repeated with the largest curvature of the whole potential. Energy that the outcome
 * would still create is reported as `excess`. In double alone. Audio-safe. */
#ifndef TB_MAJORANT_H
#define TB_MAJORANT_H

#include "step/solve.h"

/* Takes the step after a solve in double that did not settle. */
void tb_majorant(TbSolve *solve, TbSolveOutcome *outcome);

#endif
