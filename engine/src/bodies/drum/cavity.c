/* SPDX-License-Identifier: MIT */
#include "bodies/drum/cavity.h"

#include <math.h>

#include "math/bessel.h"
#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

double tb_cavity_azimuth(uint32_t m) { return m ? PI : 2.0 * PI; }

/* ---- z' ------------------------------------------------------------------------------------- */

/* The zero of J_m' between lo and hi, where it changes its sign once: Halley's step, which cubes
 * the error, where it stays inside, else halving. `falling`: J_m' is positive at lo. Derivatives
 * come from Bessel's equation. */
static double extremum(uint32_t m, double lo, double hi, bool falling) {
  double z = 0.5 * (lo + hi);
  for (int i = 0; i < 60 && hi - lo > 1e-14 * hi; i++) {
    double j[2];
    tb_bessel_pair(m, z, j);
    const double order = (double)m / z, factor = 1.0 - order * order;
    const double slope = order * j[0] - j[1], bend = -slope / z - factor * j[0];
    const double third =
      -bend / z + slope / (z * z) - factor * slope - 2.0 * order * order / z * j[0];
    if ((slope > 0.0) == falling) {
      lo = z;
    } else {
      hi = z;
    }
    const double next = z - slope / (bend - 0.5 * slope * third / bend);
    if (fabs(next - z) <= 3e-7 * z) return next; /* its cube is nothing */
    z = next > lo && next < hi ? next : 0.5 * (lo + hi);
  }
  return z;
}

/* Between two zeros of J_m lies one of J_m', and one below the first (z' = 0 for m = 0). */
static uint32_t radial_zeros(uint32_t m, const double *nodes, uint32_t count, double *zeros) {
  for (uint32_t i = 0; i < count; i++) {
    const double lo = i ? nodes[i - 1] : (double)m;
    zeros[i] = i == 0 && m == 0 ? 0.0 : extremum(m, lo, nodes[i], i % 2 == 0);
  }
  return count;
}

/* ---- one order ------------------------------------------------------------------------------ */

double tb_cavity_mode_omega(const TbCavity *cavity, double zero, uint32_t axial) {
  return cavity->sound_speed * tb_hypot(zero / cavity->radius, (double)axial * PI / cavity->depth);
}

static uint32_t keep_below(TbCavityOrder *order, const TbCavity *cavity, double top) {
  uint32_t total = 0;
  for (uint32_t p = 0; p < order->radial_count; p++) {
    order->kept[p] = 0;
    while (tb_cavity_mode_omega(cavity, order->zeros[p], order->kept[p]) < top) order->kept[p]++;
    total += order->kept[p];
  }
  return total;
}

static bool list_modes(TbCavityOrder *order, TbArena *arena, const TbCavity *cavity, double top) {
  uint32_t total = keep_below(order, cavity, top);
  while (total > TB_CAVITY_COORDINATES) total = keep_below(order, cavity, top *= 0.97);
  order->modes = tb_arena_take(arena, total + 1u, sizeof *order->modes);
  if (!order->modes) return false;
  for (uint32_t p = 0; p < order->radial_count; p++) {
    for (uint32_t l = 0; l < order->kept[p]; l++) {
      const double omega = tb_cavity_mode_omega(cavity, order->zeros[p], l);
      if (omega == 0.0) continue; /* the spring */
      order->modes[order->mode_count++] = (TbCavityMode){p, l, omega};
    }
  }
  return true;
}

bool tb_cavity_order_prepare(TbCavityOrder *order, TbArena *arena, const TbCavity *cavity,
                             uint32_t m, double top_zero, double top) {
  *order = (TbCavityOrder){.m = m};
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  const uint32_t room = (uint32_t)(top_zero / PI) + 4u;
  double *nodes = tb_arena_doubles(&scratch, room);
  const uint32_t count = nodes ? tb_bessel_zeros(m, top_zero, nodes, room) : 0;
  order->zeros = tb_arena_doubles(arena, count);
  order->edges = tb_arena_doubles(arena, count);
  order->norms = tb_arena_doubles(arena, count);
  order->kept = tb_arena_take(arena, count, sizeof *order->kept);
  const bool failed = scratch.failed || arena->failed;
  if (!failed) order->radial_count = radial_zeros(m, nodes, count, order->zeros);
  tb_arena_release(&scratch);
  if (failed) return false;
  for (uint32_t p = 0; p < count; p++) {
    const double zero = order->zeros[p], j = tb_bessel_j(m, zero);
    const double ratio = zero > 0.0 ? (double)m / zero : 0.0;
    order->edges[p] = j;
    order->norms[p] = 0.5 * (1.0 - ratio * ratio) * j * j;
  }
  return list_modes(order, arena, cavity, top);
}

/* ---- matrices ------------------------------------------------------------------------------- */

