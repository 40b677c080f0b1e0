/* SPDX-License-Identifier: MIT */
#include "math/bessel_table.h"

#include <math.h>

#include "math/bessel.h"

static const double PER_UNIT = 8.0;   /* grid points in a unit of the argument */
static const double MOST = 2097152.0; /* values in a table: 16 MB */
enum { BEFORE = 4, AFTER = 4 };       /* grid points beyond either end */

static double parity(uint32_t m) { return m % 2 ? -1.0 : 1.0; }

/* Grid point i is the argument (i - BEFORE)/PER_UNIT. */
static void fill(TbBesselTable *table, double *block) {
  const uint32_t count = table->count;
  for (uint32_t m = 0; m < table->orders; m++) {
    table->values[(size_t)m * count + BEFORE] = m == 0 ? 1.0 : 0.0;
  }
  for (uint32_t from = BEFORE + 1; from < count; from += 8) {
    double x[8];
    for (uint32_t i = 0; i < 8; i++) x[i] = (double)(from + i - BEFORE) / PER_UNIT;
    tb_bessel_whole8(x, table->orders, block);
    for (uint32_t m = 0; m < table->orders; m++) {
      double *row = table->values + (size_t)m * count;
      for (uint32_t i = 0; i < 8 && from + i < count; i++) row[from + i] = block[8 * m + i];
    }
  }
  for (uint32_t m = 0; m < table->orders; m++) { /* J_m(-x) = (-1)^m J_m(x) */
    double *zero = table->values + (size_t)m * count + BEFORE;
    for (int i = 1; i <= BEFORE; i++) zero[-i] = parity(m) * zero[i];
  }
}

bool tb_bessel_table_prepare(TbBesselTable *table, TbArena *arena, uint32_t orders, double top) {
  const double points = fmin(ceil(top * PER_UNIT), floor(MOST / (double)orders));
  *table = (TbBesselTable){.orders = orders, .count = (uint32_t)points + 1u + BEFORE + AFTER};
  table->values = tb_arena_doubles(arena, (size_t)orders * table->count);
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  double *block = tb_arena_doubles(&scratch, 8 * (size_t)orders);
  const bool done = table->values && block;
  if (done) fill(table, block);
  tb_arena_release(&scratch);
  return done;
}

/* Lagrange's polynomial through y[0..7] at 3 + t, 0 <= t <= 1. */
static double interpolate(const double *y, double t) {
  const double d0 = t + 3.0, d1 = t + 2.0, d2 = t + 1.0, d3 = t;
  const double d4 = t - 1.0, d5 = t - 2.0, d6 = t - 3.0, d7 = t - 4.0;
  const double p01 = d0 * d1, p23 = d2 * d3, p45 = d4 * d5, p67 = d6 * d7;
  const double low = p01 * p23, high = p45 * p67;
  const double first = (d1 * y[0] * (-1.0 / 5040.0) + d0 * y[1] * (1.0 / 720.0)) * p23 +
                       (d3 * y[2] * (-1.0 / 240.0) + d2 * y[3] * (1.0 / 144.0)) * p01;
  const double last = (d5 * y[4] * (-1.0 / 144.0) + d4 * y[5] * (1.0 / 240.0)) * p67 +
                      (d7 * y[6] * (-1.0 / 720.0) + d6 * y[7] * (1.0 / 5040.0)) * p45;
  return first * high + last * low;
}

double tb_bessel_table_value(const TbBesselTable *table, uint32_t m, double x) {
  const double *row = table->values + (size_t)m * table->count + BEFORE - 3;
  const double place = x * PER_UNIT;
  const uint32_t whole = (uint32_t)place;
  return interpolate(row + whole, place - (double)whole);
}

void tb_bessel_table_values(const TbBesselTable *table, uint32_t m, uint32_t count, double scale,
                            const double *x, double *j) {
  const uint32_t orders[8] = {m, m, m, m, m, m, m, m};
  const bool tabled = table && m < table->orders;
  const double end = tabled ? (double)(table->count - 1u - BEFORE - AFTER) / PER_UNIT : -1.0;
  for (uint32_t q = 0; q < count; q += 8) {
    double argument[8], top = 0.0;
    for (uint32_t i = 0; i < 8; i++) {
      argument[i] = scale * x[q + i];
      top = argument[i] > top ? argument[i] : top;
    }
    if (top > end) {
      tb_bessel_j8(orders, argument, j + q);
      continue;
    }
    for (uint32_t i = 0; i < 8; i++) j[q + i] = tb_bessel_table_value(table, m, argument[i]);
  }
}
