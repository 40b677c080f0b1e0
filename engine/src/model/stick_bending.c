/* SPDX-License-Identifier: MIT */
#include "model/stick_bending.h"

#include <math.h>
#include <string.h>

#include "math/eigen.h"
#include "math/portable_math.h"
#include "math/quadrature.h"
#include "model/modes.h"

const double tb_stick_length = 0.4;

static const double PI = 3.14159265358979323846;
static const double TAPER = 0.2, NECK = 0.5; /* of the length; of the diameter */
static const double FINGERS = 0.03;          /* of a hand that holds a stick [kg] */
static const double AT_TIP = 0.2;            /* ... and of one that holds a tip [kg] */
static const double DECAY = 100.0;           /* in a hand [1/s] */
static const double FASTEST = 0.35;          /* of the sample rate */

enum { TERMS = 16, RIGID = 2, PART = 2 * TB_PANEL, POINTS = 2 * PART };

/* The beam with L = 1 and mu = B = 1 where it is thickest. */
typedef struct Beam {
  double mass[TERMS * TERMS], stiffness[TERMS * TERMS];
  double moment[3]; /* Int mu x^n dx */
} Beam;

typedef struct Modes {
  double square[TERMS];        /* w^2 */
  double vector[TERMS][TERMS]; /* one in each row */
} Modes;

static double diameter(double x) { return x < TAPER ? NECK + (1.0 - NECK) * x / TAPER : 1.0; }

/* Legendre polynomials in 2 x - 1, and their second derivatives in x. */
static void polynomials(double x, double *value, double *curve) {
  const double t = 2.0 * x - 1.0;
  double slope[TERMS] = {0.0, 2.0};
  value[0] = 1.0;
  value[1] = t;
  curve[0] = curve[1] = 0.0;
  for (uint32_t n = 2; n < TERMS; n++) {
    const double odd = 2.0 * n - 1.0;
    value[n] = (odd * t * value[n - 1] - (n - 1.0) * value[n - 2]) / n;
    slope[n] = slope[n - 2] + 2.0 * odd * value[n - 1];
    curve[n] = curve[n - 2] + 2.0 * odd * slope[n - 1];
  }
}

static void add_product(double *matrix, double factor, const double *v) {
  for (uint32_t i = 0; i < TERMS; i++) {
    for (uint32_t j = 0; j < TERMS; j++) matrix[i * TERMS + j] += factor * v[i] * v[j];
  }
}

static void prepare_beam(Beam *beam) {
  double x[POINTS], weight[POINTS];
  tb_quadrature(0.0, TAPER, PART / TB_PANEL, x, weight);
  tb_quadrature(TAPER, 1.0, PART / TB_PANEL, x + PART, weight + PART);
  *beam = (Beam){.moment = {0.0}};
  for (uint32_t i = 0; i < POINTS; i++) {
    double value[TERMS], curve[TERMS];
    polynomials(x[i], value, curve);
    const double area = diameter(x[i]) * diameter(x[i]), mass = weight[i] * area;
    add_product(beam->mass, mass, value);
    add_product(beam->stiffness, mass * area, curve);
    beam->moment[0] += mass;
    beam->moment[1] += mass * x[i];
    beam->moment[2] += mass * x[i] * x[i];
  }
}

/* Modes of the beam with a point mass at `place`; positive at the butt. */
static bool solve(TbArena *scratch, const Beam *beam, double point, double place, Modes *modes) {
  double mass[TERMS * TERMS], stiffness[TERMS * TERMS], value[TERMS], curve[TERMS];
  memcpy(mass, beam->mass, sizeof mass);
  memcpy(stiffness, beam->stiffness, sizeof stiffness);
  polynomials(place, value, curve);
  add_product(mass, point, value);
  if (!tb_eigen_symmetric(scratch, TERMS, stiffness, mass, modes->square, modes->vector[0]))
    return false;
  for (uint32_t i = 0; i < TERMS; i++) {
    double butt = 0.0; /* every polynomial is 1 there */
    for (uint32_t n = 0; n < TERMS; n++) butt += modes->vector[i][n];
    if (butt >= 0.0) continue;
    for (uint32_t n = 0; n < TERMS; n++) modes->vector[i][n] = -modes->vector[i][n];
  }
  return true;
}

