/* SPDX-License-Identifier: MIT */
/* Brushes: a hand slaps a fan of wires onto the head, or draws the fan over the coating.
 *
 * About a hundred light wires each press on their own place of the head. They are gathered in
 * TB_BRISTLE_GROUPS groups. Each group is a striker with its own patch of the head and its own slot
 * (a place in the striker pool), and has an equal part of the brush's mass M, contact stiffness K
 * and hand. While the n wires of a group follow the head together, each with 1/n of the group's
 * mass and contact on a track h_i, they act as one wire on the mean of their tracks. For K linear,
 *   Sum_i (K/n) (w + h_i - z_i) = K (w + mean h - mean z).
 * Tracks are independent, so the standard deviation of the mean is that of one track over sqrt(n).
 * The forces that the coating causes are independent between groups. Wires end at scattered
 * heights: of n springs k whose ends are spread evenly over a depth D, n eta/D touch, and f = n k
 * eta^2/(2 D); hence a brush's usual exponent of 2.
 *
 * The coating: penetration eta = w + d + h(s) - z, with s the distance that the wires have slid
 * (head_coating.h). In every sample, before the step, h moves by dh. This shifts eta of both
 * instants by dh. The change of the contact's potential, (V(eta + dh) - V(eta))/2 summed over the
 * instants, is work of the hand that draws the brush (injected). Friction adds nothing else: its
 * force along the head moves nothing that this model hears.
 *
 * Position of a group: wires stick to the head, then slip on. A group stays at a place while its
 * brush moves by a stride. The stride is random around STRIDE, or at high speed around the distance
 * travelled in STRIDE_TIME. The group then takes its shape on the head from its next place; modes
 * and tip continue unchanged, and the change of the contact's potential is work of the hand as
 * well. Strides are random and independent between groups; otherwise they would sound as a tone.
 *
 * The wires behind their ends: a long wire pushed at its end radiates bending waves away from it,
 * with the impedance
 *   Z = EI k^3 (1 + i)/(2 omega), k^4 = rho A omega^2/EI
 * (w = A (e^{-ikx} + e^{-kx}), so that w_xx = 0 at the end, and f = EI w_xxx). For 0.3 mm of steel,
 * EI = 8e-5 N m2 and rho A = 5.6e-4 kg/m, Z at 1 kHz is a resistance of 0.0135 N s/m and an equal
 * mass reactance, 2 mg. Both vary slowly: the resistance grows and the mass falls with the square
 * root of the frequency. The resistance acts beside the hand's damper; the mass is the striker's.
 * The resistance mutes the head as a brush that lies on it does. In a slap the bending waves arrive
 * with the wires' speed v and push with Z v until they have run up and down the wire; then the hand
 * lifts the brush.
 *
 * The hand: force F0, spring and damper of striker_pool.h, an equal part for each group. F0 follows
 * the pressure within some milliseconds. The hand circles the drum's centre until a move is
 * requested. It then follows the moves, smoothed as by a mass on a critically damped spring,
 * p_tt = (P - p)/T^2 - 2 p_t/T. A slap spreads the wires: for a short time they slide over the
 * coating at a fraction of the stroke's speed.
 *
 * Chosen, not measured: the coating's height and grain, strides, splay, slant. Limits: at speed 0
 * the brush is a light striker that rests on the head, which falls silent; at pressure 0 it still
 * presses with 0.3 N; without losses the wires have no resistance and add only their mass.
 * Audio-safe. */
#ifndef TB_BRUSH_H
#define TB_BRUSH_H

#include "strikers/striker_pool.h"

/* Slaps with a brush, or begins a sweep. Returns false if both brushes are in use. */
bool tb_brush_strike(TbView *view, const TbStroke *stroke);
/* Moves the brushes with this id (0: all) to `radius`, `angle` within `seconds`, the shorter way
 * round. `seconds` 0: the move takes as long as the time since the last move. Returns false if
 * there are no such brushes. */
bool tb_brush_move(TbView *view, uint32_t id, double radius, double angle, double seconds);
/* Presses the brushes with this id (0: all). Returns false if there are none. */
bool tb_brush_press(TbView *view, uint32_t id, double pressure);
/* Lifts the brushes with this id (0: all). */
void tb_brush_release(TbView *view, uint32_t id);
/* Moves the brushes by one sample. Call before the step. */
void tb_brush_step(TbView *view);
/* Brushes in play. */
uint32_t tb_brush_count(const TbState *state);
/* Continues the brushes of a drum on another one, whose steps are `ratio` times as long. */
void tb_brush_carry(const TbView *from, TbView *to, double ratio);
/* True if a hand moves some brush, or is about to. */
bool tb_brush_moves(const TbState *state);

#endif
