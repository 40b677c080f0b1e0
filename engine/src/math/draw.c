/* SPDX-License-Identifier: MIT */
#include "math/draw.h"

/* The finaliser of SplitMix64 (Steele, Lea, Flood 2014): every bit depends on every bit. */
uint64_t tb_draw_bits(uint64_t seed, uint64_t place) {
  uint64_t z = seed + (place + 1u) * 0x9E3779B97F4A7C15u;
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return z ^ z >> 31;
}

double tb_draw(uint64_t seed, uint64_t place) {
  return (double)(tb_draw_bits(seed, place) >> 11) * 0x1p-52 - 1.0;
}
