/* SPDX-License-Identifier: MIT */
#include "model/stick_bending.h"

#include <math.h>

#include "math/eigen.h"
#include "math/portable_math.h"
#include "math/quadrature.h"
#include "model/modes.h"

const double tb_stick_length = 0.4;

static const double PI = 3.14159265358979323846;
static const double TAPER = 0.2, NECK = 0.5; /* of the length; of the diameter */
static const double FINGERS = 0.03; /* mass of the fingers that hold a stick where it turns [kg] */
static const double HAND = 1.0;     /* of a cross-stick [kg] */
static const double HAND_PLACE = 0.1875; /* of the length, from the tip on */
static const double DECAY = 100.0;       /* decay rate of a stick's modes in a hand [1/s] */
static const double FASTEST = 0.35;      /* largest frequency of a mode, over the sample rate */

enum { TERMS = 16, RIGID = 2, PART = 2 * TB_PANEL, POINTS = 2 * PART };

/* The free beam with L = 1, and mu = B = 1 where it is thickest. */
typedef struct Beam {
  double moment[3];            /* Int mu x^n dx */
  double square[TERMS];        /* w^2 */
  double vector[TERMS][TERMS]; /* one mode in each row */
} Beam;

/* Some modes of the beam in a hand. */
typedef struct Modes {
  double square[TB_BENDS], vector[TB_BENDS][TERMS];
} Modes;

static double diameter(double x) { return x < TAPER ? NECK + (1.0 - NECK) * x / TAPER : 1.0; }

/* Legendre polynomials in 2 x - 1, normalized on (0, 1), and their second derivatives in x. */
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
  for (uint32_t n = 0; n < TERMS; n++) {
    value[n] *= sqrt(2.0 * n + 1.0);
    curve[n] *= sqrt(2.0 * n + 1.0);
  }
}

/* Value of a sum of these polynomials. */
static double height(const double *vector, double x) {
  double value[TERMS], curve[TERMS], sum = 0.0;
  polynomials(x, value, curve);
  for (uint32_t n = 0; n < TERMS; n++) sum += vector[n] * value[n];
  return sum;
}

static void add_product(double *matrix, double factor, const double *v) {
  for (uint32_t i = 0; i < TERMS; i++) {
    for (uint32_t j = 0; j < TERMS; j++) matrix[i * TERMS + j] += factor * v[i] * v[j];
  }
}

static bool prepare_beam(TbArena *scratch, Beam *beam) {
  double mass[TERMS * TERMS] = {0.0}, stiffness[TERMS * TERMS] = {0.0};
  double x[POINTS], weight[POINTS], value[TERMS], curve[TERMS];
  tb_quadrature(0.0, TAPER, PART / TB_PANEL, x, weight);
  tb_quadrature(TAPER, 1.0, PART / TB_PANEL, x + PART, weight + PART);
  *beam = (Beam){.moment = {0.0}};
  for (uint32_t i = 0; i < POINTS; i++) {
    const double area = diameter(x[i]) * diameter(x[i]), part = weight[i] * area;
    polynomials(x[i], value, curve);
    add_product(mass, part, value);
    add_product(stiffness, part * area, curve);
    beam->moment[0] += part;
    beam->moment[1] += part * x[i];
    beam->moment[2] += part * x[i] * x[i];
  }
  return tb_eigen_symmetric(scratch, TERMS, stiffness, mass, beam->square, beam->vector[0]);
}

/* With a mass m at x, a mode of square w^2 has the part v_k(x)/(w_k^2 - w^2) of each free mode, and
 *   1 + m Sum_rigid v_k^2 - m w^2 Sum_bending v_k^2/(w_k^2 - w^2) = 0.
 * The left side falls without bound below each free mode, so one root lies between two of them. */
static double excess(const Beam *beam, const double *at, double point, double square) {
  double sum = 1.0 + point * (at[0] * at[0] + at[1] * at[1]);
  for (uint32_t k = RIGID; k < TERMS; k++) {
    sum -= point * square * at[k] * at[k] / (beam->square[k] - square);
  }
  return sum;
}

