/* SPDX-License-Identifier: MIT */
#include "math/combine.h"

#include <stddef.h>

/* So many columns at a time stay in registers. */
enum { COLUMNS = 16 };

/* Columns 0 .. length - 1; inlined, so that a known length keeps its sums in registers. */
static inline __attribute__((always_inline)) void
combine_columns(uint32_t length, uint32_t count, const double *factors, const double *rows,
                uint32_t stride, double sign, double *out) {
  double sum[COLUMNS] = {0.0};
  for (uint32_t j = 0; j < count; j++) {
    const double factor = factors[j], *row = rows + (size_t)j * stride;
    for (uint32_t k = 0; k < length; k++) sum[k] += factor * row[k];
  }
  for (uint32_t k = 0; k < length; k++) out[k] += sign * sum[k];
}

void tb_combine_rows(uint32_t length, uint32_t count, const double *factors, const double *rows,
                     uint32_t stride, double sign, double *out) {
  uint32_t k = 0;
  for (; k + COLUMNS <= length; k += COLUMNS) {
    combine_columns(COLUMNS, count, factors, rows + k, stride, sign, out + k);
  }
  combine_columns(length - k, count, factors, rows + k, stride, sign, out + k);
}
