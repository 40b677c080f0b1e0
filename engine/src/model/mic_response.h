/* SPDX-License-Identifier: MIT */
/* Frequency response of a microphone, as a filter of its signal at the output's rate.
 *
 * At most four second-order sections, each of which is 1 at 0 Hz:
 *   H(s) = (1 + 2 dz s/wz + (s/wz)^2)/(1 + 2 dp s/wp + (s/wp)^2), dz > 0, 0 < dp < 1,
 * with all zeros and poles in the left half plane. Together they follow the curve of
 * mic_response.c, which is 0 dB at 1 kHz. A digital section has the poles exp(s k) of H, k the time
 * step. Its numerator is such that its size is that of H at 0 Hz, at t = min(16 kHz, 0.42/k), and
 * at wp or 0.6 t, whichever is lower. With c = sin^2(w k/2), any b0 + b1/z + b2/z^2 has the squared
 * size
 *   B(c) = B0 (1 - c) + B1 c + 4 B2 c (1 - c),
 *   B0 = (b0 + b1 + b2)^2, B1 = (b0 - b1 + b2)^2, B2 = -4 b0 b2,
 * so B1 and B2 follow from two values of B(c) = A(c) |H|^2, and with
 *   W = (sqrt B0 + sqrt B1)/2: b0 = (W + sqrt(W^2 + B2))/2, b1 = sqrt B0 - W, b2 = -B2/(4 b0).
 * These zeros lie inside the unit circle if B1 > 0 and W^2 + B2 > 0. That holds for the sections
 * here at every rate that a model may have; tests/engine/test_mic_response.c looks at them all. So
 * the filter has minimum phase, and its inverse is stable. The curve is met within 0.2 dB up to 16
 * kHz at 44.1 kHz and above, where a bilinear transform is off by several decibels. It has no
 * latency.
 *
 * The curves leave out: they are those of sound from the front and from afar. The boost of
 * bass close to a directional microphone, which they would add to, and its directivity are not
 * modelled. */
#ifndef TB_MIC_RESPONSE_H
#define TB_MIC_RESPONSE_H

#include <stdint.h>

#include "math/arithmetic.h"

enum { TB_RESPONSE_SECTIONS = 4 };

/* (b0 + b1/z + b2/z^2)/(1 + a1/z + a2/z^2) */
typedef struct TbSection {
  double b0, b1, b2, a1, a2;
} TbSection;

typedef struct TbMicResponse {
  uint32_t count; /* of sections; 0: flat */
  TbSection section[TB_RESPONSE_SECTIONS];
} TbMicResponse;

/* The last state of each section. */
typedef double TbResponseMemory[TB_RESPONSE_SECTIONS][2];

/* The response `kind`, a TaborMicResponse, at this rate [Hz]. Set-up only. */
void tb_mic_response_prepare(TbMicResponse *response, uint32_t kind, double sample_rate);

/* Makes it the filter that undoes it. Set-up only. */
void tb_mic_response_invert(TbMicResponse *response);

/* One sample through the filter. Audio-safe. */
static inline double tb_mic_respond(const TbMicResponse *response, TbResponseMemory memory,
                                    double x) {
  for (uint32_t i = 0; i < response->count; i++) {
    const TbSection *s = &response->section[i];
    double *m = memory[i];
    const double y = s->b0 * x + m[0];
    m[0] = s->b1 * x - s->a1 * y + m[1];
    m[1] = s->b2 * x - s->a2 * y;
    x = y;
  }
  return x;
}

#endif
