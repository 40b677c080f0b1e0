/* SPDX-License-Identifier: MIT */
/* The hand that presses a striker. Audio-safe. The striker moves as M z_tt = f - 2 g (F0 + kh (z -
 * z0) + ch z_t), with the damper centred, g the grip, and z0 the height at which the hand took
 * hold. It bounces, and stays until it is released or leaps 0.2 m off, out of the hand. A striker
 * released on the head is lifted: within 30 ms the force F0 becomes a pull of 0.5 N. The work of
 * force and spring is injected energy; the damper's is lost. g = 0 is a free rebound. A hand holds
 * one stick: a stroke removes the pressed stick with its id. Held at a distance p from its butt, a
 * rod of length L and mass m weighs m (1/12 + (1/2 - p/L)^2)/(1 - p/L)^2 at its tip. */
#ifndef TB_STRIKER_HOLD_H
#define TB_STRIKER_HOLD_H

#include "state/state.h"

/* A hand takes hold of a striker, or changes the force F0 [N]. */
void tb_hold(TbView *view, uint32_t slot, double force);
/* A hand lifts the stick that it presses: not at once, or what it has bent would snap back. Nobody
 * finds it by its id any more. */
void tb_hold_lift(TbView *view, uint32_t slot);
/* F0 [N] for a pressure of 0 to 1. */
double tb_hold_force(double pressure);
/* One sample of lifting: the pressing force goes, the pulling one comes. */
void tb_hold_pull_up(const TbView *view, uint32_t slot);
/* How long this takes [s]. */
extern const double tb_hold_lift_time;
/* Displacement of a striker in one step by a unit force on itself, hand included [m/N]. */
double tb_hold_compliance(const TbView *view, uint32_t slot);
/* Height of a striker at the next instant without contact force. */
double tb_hold_free_height(const TbView *view, uint32_t slot);
/* Work of the hands on pressed strikers in the step from view->last to view->next [J]. */
typedef struct TbHoldWork {
  double done, lost; /* by force and spring; in the damper and in sticks that bend */
} TbHoldWork;
TbHoldWork tb_hold_work(const TbView *view);
/* Call after the grip has changed. */
void tb_hold_regrip(TbView *view);

#endif
