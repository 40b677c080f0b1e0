/* SPDX-License-Identifier: MIT */
#include "drum/view.h"

#include <string.h>

#include "drum/drum.h"
#include "strikers/stick.h"

/* ---- heads ---------------------------------------------------------------------------------- */

/* C_m and S_m of every order, at every radius. */
static void sum_modes(const TbViewTables *view, const TbViewHead *head, const double *q) {
  const uint32_t radii = view->seen.radii;
  const double *rest = view->model->rest.q;
  memset(view->sums, 0, 2 * (size_t)view->orders * radii * sizeof *view->sums);
  for (uint32_t k = 0; k < head->count; k++) {
    const TbViewMode *mode = &head->modes[k];
    const double amount = q[mode->mode] + rest[mode->mode];
    double *sum = view->sums + (size_t)mode->sum * radii;
    for (uint32_t i = 0; i < radii; i++) sum[i] += mode->radial[i] * amount;
  }
}

static void turn_sums(const TbViewTables *view, const TbViewHead *head) {
  const uint32_t radii = view->seen.radii, angles = view->seen.angles;
  for (uint32_t i = 0; i < radii; i++) {
    double *circle = head->displacement + (size_t)i * angles;
    memset(circle, 0, angles * sizeof *circle);
    for (uint32_t k = 0; k < 2 * view->orders; k++) {
      const double sum = view->sums[(size_t)k * radii + i];
      const double *turn = view->turn + (size_t)k * angles;
      for (uint32_t j = 0; j < angles; j++) circle[j] += sum * turn[j];
    }
  }
}

/* ---- wires ---------------------------------------------------------------------------------- */

/* A node's height outwards from the wire's ends. */
static double node_height(const TbView *state, const TbWire *wire, uint32_t node) {
  const uint32_t at = wire->first_node + node;
  if (node == 0 || node >= wire->cells) return 0.0;
  return state->model->wires.shape[at - TB_WIRE_FRONT] + state->model->rest.v[at] +
         state->now.v[at];
}

/* Heights between two nodes lie on the straight line. */
static void view_wire(const TbViewTables *view, const TbView *state, uint32_t w) {
  const TbWire *wire = &view->model->wires.wires[w];
  const uint32_t points = view->seen.wire_points;
  const double ends = view->model->rest.offset[w] - state->state->wires.shift[w];
  for (uint32_t p = 0; p < points; p++) {
    const double place = (double)wire->cells * p / (points - 1);
    const uint32_t node = (uint32_t)place;
    const double before = node_height(state, wire, node);
    const double after = node_height(state, wire, node + 1);
    view->wires[(size_t)w * points + p] =
      view->model->wires.side * (ends + before + (place - node) * (after - before));
  }
}

static void view_contacts(const TbViewTables *view, const TbView *state, uint32_t w) {
  const TbWire *wire = &view->model->wires.wires[w];
  const uint32_t points = view->seen.wire_points;
  double *contact = view->contact + (size_t)w * points;
  memset(contact, 0, points * sizeof *contact);
  for (uint32_t i = 0; i < wire->row_count; i++) {
    const double place = (double)(wire->row_node + i) * (points - 1) / wire->cells;
    contact[(uint32_t)(place + 0.5)] += state->solve.warm.force[wire->first_row + i];
  }
}

/* ---- sticks --------------------------------------------------------------------------------- */

_Static_assert(TABOR_VIEW_STICKS >= TB_SLOTS, "every striker is seen");

static TaborViewStick view_stick(const TbView *state, uint32_t i) {
  const TbSlot *slot = tb_slot(state, i);
  const double bow = slot->end.bends ? tb_stick_bow(state, i, &state->now) : 0.0;
  return (TaborViewStick){.id = slot->id,
                          .striker = slot->striker.definition,
                          .on_hoop = slot->on_hoop,
                          .radius = slot->radius,
                          .angle = slot->angle,
                          .height = slot->rest_height + state->now.z[i] + bow,
                          .force = state->solve.warm.force[tb_slot_row(&state->model->rows, i)]};
}

static void view_sticks(TaborView *seen, const TbView *state) {
  seen->stick_count = 0;
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    if (!tb_slot_strikes(tb_slot(state, i))) continue;
    seen->sticks[seen->stick_count++] = view_stick(state, i);
  }
}

/* ---- public --------------------------------------------------------------------------------- */

bool tabor_drum_view(const TaborDrum *drum, TaborView *seen) {
  const TbViewTables *view = (const TbViewTables *)seen;
  if (drum->model != view->model) return false;
  const TbView state = tb_view(drum->state, drum->model);
  for (uint32_t h = 0; h < seen->heads; h++) {
    sum_modes(view, &view->heads[h], state.now.q);
    turn_sums(view, &view->heads[h]);
  }
  for (uint32_t w = 0; w < seen->wire_count; w++) {
    view_wire(view, &state, w);
    view_contacts(view, &state, w);
  }
  view_sticks(seen, &state);
  tabor_drum_ledger(drum, &seen->ledger);
  return true;
}
