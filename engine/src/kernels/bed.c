/* SPDX-License-Identifier: MIT */
#include "kernels/bed.h"

/* even[j] = x[j] + x[mirror], odd[j] = x[j] - x[mirror]; the middle stands alone. */
static void fold(const TbBed *bed, const double *x, double *even, double *odd) {
  const uint32_t middle = bed->middle;
  for (uint32_t j = 0; j < middle; j++) {
    even[j] = x[j] + x[2 * middle - j];
    odd[j] = x[j] - x[2 * middle - j];
  }
  even[middle] = x[middle];
  odd[middle] = 0.0;
  for (uint32_t j = middle + 1; j < bed->half; j++) even[j] = odd[j] = 0.0;
}

static void unfold(const TbBed *bed, const double *even, const double *odd, double *x) {
  const uint32_t middle = bed->middle;
  for (uint32_t j = 0; j < middle; j++) {
    x[j] = even[j] + odd[j];
    x[2 * middle - j] = even[j] - odd[j];
  }
  x[middle] = even[middle];
}

static uint32_t class_across(const TbBed *bed, uint32_t line) {
  return line >= bed->first_line[1] && bed->quarters == 2 ? 1 : 0;
}

/* The points of one line in a grid vector. */
static uint32_t line_points(const TbBed *bed, uint32_t along, uint32_t line) {
  const uint32_t across = class_across(bed, line);
  return bed->first[tb_bed_class(bed, along, across)] +
         (line - bed->first_line[across]) * bed->columns[along];
}

static void contract_line(const TbBed *bed, const TbKernels *kernels, uint32_t line,
                          const double *x, double *scratch, double *grid) {
  const double *folded[2] = {scratch, scratch + bed->half};
  double *squeezed = scratch + 2 * bed->half;
  if (bed->halves == 2) {
    fold(bed, x, scratch, scratch + bed->half);
  } else {
    folded[0] = x;
  }
  for (uint32_t along = 0; along < bed->halves; along++) {
    const uint32_t columns = bed->columns[along];
    const double *values = folded[along];
    if (bed->thinned) {
      kernels->multiply((columns + 7) / 8, bed->half, squeezed, bed->squeeze[along], values);
      values = squeezed;
    }
    double *points = grid + line_points(bed, along, line);
    for (uint32_t a = 0; a < columns; a++) points[a] = values[a];
  }
}

void tb_bed_contract(const TbBed *bed, const TbKernels *kernels, const double *f, double *scratch,
                     double *grid) {
  double *lines = scratch + 3 * bed->half + 8;
  kernels->gather_lines(bed, f, lines);
  for (uint32_t line = 0; line < bed->lines; line++) {
    contract_line(bed, kernels, line, lines + line * bed->lanes, scratch, grid);
  }
}

static void expand_line(const TbBed *bed, const TbKernels *kernels, uint32_t line,
                        const double *grid, double *scratch, double *x) {
  const double *values[2] = {grid, grid};
  for (uint32_t along = 0; along < bed->halves; along++) {
    values[along] = grid + line_points(bed, along, line);
    if (!bed->thinned) continue;
    double *spread = scratch + along * bed->half;
    kernels->multiply(bed->half / 8, bed->columns[along], spread, bed->spread[along],
                      values[along]);
    values[along] = spread;
  }
  if (bed->halves == 2) {
    unfold(bed, values[0], values[1], x);
  } else {
    for (uint32_t j = 0; j < bed->lanes; j++) x[j] = values[0][j];
  }
}

void tb_bed_expand(const TbBed *bed, const TbKernels *kernels, const double *grid, double *scratch,
                   double *w) {
  double *lines = scratch + 3 * bed->half + 8;
  for (uint32_t line = 0; line < bed->lines; line++) {
    double *x = lines + line * bed->lanes;
    for (uint32_t j = bed->lanes - 8; j < bed->lanes; j++) x[j] = 0.0;
    expand_line(bed, kernels, line, grid, scratch, x);
  }
  kernels->spread_lines(bed, lines, w);
}
