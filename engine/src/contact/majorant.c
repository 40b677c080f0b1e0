/* SPDX-License-Identifier: MIT */
#include "contact/majorant.h"

#include <math.h>
#include <string.h>

#include "contact/contact_solve.h"
#include "contact/slot_compliance.h"

/* The majorant takes energy only where its linear system is really solved. */
static const uint32_t MAJORANT_CAP = 32;
static const double MAJORANT_TOLERANCE = 1e-10;
/* Work is exact to this part of what makes it up. */
static const double WORK_TOLERANCE = 1e-13;

static uint32_t total_rows(const TbSolve *solve) { return tb_row_count(&solve->in.rows); }

/* Curvature of the parabola through V(y) with slope V'(y) that lies above V between y and y + sp.
 */
static double majorant_curvature(const TbContactLaw *law, double y, double b, double free) {
  double sp = free > 0.0 ? free : 0.0;
  if (b > sp) sp = 0.5 * (sp + b);
  const double size = fabs(y) > sp ? fabs(y) : sp;
  if (sp <= 1e-9 * size) return tb_contact_law_curvature(law, y);
  const double bend = tb_contact_law_work(law, y, sp) - tb_contact_law_static_force(law, y) * sp;
  return bend > 0.0 ? 2.0 * bend / (sp * sp) : 0.0;
}

/* NULL for a slot that is not in play. */
static const TbContactLaw *law_of(const TbSolve *solve, uint32_t row) {
  if (row < tb_wire_rows(&solve->in.rows))
    return &solve->in.wire_laws[row / solve->in.wire_grid->lanes];
  const uint32_t slot = row - tb_slot_row(&solve->in.rows, 0);
  return tb_contacts_have_slot(&solve->in, slot) ? &solve->in.slot_laws[slot] : NULL;
}

/* V'' is nowhere larger (contact_law.h): this parabola lies above V whatever s turns out to be. */
static double largest_curvature(const TbContactLaw *law) {
  return tb_contact_law_curvature(law, 1e3);
}

/* Force at s = 0 and half the curvature of every row's majorant; `safe` where the last one failed:
 * what touched at its s takes the largest curvature. */
static void prepare_majorants(TbSolve *solve, bool safe) {
  for (uint32_t row = 0; row < total_rows(solve); row++) {
    const TbContactLaw *law = law_of(solve, row);
    solve->work.law[row] = solve->work.slope[row] = 0.0;
    if (!law) continue;
    const double y = solve->in.y[row], b = solve->in.b[row];
    const bool touches = y > 0.0 || y + solve->s[row] > 0.0;
    solve->work.law[row] = tb_contact_law_static_force(law, y);
    if (law->kind == TB_CONTACT_LAW_DAMPER) {
      solve->work.slope[row] = law->loss;
    } else if (safe && touches) {
      solve->work.slope[row] = 0.5 * largest_curvature(law);
    } else {
      solve->work.slope[row] =
        0.5 * majorant_curvature(law, y, b, b - solve->work.product_last[row]);
    }
  }
}

typedef struct Work {
  double value,
    scale; /* Sum of what is still to be found for the growth of the potential, and of |f s| */
} Work;

/* A value > 0 means that energy was created; and what the laws lose at s. */
static Work majorant_work(const TbSolve *solve, double *contact, double *damper) {
  Work h = {0.0, 0.0};
  for (uint32_t row = 0; row < total_rows(solve); row++) {
    const TbContactLaw *law = law_of(solve, row);
    if (!law) continue;
    const double work = solve->warm.force[row] * solve->s[row];
    h.value += tb_contact_law_work(law, solve->in.y[row], solve->s[row]) - work;
    h.scale += fabs(work);
    *(law->kind == TB_CONTACT_LAW_DAMPER ? damper : contact) +=
      tb_contact_law_loss(law, solve->in.y[row], solve->s[row]);
  }
  return h;
}

/* One linear step, f = V'(y) + C s/2. */
static void majorant_step(TbSolve *solve, bool safe, TbSolveOutcome *outcome) {
  const size_t bytes = total_rows(solve) * sizeof(double);
  solve->work.wires = true;
  prepare_majorants(solve, safe);
  memset(solve->s, 0, bytes);
  tb_contact_newton_step(solve, MAJORANT_CAP, MAJORANT_TOLERANCE);
  for (uint32_t row = 0; row < total_rows(solve); row++) {
    const TbContactLaw *law = law_of(solve, row);
    if (!law) continue;
    solve->warm.force[row] =
      tb_contact_law_static_force(law, solve->in.y[row]) + solve->work.slope[row] * solve->s[row];
  }
  tb_contact_method.product(solve, solve->warm.force, solve->warm.grid, solve->warm.product);
  solve->in.kernels->change(total_rows(solve), solve->in.b, solve->warm.product, solve->s);
  double contact = 0.0, damper = 0.0;
  const Work h = majorant_work(solve, &contact, &damper);
  outcome->excess = h.value > WORK_TOLERANCE * h.scale ? h.value : 0.0;
  /* The laws' losses count as far as the work done covers them. */
  const double lost = contact + damper, covered = h.value < 0.0 ? -0.5 * h.value : 0.0;
  const double part = lost > covered ? covered / lost : 1.0;
  outcome->contact_loss = part * contact;
  outcome->damper_loss = part * damper;
}

void tb_majorant(TbSolve *solve, TbSolveOutcome *outcome) {
  outcome->fallback = true;
  majorant_step(solve, false, outcome);
  if (outcome->excess > 0.0) majorant_step(solve, true, outcome);
  outcome->touching = 0;
  for (uint32_t i = 0; i < total_rows(solve); i++) {
    outcome->touching += solve->work.slope[i] > 0.0;
  }
}
