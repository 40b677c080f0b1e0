/* SPDX-License-Identifier: MIT */
#include "bodies/drum/rim_radiation.h"

#include <math.h>

#include "definition/definition.h"
#include "math/bessel.h"
#include "math/portable_math.h"
#include "math/quadrature.h"

static const double PI = 3.14159265358979323846;

/* ---- the wall -------------------------------------------------------------------------------- */

/* Most points around half the wall: at 10 kHz and half a metre from the axis still five a
 * wavelength. */
enum { AROUND = 256, PANELS = 3, LEVELS = PANELS * TB_PANEL };

/* Points around half the wall. With as many points the sum is exact for the sources' n waves and
 * the k r of the path's length; what the distance adds falls by e^-eta from one to the next, cosh
 * eta = (r^2 + R^2)/(2 r R) at the level of the microphone. */
static uint32_t points_around(uint32_t n, double wavenumber, double radius, double r) {
  const double nearer = fmin(r, radius), ratio = fmax(r, radius) / fmax(nearer, 1e-6 * radius);
  const double waves = n + wavenumber * nearer, eta = tb_log(ratio);
  return (uint32_t)fmin(AROUND, 16.0 + 0.75 * waves + 8.0 / fmax(eta, 1e-3));
}

/* Panels of levels: 16 nodes see a quarter of their panel's length, and 20 radians, to 1e-7. */
static uint32_t panels_along(double wavenumber, double radius, double depth, double r) {
  const double near = 0.25 * depth / fmax(fabs(r - radius), 1e-3 * depth);
  return (uint32_t)fmin(PANELS, 1.0 + fmax(near, wavenumber * depth / 20.0));
}

void tb_wall_field(uint32_t n, double wavenumber, double radius, double depth, double r, double z,
                   double field[2]) {
  double levels[LEVELS], weights[LEVELS];
  const uint32_t around = points_around(n, wavenumber, radius, r);
  const uint32_t panels = panels_along(wavenumber, radius, depth, r);
  tb_quadrature(-depth, 0.0, panels, levels, weights);
  field[0] = field[1] = 0.0;
  for (uint32_t i = 0; i < around; i++) {
    const double angle = PI * (i + 0.5) / around;
    const double across = r * r + radius * radius - 2.0 * r * radius * tb_cos(angle);
    const double part = tb_cos(n * angle) * 2.0 * PI / around / (4.0 * PI);
    for (uint32_t l = 0; l < panels * TB_PANEL; l++) {
      const double up = z - levels[l], distance = sqrt(across + up * up);
      const double out = -(double)(n * n) * (levels[l] + 0.5 * depth) / radius;
      const double size = part * weights[l] * out / distance;
      double sine, cosine;
      tb_sin_cos(wavenumber * distance, &sine, &cosine);
      field[0] += size * cosine;
      field[1] -= size * sine;
    }
  }
}

/* Int_-l^l x sin(kappa x) dx = 2 (sin y - y cos y)/kappa^2, y = kappa l. */
static double lever(double kappa, double half) {
  const double y = kappa * half;
  if (fabs(y) < 1e-2) return 2.0 / 3.0 * y * half * half * (1.0 - 0.1 * y * y);
  return 2.0 * (tb_sin(y) - y * tb_cos(y)) / (kappa * kappa);
}

double tb_wall_resistance(uint32_t n, double omega, const TaborAirDef *air, double radius,
                          double depth) {
  enum { NODES = 8 * TB_PANEL };
  double angles[NODES], weights[NODES], sum = 0.0;
  const double k = omega / air->sound_speed, n2 = (double)n * n;
  tb_quadrature(0.0, PI, NODES / TB_PANEL, angles, weights);
  for (uint32_t i = 0; i < NODES; i++) {
    double sine, cosine;
    tb_sin_cos(angles[i], &sine, &cosine);
    const double part = tb_bessel_j(n, k * radius * sine) * lever(k * cosine, 0.5 * depth);
    sum += weights[i] * part * part * sine;
  }
  return omega * omega * air->density * n2 * n2 * PI * sum / (4.0 * air->sound_speed);
}

