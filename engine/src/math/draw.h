/* SPDX-License-Identifier: MIT */
/* Pseudo-random numbers by place instead of by turn: the same seed and place give the same number,
 * practically independent of all others. Audio-safe; the same bits on every machine. */
#ifndef TB_DRAW_H
#define TB_DRAW_H

#include <stdint.h>

uint64_t tb_draw_bits(uint64_t seed, uint64_t place);
/* From -1 to 1. */
double tb_draw(uint64_t seed, uint64_t place);

#endif
