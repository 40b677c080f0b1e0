/* SPDX-License-Identifier: MIT */
/* Energy that wires in contact take from the high band's modes.
 *
 * A high mode moves the head under the wires, but the contact solve does not see this motion
 * (high_band.h). In fact wires follow it, and bounce from it, and so damp it. Three things decide
 * by how much, for a wave of frequency omega and wavenumber k whose component along the wire is kx:
 *
 * 1. A touched wire follows. Contact and wire are in series; per length, with the force f,
 *      1/Z = 1/(lambda f + kappa/(i omega)) + 1/Z_w,  kappa = a K^(1/a) f^(1 - 1/a),
 *      Z_w = i omega mu + (T kx^2 + EI kx^4)/(i omega) + mu (sigma0 + sigma1 kx^2).
 *    Around it the head yields with the line mobility of an infinite membrane,
 *      Y = omega/(2 ky (T_h + 2 D k^2)), ky^2 = k^2 - kx^2,
 *    so a wave of velocity v loses Re Z/|1 + Y Z|^2 v^2: C(omega, f), a mean over all directions.
 *    (A wire that could not move would take lambda f. But a snare's mass resonates with its contact
 *    at some 6 kHz; below, the wire follows and takes next to nothing.)
 * 2. A wire that bounces lands harder on a head that comes to meet it. If it lands with the speed
 *    u, the impulse grows by the fraction v/u, which makes a resistance f/u. That holds for waves
 *    slow against the contact. In a contact that lasts half a period of its resonance, omega_r^2 =
 *    kappa/mu, faster waves see the spectrum of a half sine, with x = omega/omega_r:
 *      D = (f/u) S,  S = (cos(pi x/2)/(1 - x^2))^2,
 *    and lose D/(1 + Y D)^2. Points that touch all the time do not bounce; of N points, those that
 *    touch, n, do so for the part n/N of the time, and 1 - n/N is left for bounces.
 * 3. Waves bring no more than flows into the bed. In a diffuse field that is the part c_g/pi per
 *    length of the bed's perimeter P and energy per area, which limits a mode's decay rate to
 *    s_max = c_g P/(2 pi A), A the area of the head: s = s_0 s_max/(s_0 + s_max), s_0 from 1 and 2.
 *
 * n is the effective number of touching points, (Sum f)^2/Sum f^2, and u^2 = 3 Sum f w^2/Sum f, w
 * the speed at which the contact closes: both are means over a few samples. Then s_0 = phi^2/2 Sum
 * h (C + D) with the mean of phi^2 over the bed.
 *
 * Limits: kappa, mu -> infinity, Y -> 0, no bounces, P -> infinity: s = phi^2/2 Sum lambda f. f ->
 * 0: s = 0. */
#ifndef TB_WIRE_HOLD_H
#define TB_WIRE_HOLD_H

#include "model/wires.h"

#define TB_HOLD_BANDS 16u  /* of frequency, evenly spaced on a logarithmic scale */
#define TB_HOLD_FORCES 24u /* octaves of force per length, from 2^-10 N/m on */

typedef struct TbWireHold {
  double bottom, top;                               /* centres of the outer bands [rad/s] */
  double points, spacing;                           /* N, and h, the mean over the wires [m] */
  double resistance[TB_HOLD_FORCES][TB_HOLD_BANDS]; /* C [N s/m2] */
  double share[TB_HOLD_FORCES][TB_HOLD_BANDS];      /* S */
  double mobility[TB_HOLD_BANDS];                   /* Y, with the mean of ky [m2/(N s)] */
  double most[TB_HOLD_BANDS];                       /* s_max [1/s] */
} TbWireHold;

/* The wires' contacts: their forces' sum [N] and effective number, and the force-weighted root mean
 * square of the speed at which they close [m/s]. */
typedef struct TbWireTouch {
  double force, touching, speed;
} TbWireTouch;

/* Prepares the tables for wires on this head, between two frequencies [rad/s]. */
void tb_wire_hold_prepare(TbWireHold *hold, const TaborHeadDef *head, const TaborAirDef *air,
                          const TbWires *wires, double radius, double bottom, double top);

/* Band of a frequency [rad/s]. */
uint32_t tb_wire_hold_band(const TbWireHold *hold, double omega);

/* Sum_p h (C + D) in each band: resistance[TB_HOLD_BANDS] [N s/m]. Audio-safe. */
void tb_wire_hold_resistance(const TbWireHold *hold, TbWireTouch touch, double *resistance);

#endif