static void prepare_shape(TbStickBody *body, uint32_t i, const double *vector, double scale) {
  for (uint32_t cell = 0; cell <= TB_STICK_CELLS; cell++) {
    double value[TERMS], curve[TERMS], sum = 0.0;
    polynomials((double)cell / TB_STICK_CELLS, value, curve);
    for (uint32_t n = 0; n < TERMS; n++) sum += vector[n] * value[n];
    body->shape[i][cell] = scale * sum;
  }
}

/* A mode faster than the rate can follow keeps phi^2/w^2. */
static void prepare_mode(TbStickBody *body, uint32_t i, double omega, const double *vector,
                         double scale, double time_step, bool losses) {
  const double turn = fmin(omega, 2.0 * PI * FASTEST / time_step);
  const TbPole pole = tb_pole(turn, losses ? DECAY : 0.0, time_step);
  body->a[i] = pole.a;
  body->b[i] = pole.b;
  body->g[i] = pole.g;
  body->stiffness[i] = pole.stiffness;
  body->loss[i] = pole.loss;
  prepare_shape(body, i, vector, scale * turn / omega);
}

static void prepare_moments(TbStickBody *body, const Beam *beam, double mass, double point,
                            double place) {
  const double length = tb_stick_length;
  body->mass = mass * beam->moment[0] + point;
  body->first = length * (mass * beam->moment[1] + point * place);
  body->second = length * length * (mass * beam->moment[2] + point * place * place);
}

bool tb_stick_prepare(TbStick *stick, TbArena *scratch, const TaborStrikerDef *def,
                      double time_step, bool losses) {
  Beam beam;
  Modes modes[TB_GRIPS];
  prepare_beam(&beam);
  *stick = (TbStick){0};
  const double *m = beam.moment;
  const double mass = def->mass * m[2] / (m[0] * m[2] - m[1] * m[1]); /* L mu, thickest [kg] */
  const double point[TB_GRIPS] = {FINGERS, 0.0, AT_TIP}, place[TB_GRIPS] = {m[2] / m[1], 0.0, 0.0};
  for (uint32_t grip = 0; grip < TB_GRIPS; grip++) {
    prepare_moments(&stick->grip[grip], &beam, mass, point[grip], place[grip]);
    if (def->bending_frequency > 0.0 &&
        !solve(scratch, &beam, point[grip] / mass, place[grip], &modes[grip]))
      return false;
  }
  if (def->bending_frequency == 0.0) return true;
  const double unit = 2.0 * PI * def->bending_frequency / sqrt(modes[TB_GRIP_FREE].square[RIGID]);
  for (uint32_t grip = 0; grip < TB_GRIPS; grip++) {
    for (uint32_t i = 0; i < TB_BENDS; i++) {
      prepare_mode(&stick->grip[grip], i, unit * sqrt(modes[grip].square[RIGID + i]),
                   modes[grip].vector[RIGID + i], 1.0 / sqrt(mass), time_step, losses);
    }
  }
  return true;
}

/* ---- on the audio thread -------------------------------------------------------------------- */

void tb_stick_shape(const TbStickBody *body, double along, double *phi) {
  const double place = along / tb_stick_length * TB_STICK_CELLS;
  uint32_t cell = (uint32_t)place;
  if (cell >= TB_STICK_CELLS) cell = TB_STICK_CELLS - 1u;
  const double part = place - (double)cell;
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    const double *at = &body->shape[i][cell];
    phi[i] = at[0] + part * (at[1] - at[0]);
  }
}

void tb_stick_carry(const TbStickBody *from, const TbStickBody *to, double *now, double *last) {
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    tb_pole_carry(from->a[i], from->b[i], to->a[i], to->b[i], &now[i], &last[i]);
  }
}
