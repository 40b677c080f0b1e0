/* SPDX-License-Identifier: MIT */
#include "strikers/head_coating.h"

#include "math/draw.h"

/* Lengths that make up the roughness, and c/H: 5 c^2 times the variance of a spline of numbers from
 * -1 to 1, 151/315 times 1/3, is 1. */
#define LENGTHS 5u
static const double PART = 1.118774163600087;

/* The cubic spline at `place` in units of its own length. */
static double spline(uint64_t seed, double place) {
  const uint64_t cell = (uint64_t)place;
  const double t = place - (double)cell, u = 1.0 - t;
  const double b0 = u * u * u, b3 = t * t * t;
  const double b1 = 4.0 - 6.0 * t * t + 3.0 * b3, b2 = 4.0 - 6.0 * u * u + 3.0 * b0;
  return (b0 * tb_draw(seed, cell) + b1 * tb_draw(seed, cell + 1u) + b2 * tb_draw(seed, cell + 2u) +
          b3 * tb_draw(seed, cell + 3u)) /
         6.0;
}

double tb_head_coating_height(uint64_t seed, double s) {
  double sum = 0.0, place = s / TB_HEAD_COATING_GRAIN;
  for (uint32_t j = 0; j < LENGTHS; j++, place *= 0.5) {
    sum += PART * spline(seed ^ (uint64_t)(j + 1u) << 60, place);
  }
  return sum;
}
