/* SPDX-License-Identifier: MIT */
#include "step/plate_relax.h"

#include "air/mic_output.h"
#include "heads/cascade.h"
#include "heads/coupling.h"
#include "heads/von_karman.h"
#include "step/energy.h"
#include "strikers/striker_pool.h"
#include "wires/wire_motion.h"

/* The surface moves by less than this when modes are changed [m]. */
static const double MARGIN = 2e-3;

/* Something strikes the plate, or might as soon as its modes are changed. */
static bool is_struck(const TbView *view) {
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    if (!tb_slot_strikes(tb_slot(view, i))) continue;
    const uint32_t row = tb_slot_row(&view->model->rows, i);
    if (view->now.eta[row] > -MARGIN || view->last.eta[row] > -MARGIN) return true;
  }
  return false;
}

/* If the surface has moved by more after all, the contact's energy is booked. */
static void book_contacts(TbView *view) {
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    if (!tb_slot_strikes(tb_slot(view, i)) || !tb_pool_touches(view, i)) continue;
    view->state->ledger.sums.control += tb_pool_contact_energy(view, i, &view->now, &view->last);
  }
}

static void add_displacements(TbView *view, double sign) {
  tb_pool_add_displacements(view, sign, &view->now);
  tb_pool_add_displacements(view, sign, &view->last);
}

/* The edges of a hi-hat follow. The energy that their contacts and the held modes gain by that is
 * the work of who holds them. */
static void move_edges(TbView *view, double before) {
  if (!view->state->wires.lifted) {
    tb_penetrations_from_displacements(view, &view->now);
    tb_penetrations_from_displacements(view, &view->last);
  }
  view->state->ledger.sums.control += tb_energy_stored(view, &view->now, &view->last) - before;
}

static void wake_all(TbView *view) {
  if (view->all_move) return;
  tb_pool_wake(view, NULL);
  tb_coupling_renew(view);
}

void tb_plate_relax(TbView *view, uint32_t steps) {
  if (view->state->plate.part == 0.0 || is_struck(view)) return;
  const double excess = tb_von_karman_excess(view);
  const bool cascades = tb_cascade_acts(view);
  if (excess == 0.0 && !cascades) return;
  if (cascades) wake_all(view);
  const bool rims = view->model->wires.rims;
  const double before = rims ? tb_energy_stored(view, &view->now, &view->last) : 0.0;
  add_displacements(view, -1.0);
  if (excess != 0.0) tb_von_karman_return(view, excess);
  if (cascades) tb_cascade_pass(view, steps);
  add_displacements(view, 1.0);
  if (rims) {
    move_edges(view, before);
  } else {
    book_contacts(view);
  }
  tb_mic_hear_anew(view);
}
