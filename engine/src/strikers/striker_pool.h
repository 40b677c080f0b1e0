/* SPDX-License-Identifier: MIT */
/* The striker pool: a fixed number of places ("slots") for strikers and damping hands, and for the
 * mufflers, which are hands that stay where the definition puts them. Audio-safe.
 *
 * A striker is its effective tip mass M, free apart from the contact: M z_tt = f, [Torin2014] eq.
 * (5); no gravity, since a hand carries the stick. It starts in touch with the head's momentary
 * surface at exactly the requested speed, so the energy that it brings is M v^2/2. It is removed
 * once it moves away beyond 5 mm, or touches nothing a second after the stroke.
 *
 * A hand may press it: see striker_hold.h. Strikers do not collide with wires.
 * stick.h describes a stick on the hoop, or on hoop and head, and the hand that presses the shaft
 * of a cross-stick. */
#ifndef TB_STRIKER_POOL_H
#define TB_STRIKER_POOL_H

#include "state/state.h"

/* A requested stroke, within range. */
typedef struct TbStroke {
  uint32_t id, striker;
  uint32_t technique; /* a TaborTechnique */
  double velocity, radius, angle;
  double pressure; /* of a buzz or a sweep, 0 to 1 */
} TbStroke;

/* Displacement of head or hoop at a slot's place with the modes at q [m]. */
double tb_pool_displacement(const TbView *view, uint32_t slot, const double *q);
/* Adds to the penetrations of slots in play, with this sign, what these feel of the modes. */
void tb_pool_add_displacements(const TbView *view, double sign, const TbPhase *phase);
/* Adds to q what a force at a slot's place [N] does there in one step. */
void tb_pool_push(const TbView *view, uint32_t slot, double force, double *q);
/* Adds, adjusts or lifts the mufflers according to their live strengths. */
void tb_pool_muffle(TbView *view);
/* Removes strikers that are done. Call once per sample after the rotation. */
void tb_pool_retire(TbView *view);
/* Puts a striker with this description, and its shape and law, into a free slot, `above` [m] over
 * the surface, and books its energy. */
void tb_pool_put(TbView *view, uint32_t slot, const TbSlot *striker, double above);
/* Puts a stick that touches head and hoop into two free slots, its shaft `above` [m] over the hoop,
 * and books its energy. */
void tb_pool_put_pair(TbView *view, const uint32_t pair[2], const TbSlot *tip, const TbSlot *shaft,
                      double above);
/* Puts a damping hand with this description into a slot. */
void tb_pool_put_hand(TbView *view, uint32_t slot, const TbSlot *hand);
/* Returns a free slot. If none is free, it frees that of the oldest striker that has sounded and
 * touches nothing any more. Returns TB_SLOTS if there is no such striker. */
uint32_t tb_pool_obtain(TbView *view);
/* Frees a slot and that of the stick's other end. The striker's remaining energy is booked as
 * removed. */
void tb_pool_take_away(TbView *view, uint32_t slot);
/* True if the striker has touched the head or the hoop, with either end. */
bool tb_pool_sounded(const TbView *view, uint32_t slot);
/* True if the striker touches the head or the hoop, with either end. */
bool tb_pool_touches(const TbView *view, uint32_t slot);
/* Energy that a striker's contact stores between two instants [J]. */
double tb_pool_contact_energy(const TbView *view, uint32_t slot, const TbPhase *next,
                              const TbPhase *now);
/* Raises the head's surface under a striker by `by` [m]; the work is a hand's. */
void tb_pool_raise(TbView *view, uint32_t slot, double by);
/* Moves a striker to another place on the head; the work is a hand's. */
void tb_pool_draw(TbView *view, uint32_t slot, double radius, double angle);
/* Recomputes law, shape and coupling of a slot from its description, as after a swap. */
void tb_pool_rebuild(TbView *view, uint32_t slot);

/* Call before something pushes the modes where shape[padded] is not 0, NULL: all; those that
 * mufflers push move with them. Call tb_coupling_renew() after what pushes them is in place. */
void tb_pool_wake(TbView *view, const double *shape);
/* Call after modes have come to rest (moving_modes.h): mufflers move fewer. tb_coupling_renew() is
 * to follow. */
void tb_pool_yield_anew(TbView *view);

#endif
