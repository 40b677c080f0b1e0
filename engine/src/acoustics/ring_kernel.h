/* SPDX-License-Identifier: MIT */
/* The pressure that a ring of dipoles gives to a point: one line of a boundary integral about an
 * axis.
 *
 * The free-space field is G = e^{-i x D}/(4 pi D), D the distance. A ring of radius r' at height z'
 * carries dipoles of strength cos(m t) along a normal n'. The point has radius r and angle 0, d is
 * the vector from the point to an element of the ring. Per length of the generating curve
 *   K_m = r' Int_0^{2 pi} dG/dn' cos(m t) dt,
 *   dG/dn' = -(1 + i a) e^{-i a} (n'.d)/(4 pi D^3), a = x D.
 * (1 + i a) e^{-i a} = 1 + a^2/2 + a^3 f(a), and the kernel is split the same way:
 *   K_m = still_m + x^2 slow_m + x^3 rest_m(x).
 * `still` and `slow` hold what is singular where the point meets the ring; they do not depend on x,
 * and toroidal functions give them in closed form (toroidal.h):
 *   F_m = Int cos(m t)/D dt = 2 Q_{m-1/2}(chi)/sqrt(r r'),
 *   E_m = Int cos(m t)/D^3 dt = -2 Q'_{m-1/2}(chi)/(r r')^{3/2},
 *   H_m = Int cos(m t) D dt = (r^2 + r'^2 + (z - z')^2) F_m - r r' (F_{m+1} + F_{m-1}),
 *   chi = (r^2 + r'^2 + (z - z')^2)/(2 r r').
 * With n' along the axis, n'.d = z' - z. With n' away from the axis,
 * n'.d = r' - r cos t = (D^2 + r'^2 - r^2 - (z - z')^2)/(2 r').
 * Set-up only. */
#ifndef TB_RING_KERNEL_H
#define TB_RING_KERNEL_H

#include <stdbool.h>
#include <stdint.h>

typedef struct TbCircle {
  double r, z;
} TbCircle;

enum { TB_RING_ORDERS = 64 };

/* still[m] and slow[m], m < orders <= TB_RING_ORDERS, of a source whose normal points away from the
 * axis (`radial`) or up. */
void tb_ring_still(TbCircle point, TbCircle source, bool radial, uint32_t orders, double *still,
                   double *slow);

/* f(a) = ((1 + i a) e^{-i a} - 1 - a^2/2)/a^3, a >= 0. */
void tb_ring_rest(double a, double *re, double *im);

#endif
