/* SPDX-License-Identifier: MIT */
#include "heads/moving_modes.h"

#include <math.h>
#include <string.h>

#include "air/incident_sound.h"

/* Fewer modes more at rest are not worth the look at everything that sums over modes. */
static const uint32_t WORTH = 64;

static bool moves(const double *shape, uint32_t from, uint32_t end) {
  for (uint32_t i = from; i < end; i++) {
    if (shape[i] != 0.0) return true;
  }
  return false;
}

/* Modes that mix push their kin. */
bool tb_moving_wake(TbView *view, const double *shape) {
  const TbParts *parts = &view->model->stretch.parts;
  uint32_t *moving = view->state->moving;
  bool pushed[TB_MODE_PARTS], kin[TB_MODE_PARTS] = {true}, woken = false;
  for (uint32_t part = 0; part < parts->count; part++) {
    pushed[part] = !shape || moves(shape, parts->from[part], parts->end[part]);
    if (pushed[part]) kin[parts->kin[part]] = true;
  }
  for (uint32_t part = 0; part < parts->count; part++) {
    const uint32_t all = parts->end[part] - parts->from[part];
    const uint32_t mixed = kin[parts->kin[part]] ? parts->mixed[part] : 0u;
    const uint32_t least = pushed[part] ? all : mixed;
    if (moving[part] >= least) continue;
    moving[part] = least;
    woken = true;
  }
  if (woken) tb_view_move(view);
  return woken;
}

/* ---- coming to rest -------------------------------------------------------------------------- */

static bool is_quiet(const TbView *view, uint32_t from) {
  const double most = view->model->resting.most[from / 8u];
  for (uint32_t i = from; i < from + 8u; i++) {
    if (fabs(tb_mode_energy(view, i)) > most) return false;
  }
  return true;
}

/* How many modes of a part still move. */
static uint32_t left_of(const TbView *view, uint32_t part) {
  const uint32_t from = view->model->stretch.parts.from[part];
  const uint32_t floor = view->model->resting.floor[part];
  uint32_t left = view->state->moving[part];
  while (left > floor && is_quiet(view, from + left - 8u)) left -= 8u;
  return left;
}

static void stop(TbView *view, uint32_t from, uint32_t end) {
  double *const arrays[] = {view->now.q, view->last.q, view->next.q};
  const size_t bytes = (end - from) * sizeof(double);
  for (uint32_t i = from; i < end; i++)
    view->state->ledger.sums.head_loss += tb_mode_energy(view, i);
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) memset(arrays[i] + from, 0, bytes);
  for (uint32_t h = 0; h < view->model->stretch.count; h++) {
    memset(view->stretch.pull[h] + from, 0, bytes);
  }
}

/* Without losses nothing dies away. */
static bool goes_on(const TbView *view) {
  if (!view->model->def.quality.losses) return true;
  if (tb_incident_pushes_all(view) || view->state->plate.part > 0.0) return true;
  return tb_slots_play(view);
}

bool tb_moving_rest(TbView *view) {
  const TbParts *parts = &view->model->stretch.parts;
  uint32_t left[TB_MODE_PARTS], more = 0;
  bool is_least = true;
  if (goes_on(view)) return false;
  for (uint32_t part = 0; part < parts->count; part++) {
    left[part] = left_of(view, part);
    more += view->state->moving[part] - left[part];
    is_least = is_least && left[part] == view->model->resting.floor[part];
  }
  if (more == 0 || (more < WORTH && !is_least)) return false;
  for (uint32_t part = 0; part < parts->count; part++) {
    const uint32_t from = parts->from[part];
    stop(view, from + left[part], from + view->state->moving[part]);
    view->state->moving[part] = left[part];
  }
  tb_view_move(view);
  return true;
}
