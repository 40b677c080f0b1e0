/* SPDX-License-Identifier: MIT */
#include "contact/solve.h"

#include <string.h>

#include "contact/contact_solve.h"
#include "contact/majorant.h"
#include "contact/slot_compliance.h"

/* One after the other until contacts settle. */
static const TbContactMethod *const METHODS[][3] = {
  [TB_IN_DOUBLE] = {&tb_contact_method},
  [TB_IN_FLOAT] = {&tb_contact_methodf, &tb_contact_method},
};

void tb_solve_product(TbSolve *solve, const double *x, double *grid, double *out) {
  METHODS[solve->in.precision][0]->product(solve, x, grid, out);
}

/* Whether a striker, hand or muffler may touch. */
static bool slots_act(const TbSolve *solve) {
  const TbContacts *in = &solve->in;
  for (uint32_t slot = 0; in->slot_mask >> slot; slot++) {
    const uint32_t row = tb_slot_row(&in->rows, slot);
    if (!tb_contacts_have_slot(in, slot)) continue;
    if (in->slot_laws[slot].kind == TB_CONTACT_LAW_DAMPER) return true;
    if (in->y[row] > 0.0 || in->y[row] + in->b[row] > 0.0) return true;
    if (solve->warm.force[row] != 0.0) return true;
  }
  return false;
}

void tb_solve_forget(TbSolve *solve) {
  const size_t bytes = (tb_row_count(&solve->in.rows)) * sizeof(double);
  memset(solve->warm.force, 0, bytes);
  memset(solve->warm.product, 0, bytes);
  memset(solve->warm.grid, 0, solve->in.wire_grid->size * sizeof(double));
}

TbSolveOutcome tb_solve(TbSolve *solve) {
  const TbContactMethod *const *method = METHODS[solve->in.precision];
  TbSolveOutcome outcome = {0};
  if (!(*method)->near(solve) && !slots_act(solve)) {
    tb_solve_forget(solve);
    memcpy(solve->s, solve->in.b, (tb_row_count(&solve->in.rows)) * sizeof(double));
    return outcome;
  }
  outcome.contact = true;
  if ((*method)->solve(solve, &outcome)) return outcome;
  while (*++method) {
    /* A start that another precision left is rounded. */
    (*method)->product(solve, solve->warm.force, solve->warm.grid, solve->warm.product);
    if ((*method)->solve(solve, &outcome)) return outcome;
  }
  tb_majorant(solve, &outcome);
  return outcome;
}
