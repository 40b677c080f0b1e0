/* SPDX-License-Identifier: MIT */
/* The step of contacts (solve.h) where Newton's iteration came to no end and no balance is near: one linear step over
 * parabolas that lie above the potential,
 *   f = V'(y) + C s/2,
 * first between y and where the point would go, then, where it went further, with the largest curvature that the
 * potential has anywhere. Energy that the outcome would still create is reported as `excess`. In double alone.
 * Audio-safe. */
#ifndef TB_MAJORANT_H
#define TB_MAJORANT_H

#include "step/solve.h"

/* After a solve in double that did not settle. */
void tb_majorant(TbSolve *solve, TbSolveOutcome *outcome);

#endif
