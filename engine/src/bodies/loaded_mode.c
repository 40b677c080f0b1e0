/* SPDX-License-Identifier: MIT */
#include "bodies/loaded_mode.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

static double azimuth_of(const TbAirOrder *air) { return air->m ? PI : 2.0 * PI; }

bool tb_load_matrix(const TaborDrumDef *def, TbArena *scratch, const TbAirOrder *air, uint32_t size,
                    double *matrix) {
  const uint32_t n = air->count;
  const double radius = def->shell.radius;
  double both_sides = def->air.density * radius * radius * radius * azimuth_of(air);
  double *mass = tb_arena_doubles(scratch, (size_t)n * n);
  if (scratch->failed) return false;
  if (def->shell.boundary == TABOR_BOUNDARY_OPEN) {
    tb_air_mass_open(air, mass);
  } else {
    if (!tb_air_mass_baffled(air, scratch, mass)) return false;
    both_sides *= 2.0;
  }
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t k = 0; k < n; k++) matrix[(size_t)i * size + k] = both_sides * mass[i * n + k];
  }
  return true;
}

bool tb_load_mode(const TaborDrumDef *def, TbArena *scratch, const TbAirOrder *air,
                  const TbOwnParts *own, const double *y, TbBodyMode *mode, TbAirParts *load) {
  const double radius = def->shell.radius;
  *load = (TbAirParts){0.0, 0.0};
  if (def->air.density == 0.0) return true;
  TbAirPoint points[TABOR_MAX_MICS];
  for (uint32_t p = 0; p < def->mic_count; p++) {
    points[p] = (TbAirPoint){def->mic[p].radius / radius, def->mic[p].height / radius};
  }
  const double unit = azimuth_of(air) * def->air.density * radius * radius;
  const TaborBoundary boundary = (TaborBoundary)def->shell.boundary;
  double x = mode->omega * radius / def->air.sound_speed;
  /* The mass of the lowest modes changes most: they get a second pass, and all digits. */
  const bool exact = x < 3.0;
  for (int pass = exact ? 0 : 1; pass < 2; pass++) {
    TbAirLoad found;
    x = mode->omega * radius / def->air.sound_speed;
    if (!tb_air_load(air, scratch, boundary, exact && pass == 1, y, x, points,
                     pass == 1 ? def->mic_count : 0, &found, mode->fields)) {
      return false;
    }
    load->mass = unit * radius * found.mass;
    load->resistance = unit * def->air.sound_speed * found.resistance;
    mode->omega = sqrt(own->stiffness / (own->mass + load->mass));
  }
  return true;
}
