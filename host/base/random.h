/* SPDX-License-Identifier: MIT */
/**
 * @file random.h
 * Pseudo-random numbers: SplitMix64 (Steele, Lea, Flood 2014). Every seed is a good one, also 0 and
 * its neighbours. The same on every machine.
 */
#ifndef TABOR_HOST_RANDOM_H
#define TABOR_HOST_RANDOM_H

#include <stdint.h>

#include "base/realtime.h"

/** The next 64 bits. @p state begins as the seed. */
static inline uint64_t random_bits(uint64_t *state) REALTIME {
  *state += 0x9E3779B97F4A7C15u;
  uint64_t z = *state;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/** The next number, evenly in [0, 1). */
static inline double random_share(uint64_t *state) REALTIME {
  return (double)(random_bits(state) >> 11) * 0x1p-53;
}

#endif
