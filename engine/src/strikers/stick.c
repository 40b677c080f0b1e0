/* SPDX-License-Identifier: MIT */
#include "strikers/stick.h"

#include <math.h>

static const double NEAREST = 0.03;                  /* tip and hoop are never closer [m] */
static const double REACH = 0.2, REACH_ACROSS = 0.3; /* ... nor farther apart */
static const double LAG = 0.8e-3;                    /* [s] */

static double clamp(double value, double minimum, double maximum) {
  return value < minimum ? minimum : (value > maximum ? maximum : value);
}

/* C_ij of two places, in distances from the tip. In height and angle at the tip, twice the kinetic
 * energy is mass v^2 + 2 first v w + second w^2; C_ij is (1, x_i) in its inverse. */
static double mobility(const TbStickBody *body, double a, double b) {
  return (body->second - body->first * (a + b) + body->mass * a * b) /
         (body->mass * body->second - body->first * body->first);
}

/* A stick that touches at its tip and at `along` from there. */
static TbStickContacts touching(const TbStickBody *body, double along) {
  return (TbStickContacts){.tip = {.mass = 1.0 / mobility(body, 0.0, 0.0)},
                           .shaft = {.mass = 1.0 / mobility(body, along, along), .along = along},
                           .cross = mobility(body, 0.0, along)};
}

TbStickContacts tb_stick_rimshot(const TaborDrumDef *def, const TbStick *stick, double velocity,
                                 double radius, double angle) {
  const double distance = clamp(def->shell.radius - radius, NEAREST, REACH);
  const double along = sqrt(distance * distance + def->hoop.height * def->hoop.height);
  TbStickContacts rod = touching(&stick->grip[TB_GRIP_FREE], along);
  rod.tip.radius = def->shell.radius - distance;
  rod.tip.angle = rod.shaft.angle = angle;
  rod.tip.velocity = rod.shaft.velocity = velocity;
  rod.shaft.gap = velocity * LAG;
  return rod;
}

TbStickContacts tb_stick_across(const TaborDrumDef *def, const TbStick *stick, double velocity,
                                double radius, double angle) {
  const double distance = clamp(def->shell.radius + radius, NEAREST, REACH_ACROSS);
  const double along = sqrt(distance * distance + def->hoop.height * def->hoop.height);
  const double beyond = distance - def->shell.radius; /* of the centre, seen from the hoop */
  TbStickContacts rod = touching(&stick->grip[TB_GRIP_ACROSS], along);
  rod.tip.radius = fabs(beyond);
  rod.tip.angle = beyond >= 0.0 ? angle : angle + 180.0;
  rod.shaft.angle = angle + 180.0;
  rod.shaft.velocity = velocity;
  return rod;
}

/* ---- bending -------------------------------------------------------------------------------- */

/* The slot that has the state: the tip's, or that of a stick with one contact. */
static uint32_t state_of(const TbView *view, uint32_t slot) {
  const TbSlot *s = tb_slot(view, slot);
  return tb_slot_is_end(s) && s->on_hoop ? s->end.other : slot;
}

static bool has_state(const TbView *view, uint32_t slot) {
  return tb_slot(view, slot)->end.bends && state_of(view, slot) == slot;
}

bool tb_stick_bends(const TbView *view, uint32_t striker) {
  return view->model->def.striker[striker].kind == TABOR_STRIKER_STICK;
}

const TbStickBody *tb_stick_body(const TbView *view, uint32_t slot) {
  const TbSlot *s = tb_slot(view, slot);
  return &view->model->stick[s->striker.definition].grip[s->end.grip];
}

void tb_stick_place(TbView *view, uint32_t slot) {
  TbSlot *s = tb_slot(view, slot);
  if (s->end.bends) tb_stick_shape(tb_stick_body(view, slot), s->end.along, s->end.bend);
}

void tb_stick_step(TbView *view) {
  for (uint32_t slot = 0; slot < TB_MUFFLERS; slot++) {
    if (!has_state(view, slot)) continue;
    const TbStickBody *body = tb_stick_body(view, slot);
    for (uint32_t i = 0; i < TB_BENDS; i++) {
      view->next.bow[slot][i] =
        body->a[i] * view->now.bow[slot][i] - body->b[i] * view->last.bow[slot][i];
    }
  }
}

double tb_stick_bow(const TbView *view, uint32_t slot, const TbPhase *phase) {
  const double *bow = phase->bow[state_of(view, slot)];
  const double *bend = tb_slot(view, slot)->end.bend;
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_BENDS; i++) sum += bend[i] * bow[i];
  return sum;
}

