/* SPDX-License-Identifier: MIT */
/* The parts of M x (solve.h) beside the grid's own compliance, in double for either precision. Audio-safe. */
#ifndef TB_SLOT_COMPLIANCE_H
#define TB_SLOT_COMPLIANCE_H

#include "step/solve.h"

static inline bool tb_slot_in_play(const TbContacts *in, uint32_t slot) {
  return in->slot_mask >> slot & 1u;
}

/* What forces at the slots do to the head: added to `answer` on the grid, out[] at the slots, which also
 * yield to forces on the grid (`pushed`). */
void tb_solve_slots(const TbContacts *in, const double *pushed, const double *slots, double *answer,
                    double *out);

/* What the stretching of the heads takes from their answer to forces on the grid and at the slots. */
void tb_solve_stretch(const TbContacts *in, const double *pushed, const double *slots,
                      double *answer, double *out);

#endif
