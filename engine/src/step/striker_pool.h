/* SPDX-License-Identifier: MIT */
/* What is in play on the heads: strikers and damping hands, in a fixed pool, and the mufflers, hands that
 * stay where the definition puts them. Audio-safe.
 *
 * A striker is its effective tip mass M, free but for the contact: M z_tt = f, [Torin2014] eq. (5);
 * no gravity, since a hand carries the stick. It starts touching the head's momentary surface with
 * exactly the speed asked for, so the energy it brings is M v^2/2. It is taken away once it moves
 * off beyond 5 mm, or touches nothing a second after the stroke.
 *
 * A striker that a hand presses moves as M z_tt = f - 2 g (F0 + kh (z - z0) + ch z_t), damper centred, g
 * the grip, z0 where the hand took hold; it bounces, and stays until it is released or leaps 0.2 m off,
 * out of the hand. Released on the head it is lifted: in 8 ms the force F0 becomes a pull of 2 N, and off it goes. What
 * force and spring do is injected energy, what the damper takes is lost. g = 0 is
 * a free rebound. A hand holds one stick: a stroke takes away the pressed one with its id. Held at a
 * distance p from its butt, a rod of length L and mass m weighs m (1/12 + (1/2 - p/L)^2)/(1 - p/L)^2 at
 * its tip. Strikers pass the wires by. On the hoop, or on both, a stick is as stick_rigid.h says, and no hand presses it. */
#ifndef TB_STRIKER_POOL_H
#define TB_STRIKER_POOL_H

#include "step/state.h"

/* A stroke as asked for, within range. */
typedef struct TbStroke {
  uint32_t id, striker;
  uint32_t technique; /* a TaborTechnique */
  double velocity, radius, angle;
  double pressure; /* of a buzz or a sweep, 0 to 1 */
} TbStroke;

/* Height of a striker at the next instant without contact force. */
double tb_pool_free_height(const TbView *view, uint32_t slot);
/* What the hands do to pressed strikers in the step from view->last to view->next [J]. */
typedef struct TbHandWork {
  double done, lost; /* by force and spring, in the damper and by sticks that bend in them */
} TbHandWork;
TbHandWork tb_pool_hand_work(const TbView *view);
/* After the grip has changed. */
void tb_pool_regrip(TbView *view);
/* Lays on, adjusts or lifts the mufflers as their live strengths say. */
void tb_pool_muffle(TbView *view);
/* Takes away strikers that are done; call once per sample after the rotation. */
void tb_pool_retire(TbView *view);
/* Puts a striker of this description, with its shape and law, into a free slot, `above` [m] the surface, and books
 * its energy. */
void tb_pool_put(TbView *view, uint32_t slot, const TbSlot *striker, double above);
/* The same for a stick that touches head and hoop, the shaft `above` the latter. */
void tb_pool_put_pair(TbView *view, const uint32_t pair[2], const TbSlot *tip, const TbSlot *shaft,
                      double above);
/* Puts a damping hand of this description into a slot. */
void tb_pool_put_hand(TbView *view, uint32_t slot, const TbSlot *hand);
/* A free slot, if need be that of the oldest striker which touches nothing; TB_SLOTS if none. */
uint32_t tb_pool_obtain(TbView *view);
/* Frees a slot, and that of the stick's other end; what a striker still carries is booked as removed. */
void tb_pool_take_away(TbView *view, uint32_t slot);
/* A hand takes hold of a striker, or changes the force F0 [N]. */
void tb_pool_hold(TbView *view, uint32_t slot, double force);
/* F0 of a pressure of 0 to 1 [N]. */
double tb_pool_press_force(double pressure);
/* True if it touches the head or the hoop, with either end. */
bool tb_pool_touches(const TbView *view, uint32_t slot);
/* The head under a striker comes up by `by` [m], which some hand does. */
void tb_pool_raise(TbView *view, uint32_t slot, double by);
/* A hand draws a striker on to another place. */
void tb_pool_draw(TbView *view, uint32_t slot, double radius, double angle);
/* Recomputes law, shape and coupling of a slot from its description, as after a swap. */
void tb_pool_rebuild(TbView *view, uint32_t slot);

#endif
