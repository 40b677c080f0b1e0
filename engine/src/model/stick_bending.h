/* SPDX-License-Identifier: MIT */
/* Bending of a stick: the first modes of a uniform beam, of length L and mass m. The beam is free
 * at both ends, or pinned at its tip where fingers hold the tip [Rayleigh1877]:
 *   free:   psi = cosh u + cos u - s (sinh u + sin u), s = (sinh b + sin b)/(cosh b - cos b),
 *     cos b cosh b = 1,
 *   pinned: psi ~ sin u + (sin b/sinh b) sinh u, tan b = tanh b,
 * u = b x/L, x from the tip, Int psi^2 dx = L, so each mode has the mass m. Frequencies go with
 * b^2; the lowest of a free 7A of hickory (E = 15 GPa, 820 kg/m3, 13.2 mm thick, 0.4 m) is 320 Hz.
 * The hand that holds the stick damps the modes.
 *
 * Bending makes the sound of a rimshot: when the hoop stops the shaft, the tip of a stiff rod is
 * thrown off the head at once, while the tip of a real stick whips on into the head. */
#ifndef TB_STICK_BENDING_H
#define TB_STICK_BENDING_H

#include <stdbool.h>
#include <stdint.h>

#define TB_BENDS 3u
#define TB_STICK_CELLS 128u

typedef struct TbBends {
  double a[TB_BENDS], b[TB_BENDS], g[TB_BENDS]; /* the recursion: see modes.h */
  double stiffness[TB_BENDS], loss[TB_BENDS];
  double shape[TB_BENDS][TB_STICK_CELLS + 1u]; /* psi, from the tip on */
} TbBends;

typedef struct TbStickBending {
  TbBends free, pinned;
} TbStickBending;

extern const double tb_stick_bending_length; /* L [m] */

/* Set-up only. */
void tb_stick_bending_prepare(TbStickBending *stick, double time_step, bool losses);
/* psi[] at `along` [m] from the tip, up to L, by linear interpolation in the table. Audio-safe. */
void tb_stick_bending_shape(const TbBends *bends, double along, double *psi);

#endif
