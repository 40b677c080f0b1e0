/* SPDX-License-Identifier: MIT */
/* The parts of M x (solve.h) beside the grid's own compliance, in double for either precision. A
 * slot is a place in the striker pool. Audio-safe. */
#ifndef TB_SLOT_COMPLIANCE_H
#define TB_SLOT_COMPLIANCE_H

#include "contact/solve.h"

static inline bool tb_contacts_have_slot(const TbContacts *in, uint32_t slot) {
  return in->slot_mask >> slot & 1u;
}

/* Response of the head to forces at the slots: added to `answer` on the grid, and written to out[]
 * at the slots. out[] includes the response at the slots to forces on the grid (`pushed`). */
void tb_solve_slots(const TbContacts *in, const double *pushed, const double *slots, double *answer,
                    double *out);

/* Subtracts the effect of the heads' stretching from their response to forces on the grid and at
 * the slots. */
void tb_solve_stretch(const TbContacts *in, const double *pushed, const double *slots,
                      double *answer, double *out);

#endif
