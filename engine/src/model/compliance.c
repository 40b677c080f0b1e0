/* SPDX-License-Identifier: MIT */
#include "model/compliance.h"

static bool class_matrix(TbArena *arena, const TbProjectionGroup *group, const double *gain,
                         const double **out) {
  const uint32_t points = group->points, modes = group->modes;
  double *matrix = tb_arena_doubles(arena, (size_t)points * points);
  if (!matrix) return false;
  for (uint32_t a = 0; a < points; a++) {
    for (uint32_t b = 0; b <= a; b++) {
      const double *x = group->gather + ((size_t)(a / 8) * modes) * 8 + a % 8;
      const double *y = group->gather + ((size_t)(b / 8) * modes) * 8 + b % 8;
      double sum = 0.0;
      for (uint32_t i = 0; i < modes; i++) sum += x[8 * i] * gain[group->first + i] * y[8 * i];
      matrix[((size_t)(a / 8) * points + b) * 8 + a % 8] = sum;
      matrix[((size_t)(b / 8) * points + a) * 8 + b % 8] = sum;
    }
  }
  *out = matrix;
  return true;
}

TaborStatus tb_compliance_prepare(TbCompliance *c, TbArena *arena, const TbProjection *projection,
                                  const double *gain) {
  *c = (TbCompliance){.classes = projection->groups};
  for (uint32_t g = 0; g <= projection->groups; g++) c->first[g] = projection->wire_grid.first[g];
  for (uint32_t g = 0; g < projection->groups; g++) {
    if (!class_matrix(arena, &projection->group[g], gain, &c->matrix[g])) return TABOR_ERROR_MEMORY;
  }
  return TABOR_OK;
}
