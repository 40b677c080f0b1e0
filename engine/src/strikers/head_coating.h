/* SPDX-License-Identifier: MIT */
/* The coating of a head under a bristle: a rough track, drawn from a seed.
 *
 * Sprayed coatings are rough at all lengths from their grains up. The height over a track, s the
 * distance along it, is a sum over lengths l_j = 2^j l, j = 0 .. 4, of cubic splines with
 * independent random coefficients one l_j apart,
 *   h(s) = H c Sum_j Sum_i B3(s/l_j - i) x_ji.
 * Its spectrum falls as 1/K from 1/(16 l) to 1/l, and as 1/K^8 beyond, the end of the grains. H = 1
 * makes its variance 1. Swept at a speed v, the wavenumber K sounds at f = v K/(2 pi): a faster
 * sweep is louder and brighter. The height is a function of place alone, so a brush at rest hears
 * nothing, and the same path gives the same sound. Audio-safe; the same bits on every machine. */
#ifndef TB_HEAD_COATING_H
#define TB_HEAD_COATING_H

#include <stdint.h>

/* l [m]: grains of the coating that drum heads are sprayed with are some 0.05 mm wide. */
#define TB_HEAD_COATING_GRAIN 5e-5

/* Height at s >= 0 [m] of track number `seed`, in units of its root mean square. */
double tb_head_coating_height(uint64_t seed, double s);

#endif
