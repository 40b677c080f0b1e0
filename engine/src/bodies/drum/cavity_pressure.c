/* SPDX-License-Identifier: MIT */
#include "bodies/drum/cavity_pressure.h"

#include <math.h>

#include "definition/definition.h"
#include "math/bessel.h"
#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

bool tb_cavity_mics_prepare(TbCavityMics *mics, TbArena *arena, const TaborDrumDef *def,
                            const TbCavityOrder *order) {
  *mics = (TbCavityMics){.count = 0};
  for (uint32_t i = 0; i < def->mic_count; i++) {
    const TaborMicDef *mic = &def->mic[i];
    if (!tb_mic_is_inside(def, mic)) continue;
    double *shapes = tb_arena_doubles(arena, order->radial_count);
    if (arena->failed) return false;
    for (uint32_t p = 0; p < order->radial_count; p++) {
      shapes[p] = tb_bessel_j(order->m, order->zeros[p] * mic->radius / def->shell.radius);
    }
    mics->index[mics->count] = i;
    mics->height[mics->count] = def->shell.depth + mic->height;
    mics->shapes[mics->count++] = shapes;
  }
  return true;
}

/* Part of a diffuse field's energy that a head lets through, by mass law. */
static double transmission(double head_density, const TbCavity *cavity, double omega) {
  if (head_density == 0.0 || cavity->density == 0.0) return 0.0;
  const double a = omega * head_density / (2.0 * cavity->density * cavity->sound_speed);
  return a > 1e-4 ? tb_log(1.0 + a * a) / (a * a) : 1.0;
}

double tb_cavity_decay_rate(const TbCavity *cavity, double omega) {
  const double k = omega / cavity->sound_speed;
  const double viscous = sqrt(2.0 * TB_KINEMATIC_VISCOSITY / omega);
  const double layers = k * viscous * (0.5 * (TB_HEAT_RATIO - 1.0) / sqrt(TB_PRANDTL) + 1.0 / 3.0);
  const double side = 2.0 / cavity->radius, ends = 2.0 / cavity->depth;
  const double through = transmission(cavity->head_density[0], cavity, omega) +
                         transmission(cavity->head_density[1], cavity, omega);
  return cavity->sound_speed *
         (side * cavity->admittance + (side + ends) * layers + through / (8.0 * cavity->depth));
}

/* ---- axial functions ------------------------------------------------------------------------ */

typedef struct Complex {
  double re, im;
} Complex;

