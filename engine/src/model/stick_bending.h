/* SPDX-License-Identifier: MIT */
/* The stick: a tapered beam of length L = 0.4 m, and how it bends in a hand.
 *
 * The diameter is d from the butt on and falls over the last fifth, evenly, to d/2 at the tip. With
 * x from the tip, mu = mass per length ~ diameter^2, and bending stiffness B ~ diameter^4, the beam
 * obeys mu w_tt + (B w_xx)_xx = f with free ends [Rayleigh1877]. Its modes are those of the Ritz
 * method: w is a sum of the first 16 Legendre polynomials, so
 *   K_ij = Int B P_i'' P_j'' dx,  M_ij = Int mu P_i P_j dx.
 * A hand adds a point mass, which combines these modes. Constant and slope are among the
 * polynomials: the first two modes are exactly the rigid motions, whose C (stick.h) follows
 * from the moments of mass. The next three are bending modes of unit mass,
 *   x_i'' + 2 s x_i' + w_i^2 x_i = phi_i(x) f,  height = rigid height + Sum phi_i x_i,
 * in the recursion of modes.h. Frequencies are within 0.2 % and phi^2 within 1 % of a finite
 * element calculation (tests/reference/sticks.json).
 *
 * The definition gives the mass M that the stick has at its tip, a fifth of its own, and the lowest
 * frequency of the free stick. For hickory, 790 kg/m3 and 15 GPa, the beam equation gives:
 *        length   diameter  mass   M        lowest
 *   7A   394 mm   13.7 mm   42 g   8.4 g    387 Hz
 *   5A   406 mm   14.4 mm   48 g   9.5 g    383 Hz
 *   5B   406 mm   15.1 mm   53 g   10.5 g   402 Hz
 *   2B   413 mm   16.0 mm   60 g   12.0 g   412 Hz
 *
 * There are three grips:
 * - held: 30 g of fingers at the centre of percussion as seen from the tip, two thirds along, where
 *   drummers hold a stick because no blow is felt there. So fingers change nothing at the tip of a
 *   stiff stick, which weighs M with or without them. They lower the lowest mode by 9 % and the
 *   next by 16 %.
 * - free: no hand, in a rimshot, where the whole stick comes down.
 * - across: in a cross-stick, a hand and its part of the arm, 1 kg, hold the stick 75 mm from its
 *   tip.
 * The 30 g are an estimate, as is the damping by the hand, 100/s. Mass and place of the hand across
 * were fitted to recorded cross-sticks, within 0.2 to 1 kg and 0 to 90 mm.
 *
 * Modes faster than 0.35 of the sample rate have that frequency and their own static compliance. So
 * for an infinite frequency nothing is left of them, and a definition with 0 Hz has none: then the
 * stick is the plain striker of mass M.
 *
 * Bending makes the sound of a rimshot: when the hoop stops the shaft, the tip of a stiff rod is
 * thrown off the head at once, while the tip of a real stick whips on into the head. In a plain
 * stroke the head's blow bends the stick, which gives a part of it back within the contact. */
#ifndef TB_STICK_BENDING_H
#define TB_STICK_BENDING_H

#include "definition/params.h"
#include "math/arena.h"

#define TB_BENDS 3u
#define TB_STICK_CELLS 128u

typedef enum TbGrip { TB_GRIP_HELD, TB_GRIP_FREE, TB_GRIP_ACROSS, TB_GRIPS } TbGrip;

/* A stick in one grip. The moments are Int dm, Int x dm, Int x^2 dm, hand included. */
typedef struct TbStickBody {
  double mass, first, second;                   /* [kg], [kg m], [kg m2] */
  double a[TB_BENDS], b[TB_BENDS], g[TB_BENDS]; /* the recursion: see modes.h; 0: no such mode */
  double stiffness[TB_BENDS], loss[TB_BENDS];
  double shape[TB_BENDS][TB_STICK_CELLS + 1u]; /* phi [kg^-1/2], from the tip on */
} TbStickBody;

typedef struct TbStick {
  TbStickBody grip[TB_GRIPS];
} TbStick;

extern const double tb_stick_length; /* L [m] */

/* Prepares a stick for each striker of the definition. Returns false if memory ran out. Set-up
 * only. */
bool tb_sticks_prepare(TbStick *sticks, TbArena *scratch, const TaborDrumDef *def,
                       double time_step);

/* All below is audio-safe; arrays are [TB_BENDS]. */

/* phi[] at `along` [m] from the tip, up to L, by linear interpolation in the table. */
void tb_stick_shape(const TbStickBody *body, double along, double *phi);
/* Converts the two instants of a motion from the coefficients of `from` to those of `to`, keeping
 * phase and action (swap.c). */
void tb_stick_carry(const TbStickBody *from, const TbStickBody *to, double ratio, double *now,
                    double *last);

#endif
