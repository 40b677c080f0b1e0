/* SPDX-License-Identifier: MIT */
#include "strikers/strokes.h"

#include "strikers/brush.h"
#include "strikers/rimstroke.h"
#include "strikers/stick.h"
#include "strikers/striker_hold.h"

/* ---- strokes -------------------------------------------------------------------------------- */

static const double STICK = 0.4, USUAL_PIVOT = 0.12; /* [m] */

/* Mass at the tip of a rod held at `pivot` from its butt, in units of its mass. */
static double tip_part(double pivot) {
  const double place = pivot / STICK, aside = 0.5 - place, lever = 1.0 - place;
  return (1.0 / 12.0 + aside * aside) / (lever * lever);
}

static double mass_of(const TbView *view, const TbStroke *stroke) {
  const TaborDrumDef *def = &view->model->def;
  const double mass = def->striker[stroke->striker].mass;
  const bool buzz = stroke->technique == TABOR_TECHNIQUE_BUZZ;
  return buzz ? mass * (tip_part(def->hand.pivot) / tip_part(USUAL_PIVOT)) : mass;
}

/* The slot where a hand presses the stick of slot `i`, the shaft's of one that lies across the
 * drum; TB_SLOTS if none presses it. */
static uint32_t pressed_slot(const TbView *view, uint32_t i) {
  const TbSlot *slots = view->state->strikers.slots;
  const bool is_tip = tb_slot_is_end(&slots[i]) && !slots[i].on_hoop;
  const uint32_t at = is_tip ? slots[i].end.other : i;
  return !tb_slot_is_bristles(&slots[at]) && slots[at].hold.held ? at : TB_SLOTS;
}

/* A pressed stick that touches is lifted, everything else is gone at once. */
static void let_go(TbView *view, uint32_t i) {
  const uint32_t at = pressed_slot(view, i);
  if (at == TB_SLOTS || !tb_pool_touches(view, i)) {
    tb_pool_take_away(view, i);
  } else if (!tb_slot(view, at)->hold.leaving) {
    tb_hold_lift(view, at);
  }
}

/* A hand that strikes again lets go of the stick that it pressed. If this stick has not touched
 * yet, its stroke is lost. */
static void free_hand(TbView *view, uint32_t id) {
  for (uint32_t i = 0; i < TB_MUFFLERS && id != 0; i++) {
    const TbSlot *s = tb_slot(view, i);
    if (pressed_slot(view, i) == TB_SLOTS || s->id != id) continue;
    view->state->ledger.statistics.dropped_events += !tb_pool_sounded(view, i);
    let_go(view, i);
  }
}

/* One tip on the head. */
static bool strike_head(TbView *view, const TbStroke *stroke) {
  TbState *state = view->state;
  const uint32_t slot = tb_pool_obtain(view);
  if (slot == TB_SLOTS) return false;
  const TbSlot striker = {.kind = TB_SLOT_TIP,
                          .id = stroke->id,
                          .serial = ++state->strikers.serial,
                          .radius = stroke->radius,
                          .angle = stroke->angle,
                          .striker = {.mass = mass_of(view, stroke),
                                      .part = 1.0,
                                      .velocity = stroke->velocity,
                                      .definition = stroke->striker},
                          .end = {.bends = tb_stick_bends(view, stroke->striker)}};
  tb_pool_put(view, slot, &striker, 0.0);
  if (stroke->technique == TABOR_TECHNIQUE_BUZZ) {
    tb_hold(view, slot, tb_hold_force(stroke->pressure));
  }
  return true;
}

/* A plate has no hoop: such strokes meet the plate. */
static bool on_hoop(const TbView *view, const TbStroke *stroke) {
  if (view->model->body.free_edge) return false;
  return stroke->technique == TABOR_TECHNIQUE_RIMSHOT ||
         stroke->technique == TABOR_TECHNIQUE_CROSS_STICK ||
         stroke->technique == TABOR_TECHNIQUE_RIM;
}