/* ---- the hoop -------------------------------------------------------------------------------- */

/* m'/rho0 of a strip [m2]. */
static double strip_of(double wavenumber, double width) {
  const double wide = PI / 8.0 * wavenumber * width;
  return PI * 0.25 * width * width / sqrt(1.0 + wide * wide);
}

void tb_strip_field(TbStripMotion motion, uint32_t n, double wavenumber, double radius,
                    double width, double r, double z, double field[2]) {
  const uint32_t around = points_around(n, wavenumber, radius, r);
  const double strip = strip_of(wavenumber, width);
  field[0] = field[1] = 0.0;
  for (uint32_t i = 0; i < around; i++) {
    const double angle = PI * (i + 0.5) / around, c = tb_cos(angle);
    const double square = r * r + radius * radius - 2.0 * r * radius * c + z * z;
    const double distance = sqrt(square), turn = wavenumber * distance;
    const double along = motion == TB_STRIP_UP ? z : r * c - radius;
    const double size = strip * tb_cos(n * angle) * along / (square * distance) / (2.0 * around);
    double sine, cosine;
    tb_sin_cos(turn, &sine, &cosine);
    field[0] += size * (cosine + turn * sine);
    field[1] += size * (turn * cosine - sine);
  }
}

/* J_n'(x) */
static double bessel_slope(uint32_t n, double x) {
  const double next = tb_bessel_j(n + 1, x);
  return n ? 0.5 * (tb_bessel_j(n - 1, x) - next) : -next;
}

double tb_strip_resistance(TbStripMotion motion, uint32_t n, double omega, const TaborAirDef *air,
                           double radius, double width) {
  enum { NODES = 8 * TB_PANEL };
  double angles[NODES], weights[NODES], sum = 0.0;
  const double k = omega / air->sound_speed;
  const double size = omega * air->density * strip_of(k, width) * k * radius * 0.5;
  tb_quadrature(0.0, PI, NODES / TB_PANEL, angles, weights);
  for (uint32_t i = 0; i < NODES; i++) {
    double sine, cosine;
    tb_sin_cos(angles[i], &sine, &cosine);
    const double x = k * radius * sine;
    const double part =
      motion == TB_STRIP_UP ? cosine * tb_bessel_j(n, x) : sine * bessel_slope(n, x);
    sum += weights[i] * part * part * sine;
  }
  return (n ? 1.0 : 2.0) * PI * size * size * sum / (air->density * air->sound_speed);
}

double tb_hoop_lean(const TaborDrumDef *def, uint32_t n) {
  const double n2 = (double)n * n, torsion = def->hoop.torsion;
  return -0.5 * def->hoop.wall / def->shell.radius * n2 * (1.0 + torsion) / (1.0 + n2 * torsion);
}

/* ---- one mode -------------------------------------------------------------------------------- */

/* Hoop or shell with less than this part of the mass is not heard beside the heads. */
static const double LEAST_HEARD = 1e-4;

/* The field I of a part that moves by 1, at a place. */
typedef void RimField(const TaborDrumDef *def, const TbBodyMode *mode, double r, double z,
                      double field[2]);

static void add_field(TbBodyMode *mode, uint32_t mic, double amplitude, const double field[2]) {
  mode->fields[2 * mic] += amplitude * field[0];
  mode->fields[2 * mic + 1] += amplitude * field[1];
}

