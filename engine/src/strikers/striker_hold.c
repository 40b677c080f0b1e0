/* SPDX-License-Identifier: MIT */
#include "strikers/striker_hold.h"

#include "heads/coupling.h"
#include "math/portable_math.h"
#include "strikers/stick.h"

/* In it a hand lets go and pulls [s]: faster, the head would spring back like a plucked one. */
const double tb_hold_lift_time = 0.03;
static const double LIFT = 0.5; /* so hard it pulls in the end: 5 mm in 16 ms [N] */

/* The force of a hand that presses a stick: at its tip, or at the shaft of one that lies across
 * the drum. */
typedef struct Hand {
  double force, stiffness, damping;
} Hand;

static Hand hand_of(const TbView *view, const TbSlot *s) {
  if (!s->hold.held) return (Hand){0.0, 0.0, 0.0};
  const TaborDrumDef *def = &view->model->def;
  if (tb_slot_is_end(s)) {
    return (Hand){s->hold.press, 0.0, def->quality.losses ? s->hold.resistance : 0.0};
  }
  const double share = 2.0 * s->striker.part * view->state->live.values[TB_LIVE_GRIP].now;
  return (Hand){share * s->hold.press + s->hold.push, share * def->hand.stiffness,
                def->quality.losses ? share * def->hand.damping + s->hold.resistance : 0.0};
}

double tb_hold_compliance(const TbView *view, uint32_t slot) {
  const TbSlot *s = tb_slot(view, slot);
  const double k = view->model->time_step;
  if (tb_slot_is_end(s)) return tb_stick_compliance(view, slot, slot);
  return k * k / (s->striker.mass + 0.5 * hand_of(view, s).damping * k);
}

double tb_hold_free_height(const TbView *view, uint32_t slot) {
  const TbSlot *s = tb_slot(view, slot);
  const double now = view->now.z[slot], last = view->last.z[slot];
  if (tb_slot_is_end(s)) return tb_stick_free_height(view, slot);
  if (!s->hold.held) return 2.0 * now - last;
  const Hand hand = hand_of(view, s);
  const double k = view->model->time_step;
  const double inertia = s->striker.mass / (k * k), damping = hand.damping / (2.0 * k);
  const double pull = hand.force + hand.stiffness * (now - s->hold.anchor);
  return (inertia * (2.0 * now - last) + damping * last - pull) / (inertia + damping);
}

TbHoldWork tb_hold_work(const TbView *view) {
  TbHoldWork work = {0.0, 0.0};
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    const TbSlot *s = tb_slot(view, i);
    work.lost += tb_stick_loss(view, i);
    if (!s->hold.held) continue;
    const Hand hand = hand_of(view, s);
    const double moved = view->next.z[i] - view->last.z[i];
    work.done -= 0.5 * moved * (hand.force + hand.stiffness * (view->now.z[i] - s->hold.anchor));
    work.lost += 0.25 * hand.damping * view->model->step_rate * moved * moved;
  }
  return work;
}

void tb_hold_regrip(TbView *view) {
  bool found = false;
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *s = tb_slot(view, i);
    if (!s->hold.held) continue;
    view->contact_compliance[tb_slot_row(&view->model->rows, i)] = tb_hold_compliance(view, i);
    found = true;
  }
  if (found) tb_coupling_renew(view);
}

double tb_hold_force(double pressure) { return 0.3 * tb_power(8.0 / 0.3, pressure); }

void tb_hold(TbView *view, uint32_t slot, double force) {
  TbSlot *s = tb_slot(view, slot);
  if (!s->hold.held) s->hold.anchor = view->now.z[slot];
  s->hold.held = 1;
  s->hold.press = force;
  view->contact_compliance[tb_slot_row(&view->model->rows, slot)] = tb_hold_compliance(view, slot);
  tb_coupling_renew(view);
}

void tb_hold_lift(TbView *view, uint32_t slot) {
  TbSlot *s = tb_slot(view, slot);
  s->hold.leaving = 1;
  s->id = 0;
  tb_slot(view, tb_slot_other_end(view, slot))->id = 0;
}

/* The rest of a force at the part `u` of the time in which it goes: from 1 to 0 without a kink,
 * which would sound. */
static double left_at(double u) { return u < 1.0 ? (1.0 - u) * (1.0 - u) * (1.0 + 2.0 * u) : 0.0; }

void tb_hold_pull_up(const TbView *view, uint32_t slot) {
  TbHold *hold = &tb_slot(view, slot)->hold;
  const double whole = tb_hold_lift_time * view->model->step_rate;
  if (hold->leaving >= whole) return;
  const double before = left_at(hold->leaving / whole), left = left_at(++hold->leaving / whole);
  hold->press *= left / before;
  hold->push = LIFT * (left - 1.0);
}
