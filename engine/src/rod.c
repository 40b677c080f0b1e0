/* SPDX-License-Identifier: MIT */
#include "rod.h"

#include <math.h>

static const double LENGTH = 0.4;                    /* L [m] */
static const double NEAREST = 0.03;                  /* tip and hoop are never closer [m] */
static const double REACH = 0.2, REACH_ACROSS = 0.3; /* ... nor farther apart */
static const double LAG = 0.8e-3;                    /* [s] */

static double clamp(double value, double minimum, double maximum) {
  return value < minimum ? minimum : (value > maximum ? maximum : value);
}

/* C_ij of two places, in distances from the tip, of a rod of mass m = 4 M. */
static double mobility(double mass, double a, double b) {
  const double half = 0.5 * LENGTH, xi_a = half - a, xi_b = half - b;
  return (1.0 + 12.0 * xi_a * xi_b / (LENGTH * LENGTH)) / (4.0 * mass);
}

/* A rod that touches at its tip and at `along` from there. */
static TbRod touching(double mass, double along) {
  return (TbRod){.tip = {.mass = 1.0 / mobility(mass, 0.0, 0.0)},
                 .shaft = {.mass = 1.0 / mobility(mass, along, along)},
                 .cross = mobility(mass, 0.0, along)};
}

TbRod tb_rod_rimshot(const TaborDrumDef *def, double mass, double velocity, double radius,
                     double angle) {
  const double distance = clamp(def->shell.radius - radius, NEAREST, REACH);
  const double along = sqrt(distance * distance + def->hoop.height * def->hoop.height);
  TbRod rod = touching(mass, along);
  rod.tip.radius = def->shell.radius - distance;
  rod.tip.angle = rod.shaft.angle = angle;
  rod.tip.velocity = rod.shaft.velocity = velocity;
  rod.shaft.gap = velocity * LAG;
  return rod;
}

TbRod tb_rod_across(const TaborDrumDef *def, double mass, double velocity, double radius,
                    double angle) {
  const double distance = clamp(def->shell.radius + radius, NEAREST, REACH_ACROSS);
  const double along = sqrt(distance * distance + def->hoop.height * def->hoop.height);
  const double beyond = distance - def->shell.radius; /* of the centre, seen from the hoop */
  TbRod rod = touching(mass, along);
  rod.tip.radius = fabs(beyond);
  rod.tip.angle = beyond >= 0.0 ? angle : angle + 180.0;
  rod.shaft.angle = angle + 180.0;
  rod.shaft.velocity = velocity;
  return rod;
}

double tb_rod_motion(const TbView *view, uint32_t slot, const double *next, const double *now) {
  const TbSlot *s = &view->state->slots[slot];
  const double velocity = (next[slot] - now[slot]) * view->model->sample_rate;
  if (!s->partner) return s->mass * velocity * velocity;
  const uint32_t other = s->partner - 1u;
  const double of_other = (next[other] - now[other]) * view->model->sample_rate;
  const double mass = s->mass, its = view->state->slots[other].mass;
  const double determinant = 1.0 / (mass * its) - s->cross * s->cross;
  return velocity * (velocity / its - s->cross * of_other) / determinant;
}

double tb_rod_pull(const TbView *view, uint32_t slot) {
  const TbSlot *s = &view->state->slots[slot];
  const double k = view->model->time_step;
  return k * k * s->cross * view->solve.force[view->model->wires.stride + s->partner - 1u];
}
