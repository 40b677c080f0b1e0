/* SPDX-License-Identifier: MIT */
/* The pedal of a hi-hat: the live parameter hihat.opening moves the foot of the spring on which the
 * upper plate bounces (model/rims.h), at hihat.speed at most. The foot's distance from its place at
 * rest is a force on the modes, constant over a step, whose work F (q+ - q-)/2 is control energy.
 * Audio-safe. */
#ifndef TB_PEDAL_H
#define TB_PEDAL_H

#include "state/state.h"

/* The foot's stroke: it lifts the rod to hihat.lift if that is higher, then brings it down to
 * hihat.closed at this speed [m/s]. False without a hi-hat. */
bool tb_pedal_stamp(TbView *view, double speed);
/* The rod is no faster than this now [m/s]. */
double tb_pedal_speed(const TbView *view);
/* Call when the rod has moved: a foot that has lifted it comes down. */
void tb_pedal_follow(TbView *view);
/* Whether it may be a drum's, as read from a state. */
bool tb_stamp_is_right(const TbStamp *stamp);

/* True if the pedal is where the definition has it, or there is none. */
static inline bool tb_pedal_rests(const TbView *view) {
  return view->model->rod.count == 0 || tb_pedal_risen(view) == 0.0;
}
/* Adds the pedal's force to the free motion in view->next. */
void tb_pedal_push(TbView *view);
/* y g F of the pedal's force, from y g = pull[padded]. */
double tb_pedal_product(const TbView *view, const double *pull);
/* Its work in the step to view->next [J]. */
double tb_pedal_work(const TbView *view);

#endif
