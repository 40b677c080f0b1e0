/* SPDX-License-Identifier: MIT */
/* Legendre functions of the second kind and half-integer degree, Q_{m-1/2}(chi), chi > 1: the
 * Fourier coefficients of the inverse distance between two coaxial rings ([DLMF] 14.19),
 *   Int_0^{2 pi} cos(m t)/sqrt(chi - cos t) dt = 2 sqrt(2) Q_{m-1/2}(chi).
 *
 * Q_{-1/2} and Q_{1/2} are complete elliptic integrals, computed by the arithmetic-geometric mean
 * ([DLMF] 19.8). The others follow from
 *   (m + 1/2) Q_{m+1/2} = 2 m chi Q_{m-1/2} - (m - 1/2) Q_{m-3/2},
 * upwards where this is stable enough, that is near chi = 1, and downwards otherwise. */
#ifndef TB_TOROIDAL_H
#define TB_TOROIDAL_H

#include <stdint.h>

/* q[m] = Q_{m-1/2}(1 + gap), m < count; gap > 0, count >= 2. Relative error below 1e-9. */
void tb_toroidal(double gap, uint32_t count, double *q);

#endif
