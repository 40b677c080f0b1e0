/* SPDX-License-Identifier: MIT */
/* Brushes: a hand slaps a fan of wires onto the head, or draws it over the coating.
 *
 * Some hundred light wires press, each by itself, on as many places of the head. They are gathered in
 * TB_BRISTLE_GROUPS groups, each a striker of its own on its own patch and in its own slot, with an equal part of
 * the brush's mass M, contact K and hand. n wires of one group, each with 1/n of its mass and contact on a track
 * h_i of its own, add up to one on the mean of their tracks while they follow the head together: for K linear,
 *   Sum_i (K/n) (w + h_i - z_i) = K (w + mean h - mean z).
 * Tracks are independent, so the mean's spread is that of one over sqrt(n); the groups' forces, too, are
 * independent where the coating makes them. Wires end at scattered heights: of n
 * springs k whose ends are spread evenly over a depth D, n eta/D touch, and f = n k eta^2/(2 D); hence a brush's usual
 * exponent of 2.
 *
 * What the coating does: penetration eta = w + d + h(s) - z, s the way that the wires have come (head_coating.h). In every
 * sample, before the step, h moves by dh: eta of both instants goes on by that, and what this makes of the contact's
 * potential, (V(eta + dh) - V(eta))/2 summed over the instants, is work of the hand that draws the brush (injected).
 * Friction does no more: its force along the head moves nothing that this model hears.
 *
 * Where a group is: wires stick to where they are, and slip on. A group stays on a place while its brush moves by a
 * stride, drawn around STRIDE (at high speeds what STRIDE_TIME lets it come), and then its shape on the head
 * is that of its next place; modes and tip go on as they were, and the change of the contact's potential is
 * the hand's work as well. Strides are random and the groups' are independent, or they would be a tone.
 *
 * The wires behind their ends: a long wire answers a push at its end by the waves of bending that it sends away,
 *   Z = EI k^3 (1 + i)/(2 omega), k^4 = rho A omega^2/EI
 * (w = A (e^{-ikx} + e^{-kx}), so that w_xx = 0 at the end, and f = EI w_xxx). Of 0.3 mm of steel, EI = 8e-5 N m2 and
 * rho A = 5.6e-4 kg/m, that is a resistance of 0.0135 N s/m at 1 kHz and as much of mass, 2 mg; both change slowly, with the
 * square root of the frequency and against it. The resistance stands beside the hand's damper; the mass is the
 * striker's. It mutes the head as a brush that lies on it does. In a slap the waves come down with the wires' speed v, and
 * push by Z v until they have run up and down the wire; then the hand lifts the brush.
 *
 * The hand: force F0, spring and damper of striker_pool.h, a group's part each; F0 follows the pressure within some
 * milliseconds. It goes around the drum's centre until it is told to move; then it goes where the moves say, its
 * way smoothed as by a mass on a critically damped spring, p_tt = (P - p)/T^2 - 2 p_t/T. A slap spreads the
 * wires: they slide over the coating at a part of the speed of the stroke, which is over soon.
 *
 * Chosen, not measured: the coating's height and grain, strides, splay, slant. Limits: speed 0 leaves a light striker
 * that rests on the head, which falls silent; pressure 0 still presses with 0.3 N; without losses wires have no
 * resistance and bring nothing but their mass.
 * Audio-safe. */
#ifndef TB_BRUSH_H
#define TB_BRUSH_H

#include "step/striker_pool.h"

/* Slaps with a brush, or begins a sweep; false if both brushes are in use. */
bool tb_brush_strike(TbView *view, const TbStroke *stroke);
/* Where the brushes with this id, or all for 0, shall be `seconds` from now, the shorter way round; 0: in as long as
 * since the last move. False if there are none. */
bool tb_brush_move(TbView *view, uint32_t id, double radius, double angle, double seconds);
/* Presses the brushes with this id, or all for 0; false if there are none. */
bool tb_brush_press(TbView *view, uint32_t id, double pressure);
/* Lifts the brushes with this id, or all for 0. */
void tb_brush_release(TbView *view, uint32_t id);
/* Draws the brushes on by one sample; call before it. */
void tb_brush_step(TbView *view);
/* A hand moves some brush, or is about to. */
bool tb_brush_moves(const TbState *state);

#endif
