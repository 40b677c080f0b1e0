/* SPDX-License-Identifier: MIT */
/* What is in play on the heads: strikers and damping hands, in a fixed pool, and the mufflers, hands that
 * stay where the definition puts them. Audio-safe.
 *
 * A striker is its effective tip mass M, free but for the contact: M z_tt = f, [Torin2014] eq. (5);
 * no gravity, since a hand carries the stick. It starts touching the head's momentary surface with
 * exactly the speed asked for, so the energy it brings is M v^2/2. It is taken away once it moves
 * off beyond 5 mm, or touches nothing a second after the stroke.
 *
 * A striker that a hand presses moves as M z_tt = f - F0 - kh (z - z0) - ch z_t, damper centred, z0
 * where the hand took hold; it bounces, and stays until it is released or leaps 50 mm off, out of the
 * hand. The hand's work is injected energy. Strikers pass the wires by: they meet the head alone. */
#ifndef TB_SLOTS_H
#define TB_SLOTS_H

#include "state.h"

/* Places a stroke; false if the pool is full of strikers in contact. */
bool tb_slots_strike(TbView *view, uint32_t id, uint32_t striker, double velocity, double radius,
                     double angle);
/* Lays a hand of `strength` [N s/m] on the head, or moves the one with this id. */
bool tb_slots_damp(TbView *view, uint32_t id, double strength, double radius, double angle);
/* Presses the strikers with this id, or all for 0, pressure 0 to 1; false if none is in play. */
bool tb_slots_press(TbView *view, uint32_t id, double pressure);
/* Height of a striker at the next instant without contact force. */
double tb_slots_free_height(const TbView *view, uint32_t slot);
/* Work [J] of the hands on the pressed strikers in the step from view->last to view->next. */
double tb_slots_hand_work(const TbView *view);
/* Lays on, adjusts or lifts the mufflers as their live strengths say. */
void tb_slots_muffle(TbView *view);
/* Takes away strikers and hands with this id, or all for 0; mufflers stay. */
void tb_slots_release(TbView *view, uint32_t id);
/* Takes away strikers that are done; call once per sample after the rotation. */
void tb_slots_retire(TbView *view);
/* Recomputes law, shape and coupling of a slot from its description, as after a swap. */
void tb_slots_rebuild(TbView *view, uint32_t slot);

#endif