static Complex product(Complex a, Complex b) {
  return (Complex){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

static Complex quotient(Complex a, Complex b) {
  const double square = b.re * b.re + b.im * b.im;
  return (Complex){(a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square};
}

/* The root of z with a real part >= 0, for an imaginary part >= 0. */
static Complex root(Complex z) {
  const double size = tb_hypot(z.re, z.im);
  const double larger = sqrt(0.5 * (size + fabs(z.re)));
  const double smaller = larger > 0.0 ? 0.5 * z.im / larger : 0.0;
  return z.re >= 0.0 ? (Complex){larger, smaller} : (Complex){smaller, larger};
}

/* e^-gx, Re g >= 0. */
static Complex decay(Complex g, double x) {
  double s, c;
  tb_sin_cos(g.im * x, &s, &c);
  const double size = tb_exp(-g.re * x);
  return (Complex){size * c, -size * s};
}

/* cosh(g d)/(g sinh(g L)) */
static Complex all_axial(Complex g, double d, double depth) {
  const Complex near = decay(g, depth - d);
  const Complex far = product(near, decay(g, 2.0 * d)), round = product(near, far);
  const Complex sum = {near.re + far.re, near.im + far.im};
  return quotient(sum, product(g, (Complex){1.0 - round.re, -round.im}));
}

/* G(d) of one radial order, square = g^2. */
static Complex rest_of_axial(Complex square, uint32_t kept, double d, double depth) {
  Complex sum = all_axial(root(square), d, depth);
  for (uint32_t l = 0; l < kept; l++) {
    const double axial = (double)l * PI / depth;
    const double shape = (l % 2 ? -1.0 : 1.0) * tb_cos(axial * d) / ((l ? 0.5 : 1.0) * depth);
    const Complex one =
      quotient((Complex){shape, 0.0}, (Complex){square.re + axial * axial, square.im});
    sum.re -= one.re;
    sum.im -= one.im;
  }
  return sum;
}

/* ---- one mode ------------------------------------------------------------------------------- */

/* Data that the microphones share. */
typedef struct Motion {
  const TbCavityOrder *order;
  const TbCavity *cavity;
  const double *u;
  double omega, decay_rate, diffuse_rate; /* [rad/s], [1/s] */
} Motion;

/* How the heads drive one radial order. */
typedef struct Drive {
  double upper, lower;       /* S/n' */
  Complex wavenumber_square; /* k^2 */
  double late;               /* the factor for what rings on */
} Drive;

/* Half the difference of frequencies [rad/s] into which a mode of radial order `p`, l > 0, and the
 * heads' motion, of unit modal mass, split where they coincide. */
static double coupling(const Motion *m, uint32_t p, double upper, double lower) {
  const TbCavity *c = m->cavity;
  const double area = tb_cavity_azimuth(m->order->m) * c->radius * c->radius;
  const double norm = 0.5 * c->depth * m->order->norms[p];
  return 0.5 * c->sound_speed * sqrt(c->density * area / norm) * tb_hypot(upper, lower);
}

static Drive drive_of(const Motion *m, uint32_t p, double upper, double lower) {
  const double norm = m->order->norms[p], c = m->cavity->sound_speed, k = m->omega / c;
  const double damping =
    tb_hypot(m->diffuse_rate + m->decay_rate, 2.0 * coupling(m, p, upper, lower));
  const bool rings =
    tb_cavity_mode_omega(m->cavity, m->order->zeros[p], m->order->kept[p]) < m->omega;
  return (Drive){.upper = upper / norm,
                 .lower = lower / norm,
                 .wavenumber_square = {k * k, -2.0 * k * damping / c},
                 .late = rings ? sqrt(1.0 + m->decay_rate / m->diffuse_rate) : 1.0};
}

/* R I of the coordinates of radial order `p`, the first of which is u[next]. */
static double kept_field(const Motion *m, uint32_t p, uint32_t next, double height) {
  double sum = 0.0;
  for (uint32_t l = 0; l < m->order->kept[p]; l++) {
    if (l == 0 && m->order->zeros[p] == 0.0) continue; /* the spring */
    const double norm = tb_cavity_mode_norm(m->order, m->cavity, p, l);
    const double shape = tb_cos((double)l * PI * height / m->cavity->depth);
    sum -= m->cavity->sound_speed /
           (m->order->modes[next].omega * sqrt(m->cavity->density * norm)) * m->u[next] * shape;
    next++;
  }
  return sum;
}

/* G(d) of radial order `p`, the part that rings on times the factor for that. */
static Complex driven(const Motion *m, const Drive *drive, uint32_t p, double d) {
  const double kappa = m->order->zeros[p] / m->cavity->radius, depth = m->cavity->depth;
  const Complex square = {kappa * kappa - drive->wavenumber_square.re,
                          -drive->wavenumber_square.im};
  const Complex all = rest_of_axial(square, m->order->kept[p], d, depth);
  if (drive->late == 1.0 || kappa == 0.0) {
    return (Complex){drive->late * all.re, drive->late * all.im};
  }
  const Complex slow = rest_of_axial((Complex){kappa * kappa, 0.0}, m->order->kept[p], d, depth);
  return (Complex){slow.re + drive->late * (all.re - slow.re), drive->late * all.im};
}

/* R I of the rest of radial order `p`, without J_m. */
static Complex driven_field(const Motion *m, const Drive *drive, uint32_t p, double height) {
  const double depth = m->cavity->depth;
  const Complex still = {0.0, 0.0};
  const Complex above = drive->upper != 0.0 ? driven(m, drive, p, height) : still;
  const Complex below = drive->lower != 0.0 ? driven(m, drive, p, depth - height) : still;
  Complex sum = {-(drive->upper * above.re + drive->lower * below.re),
                 -(drive->upper * above.im + drive->lower * below.im)};
  if (m->order->zeros[p] == 0.0 && m->order->kept[p] > 0) {
    const double c = m->cavity->sound_speed / m->omega;
    sum.re += c * c * (drive->upper + drive->lower) / depth;
  }
  return sum;
}

static double project(const double *s, const double *w, uint32_t n) {
  double sum = 0.0;
  for (uint32_t i = 0; i < n; i++) sum += s[i] * w[i];
  return sum;
}

/* A radial order with less than this at every microphone, of functions that are near 1, is not
 * heard. */
static const double LEAST_SHAPE = 1e-10;

static bool is_heard(const TbCavityMics *mics, uint32_t p) {
  for (uint32_t i = 0; i < mics->count; i++) {
    if (fabs(mics->shapes[i][p]) > LEAST_SHAPE) return true;
  }
  return false;
}

static uint32_t coordinates_of(const TbCavityOrder *order, uint32_t p) {
  const uint32_t kept = order->kept[p];
  return kept > 0 && order->zeros[p] == 0.0 ? kept - 1u : kept;
}

void tb_cavity_fields(const TbCavityMics *mics, const TbCavityOrder *order, const TbCavity *cavity,
                      const TbAirOrder *air, const double *heads, const double *u, double omega,
                      double decay_rate, double *fields) {
  const Motion motion = {order, cavity, u, omega, decay_rate, tb_cavity_decay_rate(cavity, omega)};
  for (uint32_t i = 0; i < mics->count; i++) {
    fields[2 * mics->index[i]] = fields[2 * mics->index[i] + 1] = 0.0;
  }
  uint32_t next = 0;
  for (uint32_t p = 0; p < order->radial_count; next += coordinates_of(order, p++)) {
    if (!is_heard(mics, p)) continue;
    double s[TB_CAVITY_OPENINGS];
    tb_cavity_openings(order, air, p, s);
    const double upper = project(s, heads, air->count);
    const double lower = cavity->heads > 1 ? project(s, heads + air->count, air->count) : 0.0;
    const Drive drive = drive_of(&motion, p, upper, lower);
    for (uint32_t i = 0; i < mics->count; i++) {
      const double shape = mics->shapes[i][p] / cavity->radius;
      const Complex rest = driven_field(&motion, &drive, p, mics->height[i]);
      double *field = fields + 2 * mics->index[i];
      field[0] += shape * (kept_field(&motion, p, next, mics->height[i]) + rest.re);
      field[1] += shape * rest.im;
    }
  }
}
