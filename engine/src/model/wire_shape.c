/* SPDX-License-Identifier: MIT */
#include "model/wire_shape.h"

#include <math.h>

#include "definition/definition.h"
#include "math/portable_math.h"

static const double TURN = 6.28318530717958647692;

/* Numbers for the generator: away from those of tensions and rest offsets (definition.c). */
enum { FIRST_DRAW = 1 << 20, DRAWS = 3 };

/* Uniform in (0, 1). */
static double draw(const TaborWiresDef *wires, uint32_t number) {
  return 0.5 * (1.0 + tb_deviate(wires->seed, FIRST_DRAW + number));
}

void tb_wire_shape_draw(TbWireShape *shape, const TaborWiresDef *wires, uint32_t index) {
  shape->height = wires->unevenness * wires->bend_height * sqrt(2.0 / TB_WIRE_WAVES);
  for (uint32_t j = 0; j < TB_WIRE_WAVES; j++) {
    const uint32_t first = (index * TB_WIRE_WAVES + j) * DRAWS;
    const double size = sqrt(-2.0 * tb_log(draw(wires, first)));
    shape->wavenumber[j] = size * tb_cos(TURN * draw(wires, first + 1)) / wires->bend_length;
    shape->phase[j] = TURN * draw(wires, first + 2);
  }
}

double tb_wire_shape_height(const TbWireShape *shape, double s) {
  if (shape->height == 0.0) return 0.0;
  double sum = 0.0;
  for (uint32_t j = 0; j < TB_WIRE_WAVES; j++) {
    sum += tb_cos(shape->wavenumber[j] * s + shape->phase[j]);
  }
  return shape->height * sum;
}