/* Adds `amplitude` times a part's field far away. */
static void add_far(TbBodyMode *mode, const TaborDrumDef *def, double amplitude,
                    RimField *field_at) {
  const double radius = def->shell.radius, x = mode->omega * radius / def->air.sound_speed;
  TbAirPoint points[TB_FAR_NODES];
  double fields[2 * TB_FAR_NODES], far[2 * TB_FAR_NODES];
  if (!mode->has_far) return;
  tb_far_points(def->shell.depth / radius, points);
  for (uint32_t i = 0; i < TB_FAR_NODES; i++) {
    field_at(def, mode, radius * points[i].radius, radius * points[i].height, fields + 2 * i);
  }
  tb_far_from_fields(def->shell.depth / radius, x, fields, far);
  for (uint32_t i = 0; i < 2 * TB_FAR_NODES; i++) mode->far[i] += amplitude * far[i];
}

static void wall_at(const TaborDrumDef *def, const TbBodyMode *mode, double r, double z,
                    double field[2]) {
  tb_wall_field(mode->m, mode->omega / def->air.sound_speed, def->shell.radius, def->shell.depth, r,
                z, field);
}

static void hoop_width_at(const TaborDrumDef *def, const TbBodyMode *mode, double r, double z,
                          double field[2]) {
  tb_strip_field(TB_STRIP_UP, mode->m, mode->omega / def->air.sound_speed, def->shell.radius,
                 def->hoop.width, r, z - def->hoop.height, field);
}

static void hoop_wall_at(const TaborDrumDef *def, const TbBodyMode *mode, double r, double z,
                         double field[2]) {
  tb_strip_field(TB_STRIP_OUT, mode->m, mode->omega / def->air.sound_speed, def->shell.radius,
                 def->hoop.wall, r, z - def->hoop.height + 0.5 * def->hoop.wall, field);
}

/* A part that moves by `amplitude`, of the resistance r of tb_wall_resistance(). */
static void add_part(const TaborDrumDef *def, double amplitude, double resistance,
                     RimField *field_at, TbBodyMode *mode) {
  uint32_t mics[TABOR_MAX_MICS];
  const uint32_t count = tb_mics_outside(def, mics);
  mode->radiation_rate += 0.5 * amplitude * amplitude * resistance;
  for (uint32_t p = 0; p < count; p++) {
    const TaborMicDef *mic = &def->mic[mics[p]];
    double field[2];
    field_at(def, mode, mic->radius, mic->height, field);
    add_field(mode, mics[p], amplitude, field);
  }
  add_far(mode, def, amplitude, field_at);
}

static void add_wall(const TaborDrumDef *def, double edge, TbBodyMode *mode) {
  const double radius = def->shell.radius, depth = def->shell.depth;
  add_part(def, edge, tb_wall_resistance(mode->m, mode->omega, &def->air, radius, depth), wall_at,
           mode);
}

static void add_hoop(const TaborDrumDef *def, double hoop, TbBodyMode *mode) {
  const double radius = def->shell.radius, width = def->hoop.width, wall = def->hoop.wall;
  if (width > 0.0) {
    const double up =
      tb_strip_resistance(TB_STRIP_UP, mode->m, mode->omega, &def->air, radius, width);
    add_part(def, hoop, up, hoop_width_at, mode);
  }
  const double lean = tb_hoop_lean(def, mode->m);
  if (wall > 0.0 && lean != 0.0) {
    const double out =
      tb_strip_resistance(TB_STRIP_OUT, mode->m, mode->omega, &def->air, radius, wall);
    add_part(def, hoop * lean, out, hoop_wall_at, mode);
  }
}

void tb_rim_radiate(const TbRim *rim, const TaborDrumDef *def, TbRimMotion motion,
                    TbBodyMode *mode) {
  if (def->air.density == 0.0 || !(tb_rim_mass(rim, motion) > LEAST_HEARD)) return;
  if (mode->m > 0 && rim->enclosed) add_wall(def, motion.edge, mode);
  add_hoop(def, motion.hoop, mode);
  if (!mode->has_far) return;
  mode->radiation_rate =
    tb_far_decay_rate(&def->air, def->shell.radius, mode->m, mode->omega, mode->far);
}
