/* SPDX-License-Identifier: MIT */
#include "strikers/rimstroke.h"

#include "strikers/stick.h"

/* Cross-stick: the palm on the head [N s/m]; the force [N] and the resistance [N
 * s/m] of the hand on the shaft. All were fitted to recorded cross-sticks, within 30 to 300 N s/m,
 * 0 to 40 N and 0 to 5 N s/m. */
static const double PALM = 60.0, PRESS = 12.0, RESISTANCE = 1.0;

/* A striker with its serial number, yet to be placed. */
static TbSlot striker_of(TbView *view, const TbStroke *stroke) {
  return (TbSlot){.kind = TB_SLOT_TIP,
                  .id = stroke->id,
                  .serial = ++view->state->strikers.serial,
                  .radius = stroke->radius,
                  .angle = stroke->angle,
                  .striker = {.mass = view->model->def.striker[stroke->striker].mass,
                              .part = 1.0,
                              .velocity = stroke->velocity,
                              .definition = stroke->striker}};
}

static bool strike_hoop(TbView *view, const TbStroke *stroke) {
  const uint32_t slot = tb_pool_obtain(view);
  if (slot == TB_SLOTS) return false;
  TbSlot striker = striker_of(view, stroke);
  striker.on_hoop = 1;
  striker.end.bends = tb_stick_bends(view, stroke->striker);
  tb_pool_put(view, slot, &striker, 0.0);
  return true;
}

/* Two slots, or none. */
static bool obtain_pair(TbView *view, uint32_t pair[2]) {
  pair[0] = tb_pool_obtain(view);
  if (pair[0] == TB_SLOTS) return false;
  *tb_slot(view, pair[0]) = (TbSlot){.kind = TB_SLOT_HAND}; /* hands are not taken away */
  pair[1] = tb_pool_obtain(view);
  *tb_slot(view, pair[0]) = (TbSlot){0};
  return pair[1] < TB_SLOTS;
}

/* One end of the stick, 0 its tip. */
static TbSlot end_of(TbSlot stick, const TbStickContacts *rod, int end, uint32_t other) {
  const TbStickContact *at = end ? &rod->shaft : &rod->tip;
  stick.end.along = at->along;
  stick.striker.mass = at->mass;
  stick.radius = at->radius;
  stick.angle = at->angle;
  stick.striker.velocity = at->velocity;
  stick.on_hoop = end == 1;
  stick.kind = TB_SLOT_END;
  stick.end.other = other;
  stick.end.cross = rod->cross;
  return stick;
}

/* Tip on the head, shaft on the hoop. */
static bool strike_both(TbView *view, const TbStroke *stroke, const TbStickContacts *rod) {
  uint32_t pair[2];
  if (!obtain_pair(view, pair)) return false;
  TbSlot stick = striker_of(view, stroke);
  stick.end.rests = stroke->technique == TABOR_TECHNIQUE_CROSS_STICK;
  stick.end.bends = 1;
  stick.end.grip = stick.end.rests ? TB_GRIP_ACROSS : TB_GRIP_FREE;
  const TbSlot tip = end_of(stick, rod, 0, pair[1]);
  TbSlot shaft = end_of(stick, rod, 1, pair[0]);
  shaft.end.rests = 0;
  if (stick.end.rests) {
    shaft.hold.held = 1;
    shaft.hold.press = PRESS;
    shaft.hold.resistance = RESISTANCE;
  }
  tb_pool_put_pair(view, pair, &tip, &shaft, rod->shaft.gap);
  return true;
}

/* One hand plays cross-sticks: it takes the stick with it. */
static void take_across(TbView *view) {
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    if (tb_slot(view, i)->end.rests) tb_pool_take_away(view, i);
  }
}

/* That of the last cross-stick, or a free slot; TB_SLOTS if none. */
static uint32_t find_palm(const TbView *view) {
  uint32_t free = TB_SLOTS;
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    const TbSlot *s = tb_slot(view, i);
    if (tb_slot_is_palm(s)) return i;
    if (!tb_slot_in_play(s)) free = i;
  }
  return free;
}

/* The hand that lies on the head while the stick in it strikes the hoop. */
static void lay_palm(TbView *view, uint32_t id, const TbStickContact *tip) {
  const uint32_t slot = find_palm(view);
  if (slot == TB_SLOTS || !view->model->def.quality.losses) return;
  const TbSlot palm = {.kind = TB_SLOT_PALM,
                       .id = id,
                       .serial = ++view->state->strikers.serial,
                       .radius = tip->radius,
                       .angle = tip->angle,
                       .resistance = PALM};
  tb_pool_put_hand(view, slot, &palm);
}

bool tb_rimstroke(TbView *view, const TbStroke *stroke) {
  const TaborDrumDef *def = &view->model->def;
  const TbStick *stick = &view->model->stick[stroke->striker];
  if (stroke->technique == TABOR_TECHNIQUE_RIM) return strike_hoop(view, stroke);
  if (stroke->technique == TABOR_TECHNIQUE_RIMSHOT) {
    const TbStickContacts rod =
      tb_stick_rimshot(def, stick, stroke->velocity, stroke->radius, stroke->angle);
    return strike_both(view, stroke, &rod);
  }
  const TbStickContacts rod =
    tb_stick_across(def, stick, stroke->velocity, stroke->radius, stroke->angle);
  take_across(view);
  if (!strike_both(view, stroke, &rod)) return false;
  lay_palm(view, stroke->id, &rod.tip);
  return true;
}