static double loaded_square(const Beam *beam, const double *at, double point, uint32_t i) {
  double low = i ? beam->square[RIGID + i - 1] : 0.0, high = beam->square[RIGID + i];
  for (int step = 0; step < 60; step++) {
    const double middle = 0.5 * (low + high);
    if (excess(beam, at, point, middle) > 0.0) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

/* From the parts of the free modes: a vector of unit mass, positive at the butt. */
static void combine(const Beam *beam, const double *at, double point, const double *part,
                    double *vector) {
  double mass = 0.0, moved = 0.0;
  for (uint32_t n = 0; n < TERMS; n++) vector[n] = 0.0;
  for (uint32_t k = 0; k < TERMS; k++) {
    mass += part[k] * part[k];
    moved += part[k] * at[k];
    for (uint32_t n = 0; n < TERMS; n++) vector[n] += part[k] * beam->vector[k][n];
  }
  const double sign = height(vector, 1.0) < 0.0 ? -1.0 : 1.0;
  const double scale = sign / sqrt(mass + point * moved * moved);
  for (uint32_t n = 0; n < TERMS; n++) vector[n] *= scale;
}

/* Modes with a point mass at `place`. */
static void load(const Beam *beam, double point, double place, Modes *modes) {
  double at[TERMS], part[TERMS];
  for (uint32_t k = 0; k < TERMS; k++) at[k] = height(beam->vector[k], place);
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    const bool free = point == 0.0;
    const double square = free ? beam->square[RIGID + i] : loaded_square(beam, at, point, i);
    for (uint32_t k = 0; k < TERMS; k++) {
      const double own = k < RIGID ? 0.0 : beam->square[k];
      part[k] = free ? (double)(k == RIGID + i) : at[k] / (own - square);
    }
    modes->square[i] = square;
    combine(beam, at, point, part, modes->vector[i]);
  }
}

static void prepare_shape(TbStickBody *body, uint32_t i, const double *vector, double scale) {
  for (uint32_t cell = 0; cell <= TB_STICK_CELLS; cell++) {
    body->shape[i][cell] = scale * height(vector, (double)cell / TB_STICK_CELLS);
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

static void prepare_stick(TbStick *stick, const Beam *beam, const TaborStrikerDef *def,
                          double time_step, bool losses) {
  const double *m = beam->moment;
  const double mass = def->mass * m[2] / (m[0] * m[2] - m[1] * m[1]); /* L mu, thickest [kg] */
  const double point[TB_GRIPS] = {FINGERS, 0.0, HAND},
               place[TB_GRIPS] = {m[2] / m[1], 0.0, HAND_PLACE};
  const double unit = 2.0 * PI * def->bending_frequency / sqrt(beam->square[RIGID]);
  for (uint32_t grip = 0; grip < TB_GRIPS; grip++) {
    TbStickBody *body = &stick->grip[grip];
    Modes modes;
    *body = (TbStickBody){.mass = 0.0};
    prepare_moments(body, beam, mass, point[grip], place[grip]);
    if (def->bending_frequency == 0.0) continue;
    load(beam, point[grip] / mass, place[grip], &modes);
    for (uint32_t i = 0; i < TB_BENDS; i++) {
      prepare_mode(body, i, unit * sqrt(modes.square[i]), modes.vector[i], 1.0 / sqrt(mass),
                   time_step, losses);
    }
  }
}

bool tb_sticks_prepare(TbStick *sticks, TbArena *scratch, const TaborDrumDef *def,
                       double time_step) {
  Beam beam;
  if (!prepare_beam(scratch, &beam)) return false;
  for (uint32_t i = 0; i < def->striker_count; i++) {
    prepare_stick(&sticks[i], &beam, &def->striker[i], time_step, def->quality.losses != 0);
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

void tb_stick_carry(const TbStickBody *from, const TbStickBody *to, double ratio, double *now,
                    double *last) {
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    tb_pole_carry(from->a[i], from->b[i], to->a[i], to->b[i], ratio, &now[i], &last[i]);
  }
}