bool tb_strike(TbView *view, const TbStroke *stroke) {
  if (view->model->def.striker[stroke->striker].kind == TABOR_STRIKER_BRUSH &&
      !on_hoop(view, stroke)) {
    return tb_brush_strike(view, stroke);
  }
  if (stroke->technique == TABOR_TECHNIQUE_SWEEP) return false;
  free_hand(view, stroke->id);
  if (!(on_hoop(view, stroke) ? tb_rimstroke(view, stroke) : strike_head(view, stroke)))
    return false;
  view->state->ledger.statistics.strikes++;
  return true;
}

/* ---- hands ---------------------------------------------------------------------------------- */

bool tb_press(TbView *view, uint32_t id, double pressure) {
  bool found = tb_brush_press(view, id, pressure);
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    const TbSlot *s = tb_slot(view, i);
    if (!tb_slot_is_tip(s) || (id != 0 && s->id != id)) continue;
    if (s->on_hoop || s->hold.leaving) continue;
    tb_hold(view, i, tb_hold_force(pressure));
    found = true;
  }
  return found;
}

static uint32_t find_hand(const TbView *view, uint32_t id) {
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    const TbSlot *s = tb_slot(view, i);
    if (tb_slot_is_hand(s) && s->id == id) return i;
  }
  return TB_SLOTS;
}

/* A hand nearer to a free edge than this part of the radius grips it. */
static const double NEAR_EDGE = 0.9;

static bool grips_edge(TbView *view, uint32_t id, double strength, double radius) {
  TbEdgeGrip *edge = &view->state->strikers.edge;
  const TbBody *body = &view->model->body;
  const bool grips = body->free_edge && radius >= NEAR_EDGE * body->radius;
  if (grips) *edge = (TbEdgeGrip){.strength = strength, .held = 1, .id = id};
  if (!grips && id != 0 && edge->id == id) edge->held = 0; /* it has moved inwards */
  return grips;
}

bool tb_damp(TbView *view, uint32_t id, double strength, double radius, double angle) {
  if (grips_edge(view, id, strength, radius)) return true;
  uint32_t slot = id ? find_hand(view, id) : TB_SLOTS;
  if (slot == TB_SLOTS) slot = tb_pool_obtain(view);
  if (slot == TB_SLOTS) return false;
  const TbSlot hand = {.kind = TB_SLOT_HAND,
                       .id = id,
                       .serial = ++view->state->strikers.serial,
                       .radius = radius,
                       .angle = angle,
                       .resistance = strength};
  tb_pool_put_hand(view, slot, &hand);
  return true;
}

void tb_release(TbView *view, uint32_t id) {
  TbEdgeGrip *edge = &view->state->strikers.edge;
  if (id == 0 || edge->id == id) edge->held = 0;
  tb_brush_release(view, id);
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    const TbSlot *s = tb_slot(view, i);
    if (tb_slot_in_play(s) && !s->hold.leaving && (id == 0 || s->id == id)) let_go(view, i);
  }
}

bool tb_move(TbView *view, uint32_t id, double radius, double angle, double seconds) {
  return tb_brush_move(view, id, radius, angle, seconds);
}

void tb_hands_step(TbView *view) { tb_brush_step(view); }

bool tb_hands_move(const TbState *state) { return tb_brush_moves(state); }

/* ---- what is in play ------------------------------------------------------------------------ */

void tb_hands_carry(const TbView *from, TbView *to, double ratio) {
  to->state->strikers.edge = from->state->strikers.edge;
  to->state->strikers.edge.held &= to->model->body.free_edge;
  tb_brush_carry(from, to, ratio);
}

bool tb_striker_is_known(const TaborModel *model, const TbSlot *slot) {
  const TaborStrikerDef *striker = &model->def.striker[slot->striker.definition];
  if (slot->striker.definition >= model->def.striker_count) return false;
  return !tb_slot_is_bristles(slot) || striker->kind == TABOR_STRIKER_BRUSH;
}

uint32_t tb_strikers_in_play(const TbState *state) {
  uint32_t count = tb_brush_count(state) + state->strikers.edge.held;
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    const TbSlot *slot = &state->strikers.slots[i];
    const bool counted = tb_slot_is_end(slot) && slot->end.other < i; /* with that end */
    count += tb_slot_in_play(slot) && !counted;
  }
  return count;
}
