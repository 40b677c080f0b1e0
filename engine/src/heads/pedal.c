/* SPDX-License-Identifier: MIT */
#include "heads/pedal.h"

#include "heads/mode_force.h"

static TbLiveParam *opening(TbView *view) { return &view->state->live.values[TB_LIVE_OPENING]; }

/* As fast as it may. */
static void move_to(TbView *view, double target) { tb_live_move(opening(view), target, 1); }

static void fall(TbView *view) {
  view->state->live.stamp.phase = TB_STAMP_FALLS;
  move_to(view, view->model->def.hihat.closed);
}

bool tb_pedal_stamp(TbView *view, double speed) {
  if (view->model->rod.count == 0) return false;
  const TaborHihatDef *hihat = &view->model->def.hihat;
  view->state->live.stamp = (TbStamp){speed < hihat->speed ? speed : hihat->speed, TB_STAMP_LIFTS};
  if (opening(view)->now < hihat->lift) {
    move_to(view, hihat->lift);
  } else {
    fall(view);
  }
  return true;
}

double tb_pedal_speed(const TbView *view) {
  const TbStamp *stamp = &view->state->live.stamp;
  return stamp->phase == TB_STAMP_FALLS ? stamp->speed : view->model->def.hihat.speed;
}

void tb_pedal_follow(TbView *view) {
  TbStamp *stamp = &view->state->live.stamp;
  if (opening(view)->left > 0) return;
  if (stamp->phase == TB_STAMP_LIFTS) {
    fall(view);
  } else {
    stamp->phase = TB_STAMP_NONE;
  }
}

bool tb_stamp_is_right(const TbStamp *stamp) {
  return stamp->phase <= TB_STAMP_FALLS && stamp->speed >= 0.0 && stamp->speed <= 30.0;
}

void tb_pedal_push(TbView *view) {
  tb_mode_force_push(view, &view->model->rod, tb_pedal_risen(view));
}

double tb_pedal_product(const TbView *view, const double *pull) {
  return tb_pedal_risen(view) * tb_mode_force_along(&view->model->rod, pull);
}

double tb_pedal_work(const TbView *view) {
  return tb_pedal_risen(view) * tb_mode_force_way(view, &view->model->rod);
}