void tb_stick_press(TbView *view, uint32_t slot, double force) {
  const uint32_t tip = state_of(view, slot);
  const TbStickBody *body = tb_stick_body(view, slot);
  const double *bend = tb_slot(view, slot)->end.bend;
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    view->next.bow[tip][i] += force * (body->g[i] * bend[i]);
  }
}

double tb_stick_flexibility(const TbView *view, uint32_t slot, uint32_t other) {
  const TbStickBody *body = tb_stick_body(view, slot);
  const double *a = tb_slot(view, slot)->end.bend, *b = tb_slot(view, other)->end.bend;
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_BENDS; i++) sum += a[i] * (body->g[i] * b[i]);
  return sum;
}

double tb_stick_bending(const TbView *view, uint32_t slot, const TbPhase *next,
                        const TbPhase *now) {
  if (!has_state(view, slot)) return 0.0;
  const TbStickBody *body = tb_stick_body(view, slot);
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    const double q1 = next->bow[slot][i], q0 = now->bow[slot][i];
    const double velocity = (q1 - q0) * view->model->step_rate;
    sum += velocity * velocity + body->stiffness[i] * q1 * q0;
  }
  return 0.5 * sum;
}

double tb_stick_loss(const TbView *view, uint32_t slot) {
  if (!has_state(view, slot)) return 0.0;
  const TbStickBody *body = tb_stick_body(view, slot);
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    const double moved = view->next.bow[slot][i] - view->last.bow[slot][i];
    sum += body->loss[i] * moved * moved;
  }
  return sum;
}

/* ---- motion --------------------------------------------------------------------------------- */

double tb_stick_motion(const TbView *view, uint32_t slot, const double *next, const double *now) {
  const TbSlot *s = tb_slot(view, slot);
  const double velocity = (next[slot] - now[slot]) * view->model->step_rate;
  if (!tb_slot_is_end(s)) return s->striker.mass * velocity * velocity;
  const uint32_t other = s->end.other;
  const double of_other = (next[other] - now[other]) * view->model->step_rate;
  const double mass = s->striker.mass, its = tb_slot(view, other)->striker.mass;
  const double determinant = 1.0 / (mass * its) - s->end.cross * s->end.cross;
  return velocity * (velocity / its - s->end.cross * of_other) / determinant;
}

static uint32_t shaft_of(const TbView *view, uint32_t slot) {
  const TbSlot *s = tb_slot(view, slot);
  return s->on_hoop ? slot : s->end.other;
}

/* c of the hand that presses this shaft [N s/m]. */
static double resistance_of(const TbView *view, const TbSlot *shaft) {
  return view->model->def.quality.losses ? shaft->hold.resistance : 0.0;
}

/* w = k c C_ss/2. The damper, centred, makes of C_ij: C_ij - C_is C_sj (w/C_ss)/(1 + w). */
static double resisted(const TbView *view, const TbSlot *shaft) {
  return 0.5 * view->model->time_step * resistance_of(view, shaft) / shaft->striker.mass;
}

double tb_stick_compliance(const TbView *view, uint32_t slot, uint32_t other) {
  const TbSlot *s = tb_slot(view, slot);
  const TbSlot *shaft = tb_slot(view, shaft_of(view, slot));
  const double k = view->model->time_step, w = resisted(view, shaft);
  if (slot != other) return k * k * s->end.cross / (1.0 + w);
  if (s == shaft) return k * k / (s->striker.mass * (1.0 + w));
  return k * k / s->striker.mass -
         k * k * s->end.cross * s->end.cross * shaft->striker.mass * w / (1.0 + w);
}

double tb_stick_free_height(const TbView *view, uint32_t slot) {
  const uint32_t at = shaft_of(view, slot);
  const TbSlot *shaft = tb_slot(view, at);
  const double *now = view->now.z, *last = view->last.z;
  const double k = view->model->time_step, w = resisted(view, shaft);
  const double next =
    (2.0 * now[at] - (1.0 - w) * last[at] - k * k * shaft->hold.press / shaft->striker.mass) /
    (1.0 + w);
  if (slot == at) return next;
  const double hand =
    shaft->hold.press + resistance_of(view, shaft) * (next - last[at]) / (2.0 * k);
  return 2.0 * now[slot] - last[slot] - k * k * shaft->end.cross * hand;
}

double tb_stick_pull(const TbView *view, uint32_t slot) {
  const uint32_t other = tb_slot(view, slot)->end.other;
  return tb_stick_compliance(view, slot, other) *
         view->solve.warm.force[tb_slot_row(&view->model->rows, other)];
}
