/* SPDX-License-Identifier: MIT */
#include "model/rim_waves.h"

#include <math.h>

#include "math/portable_math.h"

double tb_rim_wave_at(uint32_t points, uint32_t wave, uint32_t place) {
  const uint32_t k = (wave + 1u) / 2u;
  const bool sine = wave > 0 && wave % 2u == 0;
  double s, c;
  tb_sin_cos_degrees(360.0 * (k * place % points) / points, &s, &c);
  const double size = sqrt((k == 0 || 2u * k == points ? 1.0 : 2.0) / points);
  return size * (sine ? s : c);
}
