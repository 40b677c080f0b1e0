/* SPDX-License-Identifier: MIT */
#include "model/stick_bending.h"

#include <math.h>

#include "math/portable_math.h"
#include "model/modes.h"

const double tb_stick_bending_length = 0.4;

static const double PI = 3.14159265358979323846;
static const double LOWEST = 320.0; /* of the free stick [Hz] */
static const double DECAY = 100.0;  /* in a hand [1/s] */

/* Roots of cos b cosh b = 1, and of tan b = tanh b. */
static const double FREE[TB_BENDS] = {4.730040744862704, 7.853204624095838, 10.995607838001671};
static const double PINNED[TB_BENDS] = {3.9266023120479185, 7.068582745628732, 10.210176122813031};

static double free_shape(double b, double u) {
  const double s = (tb_sinh(b) + tb_sin(b)) / (tb_cosh(b) - tb_cos(b));
  return tb_cosh(u) + tb_cos(u) - s * (tb_sinh(u) + tb_sin(u));
}

/* Int psi^2 dx = L (1 - (sin b/sinh b)^2)/2 before it is scaled. */
static double pinned_shape(double b, double u) {
  const double part = tb_sin(b) / tb_sinh(b);
  return (tb_sin(u) + part * tb_sinh(u)) * sqrt(2.0 / (1.0 - part * part));
}

static void prepare(TbBends *bends, const double *roots, double (*shape)(double b, double u),
                    double time_step, bool losses) {
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    const double ratio = roots[i] / FREE[0];
    const TbPole pole = tb_pole(2.0 * PI * LOWEST * ratio * ratio, losses ? DECAY : 0.0, time_step);
    bends->a[i] = pole.a;
    bends->b[i] = pole.b;
    bends->g[i] = pole.g;
    bends->stiffness[i] = pole.stiffness;
    bends->loss[i] = pole.loss;
    for (uint32_t cell = 0; cell <= TB_STICK_CELLS; cell++) {
      bends->shape[i][cell] = shape(roots[i], roots[i] * cell / TB_STICK_CELLS);
    }
  }
}

void tb_stick_bending_prepare(TbStickBending *stick, double time_step, bool losses) {
  prepare(&stick->free, FREE, free_shape, time_step, losses);
  prepare(&stick->pinned, PINNED, pinned_shape, time_step, losses);
}

void tb_stick_bending_shape(const TbBends *bends, double along, double *psi) {
  const double place = along / tb_stick_bending_length * TB_STICK_CELLS;
  uint32_t cell = (uint32_t)place;
  if (cell >= TB_STICK_CELLS) cell = TB_STICK_CELLS - 1u;
  const double part = place - (double)cell;
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    const double *at = &bends->shape[i][cell];
    psi[i] = at[0] + part * (at[1] - at[0]);
  }
}
