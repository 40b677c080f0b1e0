/* SPDX-License-Identifier: MIT */
/* The pressure that a ring of sources gives to a point: one line of a boundary integral about an
 * axis.
 *
 * The free-space field is G = e^{-i x D}/(4 pi D), D the distance. A ring of radius r' at height z'
 * carries sources of strength cos(m t), or dipoles along a normal n'. The point has radius r and
 * angle 0, d is the vector from the point to an element of the ring. Per length of the generating
 * curve, with a = x D,
 *   single_m = r' Int_0^{2 pi} G cos(m t) dt,
 *   double_m = r' Int_0^{2 pi} dG/dn' cos(m t) dt, dG/dn' = -(1 + i a) e^{-i a} (n'.d)/(4 pi D^3).
 * The exponentials are split,
 *   e^{-i a} = 1 - a^2/2 + a s(a), (1 + i a) e^{-i a} = 1 + a^2/2 + a^3 f(a),
 * and the kernels with them: the first two terms hold what is singular where the point meets the
 * ring, do not depend on x apart from a factor x^2, and are known in closed form (toroidal.h):
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

/* A ring, or a point and all its images about the axis. */
typedef struct TbCircle {
  double r, z;
} TbCircle;

/* single_m = single + x^2 single_slow + rest, and so for double_m. */
typedef struct TbRingTerms {
  double single, single_slow, dipole, dipole_slow;
} TbRingTerms;

enum { TB_RING_ORDERS = 64 };

/* terms[m], m < orders <= TB_RING_ORDERS, of a source whose normal points away from the axis
 * (`radial`) or up. */
void tb_ring_terms(TbCircle point, TbCircle source, bool radial, uint32_t orders,
                   TbRingTerms *terms);

/* s(a[i]) and f(a[i]), a[i] >= 0, at up to TB_RING_MOST values: real and imaginary parts. */
enum { TB_RING_MOST = 24 };
typedef struct TbRingRests {
  double single_re[TB_RING_MOST], single_im[TB_RING_MOST];
  double dipole_re[TB_RING_MOST], dipole_im[TB_RING_MOST];
} TbRingRests;

void tb_ring_rests(uint32_t count, const double *a, TbRingRests *rests);

#endif