/* Mass per S_i S_j/(a_m n_p) of one radial order, the coordinates left out. */
static void radial_mass(const TbCavityOrder *order, const TbCavity *cavity, uint32_t p, double *own,
                        double *across) {
  const double kappa = order->zeros[p] / cavity->radius, depth = cavity->depth;
  const double kl = kappa * depth;
  *own = kappa > 0.0 ? 1.0 / (kappa * tb_tanh(kl)) : depth / 3.0;
  *across = kappa > 0.0 ? (kl < 700.0 ? 1.0 / (kappa * tb_sinh(kl)) : 0.0) : -depth / 6.0;
  for (uint32_t l = 0; l < order->kept[p]; l++) {
    const double axial = (double)l * PI / depth;
    const double square = kappa * kappa + axial * axial;
    if (square == 0.0) continue;
    const double part = 1.0 / ((l ? 0.5 : 1.0) * depth * square);
    *own -= part;
    *across -= l % 2 ? -part : part;
  }
  *own *= cavity->density;
  *across *= cavity->density;
}

void tb_cavity_openings(const TbCavityOrder *order, const TbAirOrder *air, uint32_t p, double *s) {
  const double zero = order->zeros[p], j = order->edges[p];
  for (uint32_t i = 0; i < air->count; i++) {
    const double z = air->zeros[i];
    s[i] = z * air->slopes[i] * j / (z * z - zero * zero);
  }
}

/* matrix[rows of head a][rows of head b] += factor s s^T. */
static void add_block(uint32_t size, double *matrix, uint32_t n, uint32_t a, uint32_t b,
                      double factor, const double *s) {
  for (uint32_t i = 0; i < n; i++) {
    double *row = matrix + (size_t)(a * n + i) * size + b * n;
    for (uint32_t k = 0; k < n; k++) row[k] += factor * s[i] * s[k];
  }
}

static void add_heads(const TbCavity *cavity, uint32_t size, double *matrix, uint32_t n, double own,
                      double across, const double *s) {
  for (uint32_t a = 0; a < cavity->heads; a++) {
    for (uint32_t b = 0; b < cavity->heads; b++) {
      add_block(size, matrix, n, a, b, a == b ? own : across, s);
    }
  }
}

double tb_cavity_mode_norm(const TbCavityOrder *order, const TbCavity *cavity, uint32_t p,
                           uint32_t l) {
  const double area = tb_cavity_azimuth(order->m) * cavity->radius * cavity->radius;
  return area * cavity->depth * (l ? 0.5 : 1.0) * order->norms[p];
}

/* Stiffness of one mode: rho0 c0^2/N_c between the heads and, unless it is the spring, its own. */
static void add_mode(const TbCavityOrder *order, const TbCavity *cavity, uint32_t n, uint32_t p,
                     uint32_t l, double omega, uint32_t index, uint32_t size, const double *s,
                     double *mass, double *stiffness) {
  const double area = tb_cavity_azimuth(order->m) * cavity->radius * cavity->radius;
  const double spring = cavity->density * cavity->sound_speed * cavity->sound_speed /
                        tb_cavity_mode_norm(order, cavity, p, l);
  const double upper = l % 2 ? -1.0 : 1.0;
  add_heads(cavity, size, stiffness, n, spring * area * area, upper * spring * area * area, s);
  if (omega == 0.0) return;
  const double pull = -area * omega * sqrt(spring);
  for (uint32_t h = 0; h < cavity->heads; h++) {
    for (uint32_t i = 0; i < n; i++) {
      const double value = (h ? 1.0 : upper) * pull * s[i];
      stiffness[(size_t)(h * n + i) * size + index] = value;
      stiffness[(size_t)index * size + h * n + i] = value;
    }
  }
  mass[(size_t)index * size + index] = 1.0;
  stiffness[(size_t)index * size + index] = omega * omega;
}

void tb_cavity_assemble(const TbCavityOrder *order, const TbCavity *cavity, const TbAirOrder *air,
                        uint32_t size, double *mass, double *stiffness) {
  const uint32_t n = air->count;
  const double radius = cavity->radius;
  const double unit =
    tb_cavity_azimuth(order->m) * radius * radius; /* S_i S_j/(a_m n_p) = unit s s/(n_p/R^2) */
  double s[TB_CAVITY_OPENINGS];
  uint32_t next = cavity->heads * n;
  for (uint32_t p = 0; p < order->radial_count; p++) {
    double own, across;
    tb_cavity_openings(order, air, p, s);
    radial_mass(order, cavity, p, &own, &across);
    add_heads(cavity, size, mass, n, unit * own / order->norms[p], unit * across / order->norms[p],
              s);
    for (uint32_t l = 0; l < order->kept[p]; l++) {
      const double omega = tb_cavity_mode_omega(cavity, order->zeros[p], l);
      add_mode(order, cavity, n, p, l, omega, next, size, s, mass, stiffness);
      if (omega > 0.0) next++;
    }
  }
}

/* ---- walls ---------------------------------------------------------------------------------- */

/* Int |p|^2 and Int |grad_t p|^2 over a wall. */
typedef struct Wall {
  double square, slope;
} Wall;

