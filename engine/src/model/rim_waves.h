/* SPDX-License-Identifier: MIT */
/* The waves around N evenly spaced places of a hi-hat's edges (rims.h): an orthonormal basis of
 * what the places can tell apart,
 *   T_0 = N^(-1/2), T_(2k-1) = (2/N)^(1/2) cos(2 pi k j/N), T_2k = (2/N)^(1/2) sin(2 pi k j/N),
 * and T_(N-1) = (-1)^j N^(-1/2) for even N. A mode of m nodal diameters moves the places by one of
 * them alone: that of k = m mod N or N less that. So the edges' response is diagonal in them.
 * Set-up only. */
#ifndef TB_RIM_WAVES_H
#define TB_RIM_WAVES_H

#include <stdbool.h>
#include <stdint.h>

/* The wave of cos(m theta) or sin(m theta); `points` if it is 0 at all places. */
static inline uint32_t tb_rim_wave(uint32_t points, uint32_t m, bool sine) {
  const uint32_t rest = m % points, k = 2u * rest > points ? points - rest : rest;
  if (k == 0) return sine ? points : 0u;
  if (2u * k == points) return sine ? points : points - 1u;
  return sine ? 2u * k : 2u * k - 1u;
}

/* T_wave at place `place`. */
double tb_rim_wave_at(uint32_t points, uint32_t wave, uint32_t place);

#endif
