/* SPDX-License-Identifier: MIT */
#include "model/compliance.h"

/* Eight points by eight: sum[i][j] = Sum_m (x_mi gain_m) y_mj. */
static void block_of(uint32_t modes, const double *gain, const double *x, const double *y,
                     double sum[8][8]) {
  for (uint32_t i = 0; i < 8; i++) {
    for (uint32_t j = 0; j < 8; j++) sum[i][j] = 0.0;
  }
  for (uint32_t m = 0; m < modes; m++, x += 8, y += 8) {
    for (uint32_t i = 0; i < 8; i++) {
      const double push = x[i] * gain[m];
      for (uint32_t j = 0; j < 8; j++) sum[i][j] += push * y[j];
    }
  }
}

static bool class_matrix(TbArena *arena, const TbProjectionGroup *group, const double *gain,
                         const double **out) {
  const uint32_t points = group->points, modes = group->modes;
  double *matrix = tb_arena_doubles(arena, (size_t)points * points);
  if (!matrix) return false;
  for (uint32_t a = 0; a < points; a += 8) {
    for (uint32_t b = 0; b <= a; b += 8) {
      if (!tb_arena_go_on(arena)) return false;
      double sum[8][8];
      block_of(modes, gain + group->first, group->gather + (size_t)a * modes,
               group->gather + (size_t)b * modes, sum);
      for (uint32_t i = 0; i < 8; i++) {
        for (uint32_t j = 0; j < 8; j++) {
          if (a == b && j > i) continue; /* its mirror image has been computed */
          matrix[(size_t)a * points + (b + j) * 8 + i] = sum[i][j];
          matrix[(size_t)b * points + (a + i) * 8 + j] = sum[i][j];
        }
      }
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
