/* SPDX-License-Identifier: MIT */
#include "model/truncated_modes.h"

#include <math.h>

#include "bodies/sheet_waves.h"
#include "math/bessel.h"
#include "math/portable_math.h"
#include "model/modes.h"

static const double PI = 3.14159265358979323846;

/* Cells share the band up to where the patch first feels nothing, J1(K a) = 0, but half an octave
 * and more, and no more than this part of the rate; the last one takes all above, and is the only
 * one where modes go up to there. No oscillator is faster than FASTEST times the rate. */
static const double FIRST_ZERO = 3.8317059702075123, LEAST_RATIO = 1.5;
static const double TOP_OF_RATE = 0.3, FASTEST = 0.35;

/* Cells may be few for a wide band: they swing all the same. */
static const double MOST_DAMPED = 0.5; /* decay rate over frequency */

/* The patch feels next to nothing of wavenumbers beyond this over its radius. */
static const double FINEST = 40.0;

/* Points of the integrals in every octave of K: at the finest, seven to a wave of B^2. */
static const double PER_OCTAVE = 64.0;

static double mass_at(const TbSheetInAir *s, double wavenumber) {
  return s->sheet->surface_density + 2.0 * s->air->density / wavenumber;
}

static double omega_at(const TbSheetInAir *s, double wavenumber) {
  return sqrt(tb_sheet_stiffness(s->sheet, wavenumber) / mass_at(s, wavenumber));
}

static double wavenumber_at(const TbSheetInAir *s, double omega) {
  double lo = 1e-3, hi = 1e7;
  for (int i = 0; i < 100; i++) {
    const double middle = sqrt(lo * hi);
    if (omega_at(s, middle) < omega) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return lo;
}

void tb_truncated_modes_between(const TbSheetInAir *s, double patch_radius, double from, double to,
                                double *compliance, double *inverse_mass) {
  *compliance = *inverse_mass = 0.0;
  const double top = fmin(to, FINEST / patch_radius);
  if (top <= from) return;
  const double points = ceil(1.0 + PER_OCTAVE * tb_log(top / from) / tb_log(2.0));
  const double width = tb_log(top / from) / points;
  for (double i = 0.5; i < points; i += 1.0) {
    const double wavenumber = from * tb_exp(i * width), u = wavenumber * patch_radius;
    const double b = 2.0 * tb_bessel_j(1, u) / u;
    const double share = b * b * wavenumber * wavenumber * width / (2.0 * PI);
    *compliance += share / tb_sheet_stiffness(s->sheet, wavenumber);
    *inverse_mass += share / mass_at(s, wavenumber);
  }
}

/* One cell as an oscillator; what is faster than the rate can follow only keeps its compliance. */
static void add_cell(TbTruncatedModes *m, uint32_t i, double compliance, double inverse_mass,
                     double decay_rate, double time_step) {
  if (compliance <= 0.0) return;
  const double omega = sqrt(inverse_mass / compliance), fastest = 2.0 * PI * FASTEST / time_step;
  const double turn = fmin(omega, fastest);
  const TbPole pole = tb_pole(turn, fmin(decay_rate, MOST_DAMPED * turn), time_step);
  m->a[i] = pole.a;
  m->b[i] = pole.b;
  m->stiffness[i] = pole.stiffness;
  m->loss[i] = pole.loss;
  m->shape[i] = sqrt(omega < fastest ? inverse_mass : compliance * pole.stiffness);
  m->drive[i] = pole.g * m->shape[i];
  m->compliance += m->drive[i] * m->shape[i];
}

void tb_truncated_modes_prepare(TbTruncatedModes *mobility, const TbSheetInAir *s, double bandwidth,
                                double patch_radius, double time_step) {
  *mobility = (TbTruncatedModes){0};
  if (patch_radius <= 0.0) return;
  const double bottom = 2.0 * PI * bandwidth;
  const double silent = fmax(LEAST_RATIO * bottom, omega_at(s, FIRST_ZERO / patch_radius));
  const double top = fmax(bottom, fmin(silent, 2.0 * PI * TOP_OF_RATE / time_step));
  const double ratio = tb_exp(tb_log(top / bottom) / (TB_TRUNCATED - 1u));
  double lower = bottom;
  for (uint32_t i = 0; i < TB_TRUNCATED; i++) {
    const double upper = lower * ratio;
    const bool last = i + 1 == TB_TRUNCATED;
    double compliance, inverse_mass;
    tb_truncated_modes_between(s, patch_radius, wavenumber_at(s, lower),
                               last ? INFINITY : wavenumber_at(s, upper), &compliance,
                               &inverse_mass);
    add_cell(mobility, i, compliance, inverse_mass,
             s->losses ? 0.5 * (top > bottom ? upper - lower : lower) : 0.0, time_step);
    lower = upper;
  }
}

/* ---- on the audio thread -------------------------------------------------------------------- */

void tb_truncated_modes_step(const TbTruncatedModes *m, double *next, const double *now,
                             const double *last) {
  for (uint32_t i = 0; i < TB_TRUNCATED; i++) next[i] = m->a[i] * now[i] - m->b[i] * last[i];
}

void tb_truncated_modes_press(const TbTruncatedModes *m, double force, double *next) {
  for (uint32_t i = 0; i < TB_TRUNCATED; i++) next[i] -= force * m->drive[i];
}

double tb_truncated_modes_displacement(const TbTruncatedModes *m, const double *x) {
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_TRUNCATED; i++) sum += m->shape[i] * x[i];
  return sum;
}

double tb_truncated_modes_energy(const TbTruncatedModes *m, double rate, const double *next,
                                 const double *now) {
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_TRUNCATED; i++) {
    const double velocity = (next[i] - now[i]) * rate;
    sum += velocity * velocity + m->stiffness[i] * next[i] * now[i];
  }
  return 0.5 * sum;
}

double tb_truncated_modes_loss(const TbTruncatedModes *m, const double *next, const double *last) {
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_TRUNCATED; i++) {
    const double moved = next[i] - last[i];
    sum += m->loss[i] * moved * moved;
  }
  return sum;
}

void tb_truncated_modes_carry(const TbTruncatedModes *from, const TbTruncatedModes *to,
                              double ratio, double *now, double *last) {
  for (uint32_t i = 0; i < TB_TRUNCATED; i++) {
    tb_pole_carry(from->a[i], from->b[i], to->a[i], to->b[i], ratio, &now[i], &last[i]);
  }
}
