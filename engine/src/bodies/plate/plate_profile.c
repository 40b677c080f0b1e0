/* SPDX-License-Identifier: MIT */
#include "bodies/plate/plate_profile.h"

static void add_bow(const TaborPlateDef *plate, double radius, double r, TbPlateProfile *profile) {
  const double x = r / radius;
  profile->slope -= 2.0 * plate->bow * x / radius;
  profile->curvature -= 2.0 * plate->bow / (radius * radius);
}

static void add_bell(const TaborPlateDef *plate, double r, TbPlateProfile *profile) {
  const double a = plate->bell_radius, height = plate->bell_height;
  if (!(r < a)) return;
  const double x = r / a, inside = 1.0 - x * x;
  profile->slope -= 4.0 * height * x * inside / a;
  profile->curvature += height * (12.0 * x * x - 4.0) / (a * a);
}

static void add_flange(const TaborPlateDef *plate, double radius, double r,
                       TbPlateProfile *profile) {
  const double length = plate->flange_width, from = radius - length;
  if (!(r > from)) return;
  const double u = (r - from) / length, slope = plate->flange_slope;
  profile->slope += slope * u * u * (3.0 - 2.0 * u);
  profile->curvature += slope * 6.0 * u * (1.0 - u) / length;
}

TbPlateProfile tb_plate_profile(const TaborPlateDef *plate, double radius, double r) {
  TbPlateProfile profile = {.thickness =
                              plate->thickness * (1.0 + (plate->taper - 1.0) * r / radius)};
  add_bow(plate, radius, r, &profile);
  add_bell(plate, r, &profile);
  add_flange(plate, radius, r, &profile);
  return profile;
}

bool tb_plate_is_flat(const TaborPlateDef *plate) {
  return plate->bow == 0.0 && plate->bell_height == 0.0 && plate->flange_slope == 0.0;
}
