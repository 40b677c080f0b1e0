/* SPDX-License-Identifier: MIT */
#include "step/stick_rigid.h"

#include <math.h>

static const double NEAREST = 0.03;                  /* tip and hoop are never closer [m] */
static const double REACH = 0.2, REACH_ACROSS = 0.3; /* ... nor farther apart */
static const double LAG = 0.8e-3;                    /* [s] */
static const double FINGERS = 0.2;                   /* of a hand that holds a tip [kg] */

static double clamp(double value, double minimum, double maximum) {
  return value < minimum ? minimum : (value > maximum ? maximum : value);
}

/* C_ij of two places, in distances from the tip, of a rod of mass m with h more at its tip. Of tip and angle,
 * twice the kinetic energy is (m + h) v^2 + m L v w + (m L^2/3) w^2; C_ij is (1, x_i) in its inverse. */
static double mobility(double m, double h, double a, double b) {
  const double first = 0.5 * m * tb_stick_bending_length,
               second = m * tb_stick_bending_length * tb_stick_bending_length / 3.0;
  return (second - first * (a + b) + (m + h) * a * b) / ((m + h) * second - first * first);
}

/* A rod, of mass M at its tip and h more there, that touches at its tip and at `along` from there. */
static TbRigidStick touching(double mass, double h, double along) {
  const double m = 4.0 * mass;
  return (TbRigidStick){.tip = {.mass = 1.0 / mobility(m, h, 0.0, 0.0)},
                        .shaft = {.mass = 1.0 / mobility(m, h, along, along), .along = along},
                        .cross = mobility(m, h, 0.0, along)};
}

TbRigidStick tb_rigid_stick_rimshot(const TaborDrumDef *def, double mass, double velocity,
                                    double radius, double angle) {
  const double distance = clamp(def->shell.radius - radius, NEAREST, REACH);
  const double along = sqrt(distance * distance + def->hoop.height * def->hoop.height);
  TbRigidStick rod = touching(mass, 0.0, along);
  rod.tip.radius = def->shell.radius - distance;
  rod.tip.angle = rod.shaft.angle = angle;
  rod.tip.velocity = rod.shaft.velocity = velocity;
  rod.shaft.gap = velocity * LAG;
  return rod;
}

TbRigidStick tb_rigid_stick_across(const TaborDrumDef *def, double mass, double velocity,
                                   double radius, double angle) {
  const double distance = clamp(def->shell.radius + radius, NEAREST, REACH_ACROSS);
  const double along = sqrt(distance * distance + def->hoop.height * def->hoop.height);
  const double beyond = distance - def->shell.radius; /* of the centre, seen from the hoop */
  TbRigidStick rod = touching(mass, FINGERS, along);
  rod.tip.radius = fabs(beyond);
  rod.tip.angle = beyond >= 0.0 ? angle : angle + 180.0;
  rod.shaft.angle = angle + 180.0;
  rod.shaft.velocity = velocity;
  return rod;
}

/* ---- bending -------------------------------------------------------------------------------- */

/* The tip's slot, which has the state. */
static uint32_t tip_of(const TbView *view, uint32_t slot) {
  const TbSlot *s = &view->state->slots[slot];
  return s->on_hoop ? s->partner - 1u : slot;
}

static const TbBends *bends_of(const TbView *view, uint32_t tip) {
  const TbStickBending *stick = &view->model->stick;
  return view->state->slots[tip].rests ? &stick->pinned : &stick->free;
}

static bool is_tip(const TbView *view, uint32_t slot) {
  const TbSlot *s = &view->state->slots[slot];
  return s->partner && !s->on_hoop;
}

void tb_rigid_stick_bend(const TbView *view, const TbSlot *slot, double along, double *bend) {
  const TbStickBending *stick = &view->model->stick;
  tb_stick_bending_shape(slot->rests ? &stick->pinned : &stick->free, along, bend);
  const double mass = 4.0 * view->model->def.striker[slot->definition].mass;
  for (uint32_t i = 0; i < TB_BENDS; i++) bend[i] /= sqrt(mass);
}

void tb_rigid_stick_step(TbView *view) {
  for (uint32_t slot = 0; slot < TB_MUFFLERS; slot++) {
    if (!is_tip(view, slot)) continue;
    const TbBends *bends = bends_of(view, slot);
    for (uint32_t i = 0; i < TB_BENDS; i++) {
      view->next.bow[slot][i] =
        bends->a[i] * view->now.bow[slot][i] - bends->b[i] * view->last.bow[slot][i];
    }
  }
}

double tb_rigid_stick_bow(const TbView *view, uint32_t slot, const TbPhase *phase) {
  const double *bow = phase->bow[tip_of(view, slot)];
  const double *bend = view->state->slots[slot].bend;
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_BENDS; i++) sum += bend[i] * bow[i];
  return sum;
}

void tb_rigid_stick_press(TbView *view, uint32_t slot, double force) {
  const uint32_t tip = tip_of(view, slot);
  const TbBends *bends = bends_of(view, tip);
  const double *bend = view->state->slots[slot].bend;
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    view->next.bow[tip][i] += force * (bends->g[i] * bend[i]);
  }
}

double tb_rigid_stick_flexibility(const TbView *view, uint32_t slot, uint32_t other) {
  const TbBends *bends = bends_of(view, tip_of(view, slot));
  const double *a = view->state->slots[slot].bend, *b = view->state->slots[other].bend;
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_BENDS; i++) sum += a[i] * (bends->g[i] * b[i]);
  return sum;
}

double tb_rigid_stick_bending(const TbView *view, uint32_t slot, const TbPhase *next,
                              const TbPhase *now) {
  if (!is_tip(view, slot)) return 0.0;
  const TbBends *bends = bends_of(view, slot);
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    const double q1 = next->bow[slot][i], q0 = now->bow[slot][i];
    const double velocity = (q1 - q0) * view->model->sample_rate;
    sum += velocity * velocity + bends->stiffness[i] * q1 * q0;
  }
  return 0.5 * sum;
}

double tb_rigid_stick_loss(const TbView *view, uint32_t slot) {
  if (!is_tip(view, slot)) return 0.0;
  const TbBends *bends = bends_of(view, slot);
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    const double moved = view->next.bow[slot][i] - view->last.bow[slot][i];
    sum += bends->loss[i] * moved * moved;
  }
  return sum;
}

/* ---- motion --------------------------------------------------------------------------------- */

double tb_rigid_stick_motion(const TbView *view, uint32_t slot, const double *next,
                             const double *now) {
  const TbSlot *s = &view->state->slots[slot];
  const double velocity = (next[slot] - now[slot]) * view->model->sample_rate;
  if (!s->partner) return s->mass * velocity * velocity;
  const uint32_t other = s->partner - 1u;
  const double of_other = (next[other] - now[other]) * view->model->sample_rate;
  const double mass = s->mass, its = view->state->slots[other].mass;
  const double determinant = 1.0 / (mass * its) - s->cross * s->cross;
  return velocity * (velocity / its - s->cross * of_other) / determinant;
}

double tb_rigid_stick_pull(const TbView *view, uint32_t slot) {
  const TbSlot *s = &view->state->slots[slot];
  const double k = view->model->time_step;
  return k * k * s->cross * view->solve.warm.force[view->model->wires.stride + s->partner - 1u];
}
