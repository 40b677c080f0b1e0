/* SPDX-License-Identifier: MIT */
/* Conversion of a whole sound to another sample rate. Set-up only.
 *
 * With the ratio r of the new rate to the old one, a cut-off c = 0.95 min(1, r) of half the old
 * rate and Kaiser's window w [KaiserSchafer1980] of beta 10, |t| <= 64/min(1, r) long,
 *
 *   y(n) = Sum_k x(k) h(n/r - k), h(t) = c w(t) sin(pi c t)/(pi c t).
 *
 * Up to 0.9 of half the lower rate it changes no level by more than 0.001 dB, and what lies beyond
 * that half is 95 dB down. */
#ifndef TB_RESAMPLE_H
#define TB_RESAMPLE_H

#include <stdbool.h>
#include <stdint.h>

/* Frames of the converted sound. */
uint32_t tb_resampled_length(uint32_t frames, double ratio);
/* Converts `sound`, silent before and after its `frames`, to `length` frames. The ratio 1 copies.
 * False if memory is short. */
bool tb_resample(const float *sound, uint32_t frames, double ratio, float *converted,
                 uint32_t length);

#endif
