/* SPDX-License-Identifier: MIT */
#include "step/edge_friction.h"

#include "step/energy_guard.h"
#include "strikers/striker_pool.h"

static const double PI = 3.14159265358979323846;

enum { EVERY = 16 }; /* steps: motion then shrinks by less than a hundredth at once */

/* EVERY k s, at most. */
static const double MOST = 0.05;

static bool is_touched(const TbView *view) {
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    if (tb_slot_in_play(tb_slot(view, i)) && tb_pool_touches(view, i)) return true;
  }
  return false;
}

/* Sum of the edges' forces [N]. */
static double pressure(const TbView *view) {
  double sum = 0.0;
  for (uint32_t row = 0; row < view->model->wires.stride; row++) sum += view->solve.warm.force[row];
  return sum;
}

/* Decay rates [1/s]: by a hi-hat's edges, by a hand on the edge. */
typedef struct Rates {
  double edges, hand;
} Rates;

static double edges_rate(const TbView *view) {
  if (!view->model->wires.rims || view->state->wires.lifted) return 0.0;
  return view->model->def.hihat.friction * pressure(view);
}

static double hand_rate(const TbView *view) {
  const TbEdgeGrip *grip = &view->state->strikers.edge;
  const TbBody *body = &view->model->body;
  const double area = PI * body->radius * body->radius;
  return grip->held ? grip->strength / (body->sheet[0].surface_density * area) : 0.0;
}

static void shorten(TbView *view, double part) {
  tb_pool_add_displacements(view, -1.0, &view->next);
  tb_shorten_modes(view, 1.0 - part);
  tb_pool_add_displacements(view, 1.0, &view->next);
}

bool tb_edge_friction(TbView *view) {
  const TaborDrumDef *def = &view->model->def;
  if (def->body.kind == TABOR_BODY_DRUM || !def->quality.losses) return false;
  if (view->state->clock % EVERY > 0 || is_touched(view)) return false;
  const Rates rates = {edges_rate(view), hand_rate(view)};
  const double all = rates.edges + rates.hand, wanted = EVERY * view->model->time_step * all;
  if (!(wanted > 0.0)) return false;
  const double before = tb_energy_and_losses(view);
  shorten(view, wanted < MOST ? wanted : MOST);
  const double lost = before - tb_energy_and_losses(view), by_hand = lost * (rates.hand / all);
  view->state->ledger.sums.contact_loss += lost - by_hand;
  view->state->ledger.sums.damper_loss += by_hand;
  return true;
}
