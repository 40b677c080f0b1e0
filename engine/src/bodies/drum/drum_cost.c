/* SPDX-License-Identifier: MIT */
#include "bodies/drum/drum_cost.h"

#include <math.h>

#include "bodies/drum/closed_drum_modes.h"
#include "bodies/drum/head_pitch.h"

static const double PI = 3.14159265358979323846;

/* About z^2/4 - z/2 modes of one head lie below the zero z. */
static double mode_count(const TaborDrumDef *def, double bandwidth) {
  if (tb_is_two_headed(def)) return tb_closed_drum_mode_count(def, bandwidth);
  const double z = tb_body_wave_zero(&def->batter, &def->air, def->shell.radius, bandwidth);
  return fmax(1.0, 0.25 * z * z - 0.5 * z);
}

/* Sums over all orders of the eigenproblems' sizes. */
typedef struct Sizes {
  double squares, cubes;
} Sizes;

/* A sample of the orders is looked at. */
static Sizes order_sizes(const TaborDrumDef *def, double basis_top, double limit) {
  const double step = fmax(1.0, basis_top / 32.0);
  Sizes s = {0.0, 0.0};
  for (double m = 0.0; m < basis_top; m += step) {
    const double size = 1.0 + tb_closed_drum_order_size(def, m, basis_top, limit);
    s.squares += step * size * size;
    s.cubes += step * size * size * size;
  }
  return s;
}

/* An eigenproblem of one order, without what comes of its modes. */
static double eigen_seconds(Sizes s) { return 2e-7 * s.squares + 4e-10 * s.cubes; }

/* A search takes some seven trials. */
static double tuning_seconds(const TaborDrumDef *def, TaborHead which, const TaborHeadDef *pitched,
                             double tension) {
  if (pitched->pitch == 0) return 0.0;
  const double size = tb_head_pitch_size(def, which, tension);
  return 0.004 + 7.0 * eigen_seconds((Sizes){size * size, size * size * size});
}

/* Eigenproblems; then what each mode meets of the air: outside a shell a boundary integral, at an
 * open head sums over its Bessel functions. */
static double head_seconds(const TaborDrumDef *def, Sizes s, double modes) {
  const double eigen = 0.001 + eigen_seconds(s);
  if (def->air.density == 0.0) return 0.6 * eigen; /* nothing couples the air's coordinates */
  if (!tb_has_cavity(def)) return eigen + 2e-6 * s.squares;
  return eigen + (tb_is_two_headed(def) ? 0.018 : 0.003) + 4.5e-5 * modes;
}

TbBodyCost tb_drum_cost(const TaborDrumDef *def, const TaborDrumDef *resolved, double basis_top,
                        double bandwidth, uint32_t most_modes) {
  const Sizes sizes = order_sizes(resolved, basis_top, 2.0 * PI * bandwidth);
  TbBodyCost cost = {.modes = fmin(most_modes, mode_count(resolved, bandwidth))};
  cost.prepare = head_seconds(resolved, sizes, cost.modes);
  cost.resolve = tuning_seconds(def, TABOR_HEAD_BATTER, &def->batter, resolved->batter.tension) +
                 (tb_is_two_headed(def) ? tuning_seconds(def, TABOR_HEAD_RESONANT, &def->resonant,
                                                         resolved->resonant.tension)
                                        : 0.0);
  return cost;
}