/* Power that they absorb at the pressures of `omega`. */
static double absorbed(const TbCavity *cavity, const Wall *side, const Wall *ends, double omega) {
  const double k = omega / cavity->sound_speed,
               viscous = sqrt(2.0 * TB_KINEMATIC_VISCOSITY / omega);
  const double heat = 0.5 * k * (TB_HEAT_RATIO - 1.0) * viscous / sqrt(TB_PRANDTL);
  const double friction = 0.5 * viscous / k;
  return (heat * (side->square + ends->square) + friction * (side->slope + ends->slope) +
          cavity->admittance * side->square) /
         (2.0 * cavity->density * cavity->sound_speed);
}

static void add_wall(Wall *wall, double area, double amplitude, double wavenumber_square) {
  wall->square += area * amplitude * amplitude;
  wall->slope += area * amplitude * amplitude * wavenumber_square;
}

/* Pressures of axial order l on the side. */
static void add_side(Wall *side, uint32_t m, const TbCavity *cavity, uint32_t l, double amplitude) {
  const double around = (double)m / cavity->radius, axis = (double)l * PI / cavity->depth;
  const double area = tb_cavity_azimuth(m) * cavity->radius * cavity->depth * (l ? 0.5 : 1.0);
  add_wall(side, area, amplitude, around * around + axis * axis);
}

/* Pressures of radial order p on one end. */
static void add_end(Wall *ends, const TbCavityOrder *order, const TbCavity *cavity, uint32_t p,
                    double amplitude) {
  const double radius = cavity->radius, kappa = order->zeros[p] / radius;
  const double area = tb_cavity_azimuth(order->m) * radius * radius * order->norms[p];
  add_wall(ends, area, amplitude, kappa * kappa);
}

/* Pressure in the spring (0,0,0): -(rho0 c0^2/N) S.w. */
static double spring_pressure(const TbCavityOrder *order, const TbCavity *cavity,
                              const TbAirOrder *air, const double *heads) {
  double s[TB_CAVITY_OPENINGS], swept = 0.0;
  tb_cavity_openings(order, air, 0, s);
  for (uint32_t h = 0; h < cavity->heads; h++) {
    for (uint32_t i = 0; i < air->count; i++) swept += s[i] * heads[h * air->count + i];
  }
  const double area = tb_cavity_azimuth(order->m) * cavity->radius * cavity->radius;
  return -cavity->density * cavity->sound_speed * cavity->sound_speed * area * swept /
         tb_cavity_mode_norm(order, cavity, 0, 0);
}

/* Pressure of a coordinate: its inertia keeps the balance, p = (omega^2/omega_c) sqrt(rho0
 * c0^2/N_c) u. */
static double mode_pressure(const TbCavityOrder *order, const TbCavity *cavity,
                            const TbCavityMode *mode, double u, double omega) {
  return omega * omega / mode->omega * cavity->sound_speed *
         sqrt(cavity->density / tb_cavity_mode_norm(order, cavity, mode->radial, mode->axial)) * u;
}

double tb_cavity_wall_power(const TbCavityOrder *order, const TbCavity *cavity,
                            const TbAirOrder *air, const double *heads, const double *u,
                            double omega) {
  if (cavity->density == 0.0) return 0.0;          /* no air, no pressure */
  double along[TB_CAVITY_COORDINATES + 1] = {0.0}; /* at the side, by l */
  Wall side = {0.0, 0.0}, ends = {0.0, 0.0};
  uint32_t next = 0, axial = 0;
  for (uint32_t p = 0; p < order->radial_count; p++) {
    double upper = 0.0, lower = 0.0;
    for (uint32_t l = 0; l < order->kept[p]; l++) {
      double pressure;
      if (l == 0 && order->zeros[p] == 0.0) {
        pressure = spring_pressure(order, cavity, air, heads);
      } else {
        pressure = mode_pressure(order, cavity, &order->modes[next], u[next], omega);
        next++;
      }
      lower += pressure;
      upper += l % 2 ? -pressure : pressure;
      along[l] += pressure * order->edges[p];
      if (l >= axial) axial = l + 1;
    }
    add_end(&ends, order, cavity, p, lower);
    add_end(&ends, order, cavity, p, upper);
  }
  for (uint32_t l = 0; l < axial; l++) add_side(&side, order->m, cavity, l, along[l]);
  return absorbed(cavity, &side, &ends, omega);
}

double tb_cavity_mode_decay_rate(const TbCavityOrder *order, const TbCavity *cavity, uint32_t p,
                                 uint32_t l) {
  if (cavity->density == 0.0) return 0.0;
  const TbCavityMode mode = {p, l, tb_cavity_mode_omega(cavity, order->zeros[p], l)};
  const double pressure = mode_pressure(order, cavity, &mode, 1.0, mode.omega);
  Wall side = {0.0, 0.0}, ends = {0.0, 0.0};
  add_side(&side, order->m, cavity, l, pressure * order->edges[p]);
  for (int end = 0; end < 2; end++) add_end(&ends, order, cavity, p, pressure);
  return absorbed(cavity, &side, &ends, mode.omega) / (mode.omega * mode.omega);
}
