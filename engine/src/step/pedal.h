/* SPDX-License-Identifier: MIT */
/* The pedal of a hi-hat: the live parameter hihat.opening moves the foot of the spring on which the
 * upper plate bounces (model/rims.h), at hihat.speed at most. What it differs by from its place at
 * rest is a force on the modes, constant over a step, whose work F (q+ - q-)/2 is control energy.
 * Audio-safe. */
#ifndef TB_PEDAL_H
#define TB_PEDAL_H

#include "state/state.h"

/* True if the pedal is where the definition has it. */
bool tb_pedal_rests(const TbView *view);
/* Adds the pedal's force to the free motion in view->next. */
void tb_pedal_push(TbView *view);
/* Its work in the step to view->next [J]. */
double tb_pedal_work(const TbView *view);

#endif
