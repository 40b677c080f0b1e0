/* SPDX-License-Identifier: MIT */
#include "model/mic_response.h"

#include <math.h>
#include <string.h>

#include "math/portable_math.h"
#include "tabor/tabor.h"

static const double PI = 3.14159265358979323846;
static const double UNITY = 1000.0;                         /* [Hz] */
static const double HIGHEST = 16000.0, HIGHEST_PART = 0.42; /* [Hz]; of the rate */
static const double SECOND_PART = 0.6;                      /* of the highest */

/* Frequencies [Hz] and dampings of a section's zeros and poles. */
typedef struct Shape {
  double zero, zero_damping, pole, pole_damping;
} Shape;

/* Least-squares fits to points on curves that are typical of each kind of microphone. We could read
 * what is written about the published curves of well-known microphones, but not their data.
 *
 * Dynamic: level from 150 Hz to 1.2 kHz and falling below, a rise from 2 or 3 kHz on, 40 Hz to 15
 * kHz [SM57Chart]. The sizes are what recorded snare drums ask for: -4 dB at 100 Hz, +3 at 4 kHz,
 * +6 at 6 kHz, 0 at 12 kHz, -10 at 16 kHz.
 *
 * Large dynamic: a wide dip in the lower middle and a rise in the treble [KickMicrophones]. The
 * sizes are our choice: +5 dB at 80 Hz, -4 at 400 Hz, +7.4 at 4 kHz, -10 at 16 kHz.
 *
 * Condenser: very even [MicData2]. The sizes are our choice: -4 dB at 20 Hz, 0 from 0.1 to 3 kHz,
 * +2.7 at 10 kHz, -4 at 20 kHz.
 *
 * Even dynamic: a dynamic microphone without a rise in the treble, its bass cut against the drum's
 * lowest notes. The sizes are what snare drums recorded from below ask for: -14 dB at 40 Hz, -4.5
 * at 150 Hz, 0 from 0.4 to 6 kHz, -3.5 at 10 kHz, -10 at 12.7 kHz, -18.5 at 16 kHz. */
static const Shape SHAPES[][TB_RESPONSE_SECTIONS] = {
  [TABOR_RESPONSE_DYNAMIC] = {{49.74, 1.5, 142.0, 0.99},
                              {631.1, 0.8293, 581.2, 0.8989},
                              {28320.0, 0.9721, 6805.0, 0.3508},
                              {INFINITY, 0.0, 12740.0, 0.25}},
  [TABOR_RESPONSE_LARGE_DYNAMIC] = {{42.39, 1.5, 69.97, 0.5409},
                                    {357.3, 0.5278, 351.4, 0.99},
                                    {6224.0, 1.5, 4206.0, 0.483},
                                    {INFINITY, 0.0, 10400.0, 0.5788}},
  [TABOR_RESPONSE_CONDENSER] = {{24.21, 1.284, 39.93, 0.99},
                                {12290.0, 0.2782, 12750.0, 0.25},
                                {8697.0, 0.6411, 10080.0, 0.3986},
                                {INFINITY, 0.0, 14810.0, 0.99}},
  [TABOR_RESPONSE_EVEN_DYNAMIC] = {{5.315, 0.941, 44.34, 0.899},
                                   {165.2, 0.997, 267.7, 0.748},
                                   {INFINITY, 0.0, 8000.0, 0.802},
                                   {INFINITY, 0.0, 10150.0, 0.358}},
};

static double square(double x) { return x * x; }

/* c = sin^2(w k/2) */
static double place_of(double frequency, double rate) {
  return square(tb_sin(PI * frequency / rate));
}

/* |1 + 2 d s/w + (s/w)^2|^2 for s/w = i x */
static double power_at(double x, double damping) {
  return square(1.0 - x * x) + square(2.0 * damping * x);
}

/* |H|^2 */
static double wanted_at(const Shape *shape, double frequency) {
  return power_at(frequency / shape->zero, shape->zero_damping) /
         power_at(frequency / shape->pole, shape->pole_damping);
}

/* Squared size of p0 + p1/z + p2/z^2 at the place c. */
static double size_at(double p0, double p1, double p2, double c) {
  return square(p0 + p1 + p2) * (1.0 - c) + square(p0 - p1 + p2) * c -
         16.0 * p0 * p2 * c * (1.0 - c);
}

static void set_poles(const Shape *shape, double rate, TbSection *section) {
  const double turn = 2.0 * PI * shape->pole / rate;
  const double radius = tb_exp(-shape->pole_damping * turn);
  const double angle = turn * sqrt(1.0 - square(shape->pole_damping));
  section->a1 = -2.0 * radius * tb_cos(fmin(angle, PI));
  section->a2 = square(radius);
}

/* B1 + 4 B2 (1 - c) at a frequency. */
static double rest_at(const Shape *shape, const TbSection *section, double frequency, double c) {
  const double at_zero = square(1.0 + section->a1 + section->a2); /* B0 */
  const double size = size_at(1.0, section->a1, section->a2, c) * wanted_at(shape, frequency);
  return (size - at_zero * (1.0 - c)) / c;
}

static void set_zeros(const Shape *shape, double rate, TbSection *section) {
  const double high = fmin(HIGHEST, HIGHEST_PART * rate);
  const double low = fmin(shape->pole, SECOND_PART * high);
  const double c_low = place_of(low, rate), c_high = place_of(high, rate);
  const double at_low = rest_at(shape, section, low, c_low);
  const double at_high = rest_at(shape, section, high, c_high);
  const double cross = 0.25 * (at_low - at_high) / (c_high - c_low); /* B2 */
  const double at_half_rate = at_low - 4.0 * cross * (1.0 - c_low);  /* B1 */
  const double root = 1.0 + section->a1 + section->a2;
  const double w = 0.5 * (root + sqrt(at_half_rate)); /* W */
  section->b0 = 0.5 * (w + sqrt(w * w + cross));
  section->b1 = root - w;
  section->b2 = -0.25 * cross / section->b0;
}

/* Makes the whole 1 at 1 kHz. */
static void normalise(TbMicResponse *response, double rate) {
  const double c = place_of(UNITY, rate);
  double size = 1.0;
  for (uint32_t i = 0; i < response->count; i++) {
    const TbSection *s = &response->section[i];
    size *= size_at(s->b0, s->b1, s->b2, c) / size_at(1.0, s->a1, s->a2, c);
  }
  const double factor = 1.0 / sqrt(size);
  response->section[0].b0 *= factor;
  response->section[0].b1 *= factor;
  response->section[0].b2 *= factor;
}

void tb_mic_response_prepare(TbMicResponse *response, uint32_t kind, double sample_rate) {
  memset(response, 0, sizeof *response); /* padding too: a room hashes it */
  if (kind == TABOR_RESPONSE_FLAT) return;
  response->count = TB_RESPONSE_SECTIONS;
  for (uint32_t i = 0; i < response->count; i++) {
    set_poles(&SHAPES[kind][i], sample_rate, &response->section[i]);
    set_zeros(&SHAPES[kind][i], sample_rate, &response->section[i]);
  }
  normalise(response, sample_rate);
}

void tb_mic_response_invert(TbMicResponse *response) {
  for (uint32_t i = 0; i < response->count; i++) {
    TbSection *s = &response->section[i];
    const double scale = 1.0 / s->b0;
    *s = (TbSection){scale, scale * s->a1, scale * s->a2, scale * s->b1, scale * s->b2};
  }
}
