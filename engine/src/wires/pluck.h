/* SPDX-License-Identifier: MIT */
/* Fingers that pluck wires: each pulls one wire at one place away from the head, ever harder, and
 * lets go.
 *
 * The force is F(t) = F0 (1 - cos(pi t/t0))/2 up to t0, then 0. F0 is the force that holds the wire
 * at the displacement d if it touches nothing: d/C, with the compliance at x of a stiff string of
 * length L under the tension T, hinged at its ends,
 *
 *   C = x (L - x)/(T L) - sinh(a x) sinh(a (L - x))/(a T sinh(a L)), a = (T/EI)^(1/2).
 *
 * Limits: EI -> 0 leaves the first term, and after a slow pull the wire is a triangle [Morse1948];
 * T -> 0 leaves that of a beam, x^2 (L - x)^2/(3 EI L), which is used below a L = SLACK, where the
 * difference of the two terms is rounded. A place between two nodes pulls both in proportion. The
 * work of a step, F (v(n+1) - v(n-1))/2, is booked as injected. Audio-safe. */
#ifndef TB_PLUCK_H
#define TB_PLUCK_H

#include "state/state.h"

/* Begins to pull a wire at the part `place` of its length, 0 to 1, to the displacement d [m]; lets
 * go after `time` [s]. A wire has one finger: a pluck ends the one before. Returns false if there
 * is no such wire. */
bool tb_pluck(TbView *view, uint32_t wire, double place, double displacement, double time);
/* True if a finger pulls. */
bool tb_pluck_acts(const TbState *state);
/* Adds what the fingers do to the wires' free motion in view->next. */
void tb_pluck_pull(TbView *view);
/* Work that they do in this step [J]. Call after view->next is filled. */
double tb_pluck_work(const TbView *view);
/* The step is over: fingers that are done let go. */
void tb_pluck_follow(TbView *view);

/* Checks, one every 64 steps, in which no wire may be far from rest before plucked wires count as
 * calm: a string that swings is flat twice a period. Until then heads stretch (heads/stretch.h),
 * since such a wire may slap its head like a stick. */
#define TB_FLUNG 32u
/* A check. */
void tb_pluck_calm(TbView *view);

#endif
