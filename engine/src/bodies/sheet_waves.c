/* SPDX-License-Identifier: MIT */
#include "bodies/sheet_waves.h"

#include <math.h>

#include "bodies/felt_ring.h"

double tb_sheet_stiffness(const TaborHeadDef *head, double wavenumber) {
  const double k2 = wavenumber * wavenumber;
  return head->tension * k2 + head->bending_stiffness * k2 * k2;
}

double tb_sheet_film_loss(const TaborHeadDef *head, double wavenumber) {
  return head->damping_1 * wavenumber * wavenumber + head->damping_k * wavenumber;
}

/* By fixed-point passes from the head alone. */
double tb_sheet_wave_frequency(const TaborHeadDef *head, const TaborAirDef *air, double wavenumber,
                               double *mass) {
  const double stiffness = tb_sheet_stiffness(head, wavenumber);
  *mass = head->surface_density;
  double omega = sqrt(stiffness / *mass);
  for (int pass = 0; pass < 3 && air->density > 0.0; pass++) {
    const double slowness = omega / (air->sound_speed * wavenumber);
    if (slowness >= 0.98) break; /* as fast as sound: no mass, all radiation */
    *mass =
      head->surface_density + 2.0 * air->density / (wavenumber * sqrt(1.0 - slowness * slowness));
    omega = sqrt(stiffness / *mass);
  }
  return omega;
}

double tb_sheet_wave_decay_rate(const TaborHeadDef *head, double radius, uint32_t m, double zero,
                                double slope, double mass) {
  const double sigma = head->damping_0 + tb_sheet_film_loss(head, zero / radius) +
                       tb_felt_ring_sigma(head, radius, m, zero, slope);
  return 0.5 * head->surface_density / mass * sigma;
}

double tb_sheet_wave_number(const TaborHeadDef *head, const TaborAirDef *air, double omega) {
  double lo = 1e-3, hi = 1e7, mass;
  for (int i = 0; i < 100; i++) {
    const double middle = sqrt(lo * hi);
    if (tb_sheet_wave_frequency(head, air, middle, &mass) < omega) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return lo;
}
