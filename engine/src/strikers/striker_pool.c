/* SPDX-License-Identifier: MIT */
#include "strikers/striker_pool.h"

#include <string.h>

#include "air/high_band_step.h"
#include "heads/coupling.h"
#include "heads/moving_modes.h"
#include "math/portable_math.h"
#include "strikers/stick.h"
#include "strikers/striker_hold.h"

static const double AWAY = 0.005; /* [m] */
/* [m]: the tip of a stick that has turned by 45 degrees about a hand 0.28 m away from it */
static const double OUT_OF_HAND = 0.2;
static const double LINGER = 1.0;         /* [s] */
static const double PALM_TIME = 0.3;      /* [s] */
static const double PALM_LIFT_TIME = 0.1; /* [s], the last part of it */
static const double HERTZ = 1.5;          /* round wood on a round edge */

static bool in_play(const TbView *view, uint32_t slot) {
  return tb_slot_in_play(tb_slot(view, slot));
}

/* Compliance that two slots in play share besides the drum over one step: the stick. */
static double shared_compliance(const TbView *view, uint32_t slot, uint32_t other) {
  const TbSlot *a = tb_slot(view, slot);
  double sum = 0.0;
  const bool ends = tb_slot_is_end(a) && a->end.other == other;
  if (ends) sum += tb_stick_compliance(view, slot, other);
  if (a->end.bends && (slot == other || ends)) {
    sum += tb_stick_flexibility(view, slot, other);
  }
  return sum;
}

static void set_coupling(TbView *view, uint32_t slot, uint32_t other, double value) {
  view->strikers.slot_coupling[slot * TB_SLOTS + other] = value;
  view->strikers.slot_coupling[other * TB_SLOTS + slot] = value;
}

/* The lower slot's drive on the higher one's shape: the same bits whoever came first. */
static double modal_coupling(const TbView *view, uint32_t slot, uint32_t other) {
  const uint32_t low = other < slot ? other : slot, high = other < slot ? slot : other;
  const double *drive = tb_slot_drive(view, low), *shape = tb_slot_shape(view, high);
  return view->model->kernels->dot(view->model->modes.padded, drive, shape);
}

/* Sum x y over the modes of these ranges that move. */
static double dot_of_moving(const TbView *view, TbModeRanges modes, const double *x,
                            const double *y) {
  double sum = 0.0;
  for (uint32_t part = 0; part < view->moving.count; part++) {
    const uint32_t from = view->moving.from[part], count = view->moving.end[part] - from;
    if (tb_modes_have(modes, from)) sum += view->model->kernels->dot(count, x + from, y + from);
  }
  return sum;
}

/* modal_coupling() by the modes that move. */
static double moving_coupling(const TbView *view, uint32_t slot, uint32_t other) {
  return dot_of_moving(view, tb_modes_all(&view->model->modes), tb_slot_drive(view, slot),
                       tb_slot_shape(view, other));
}

/* Between the mufflers, the only slots in play while modes rest. */
static void couple_mufflers(TbView *view, double (*coupling)(const TbView *, uint32_t, uint32_t)) {
  for (uint32_t i = TB_MUFFLERS; i < TB_MUFFLERS + TB_HEADS; i++) {
    for (uint32_t j = TB_MUFFLERS; j <= i; j++) {
      if (in_play(view, i) && in_play(view, j)) set_coupling(view, i, j, coupling(view, i, j));
    }
  }
}

void tb_pool_wake(TbView *view, const double *shape) {
  if (!tb_moving_wake(view, shape)) return;
  for (uint32_t i = TB_MUFFLERS; i < TB_MUFFLERS + TB_HEADS; i++) {
    if (in_play(view, i)) (void)tb_moving_wake(view, tb_slot_shape(view, i));
  }
  couple_mufflers(view, modal_coupling);
}

/* How head or hoop yields at this slot to forces everywhere, over one step: its shape, what a unit
 * force does to the modes, and the compliance to the grid under the wires and to every other slot.
 */
static void couple(TbView *view, uint32_t slot) {
  const TaborModel *model = view->model;
  const TbModes *modes = &model->modes;
  const TbKernels *kernels = model->kernels;
  const uint32_t size = model->projection.wire_grid.size;
  const double *shape = tb_slot_shape(view, slot);
  double *drive = tb_slot_drive(view, slot), *coupling = tb_slot_coupling(view, slot);
  for (uint32_t i = 0; i < modes->padded; i++) drive[i] = modes->g[i] * shape[i];
  tb_project(&model->projection, kernels, drive, coupling);
  for (uint32_t point = 0; point < size; point++) coupling[point] *= model->wires.side;
  for (uint32_t other = 0; other < TB_SLOTS; other++) {
    const uint32_t low = other < slot ? other : slot, high = other < slot ? slot : other;
    const double value = in_play(view, other) || other == slot
                           ? modal_coupling(view, slot, other) + shared_compliance(view, low, high)
                           : 0.0;
    set_coupling(view, slot, other, value);
  }
  view->strikers.slot_coupling[slot * TB_SLOTS + slot] += tb_slot_truncated(view, slot)->compliance;
}

static void prepare_law(TbView *view, uint32_t slot) {
  const TaborModel *model = view->model;
  const TbSlot *s = tb_slot(view, slot);
  TbContactLaw *law = &view->state->strikers.laws[slot];
  const uint32_t row = tb_slot_row(&model->rows, slot);
  if (!tb_slot_strikes(s)) {
    view->contact_compliance[row] = 0.0;
    tb_contact_law_damper(law, s->resistance, model->time_step);
    return;
  }
  const TaborStrikerDef *def = &model->def.striker[s->striker.definition];
  const TaborHoopDef *hoop = &model->def.hoop;
  const bool hard =
    s->on_hoop && def->kind == TABOR_STRIKER_STICK; /* soft ones yield more than a hoop */
  const double k = model->time_step, compliance = tb_hold_compliance(view, slot);
  const double loss = hard ? hoop->contact_loss : def->contact_loss;
  view->contact_compliance[row] = compliance;
  tb_contact_law_prepare_sum(
    law, s->striker.part * (hard ? hoop->contact_stiffness : def->contact_stiffness),
    hard ? HERTZ : def->contact_exponent, model->def.quality.losses ? loss : 0.0, k,
    TB_SLOPE_LIMIT / (compliance + view->strikers.slot_coupling[slot * TB_SLOTS + slot]));
}

double tb_pool_displacement(const TbView *view, uint32_t slot, const double *q) {
  return dot_of_moving(view, tb_slot_modes(view, slot), tb_slot_shape(view, slot), q);
}

void tb_pool_add_displacements(const TbView *view, double sign, const TbPhase *phase) {
  for (uint32_t i = 0; view->state->strikers.mask >> i; i++) {
    if (!tb_slot_in_play(tb_slot(view, i))) continue;
    phase->eta[tb_slot_row(&view->model->rows, i)] +=
      sign * tb_pool_displacement(view, i, phase->q);
  }
}

void tb_pool_push(const TbView *view, uint32_t slot, double force, double *q) {
  const TbModeRanges modes = tb_slot_modes(view, slot);
  const double *drive = tb_slot_drive(view, slot);
  for (uint32_t part = 0; part < view->moving.count; part++) {
    const uint32_t from = view->moving.from[part], count = view->moving.end[part] - from;
    if (!tb_modes_have(modes, from)) continue;
    view->model->kernels->axpy(count, q + from, force, drive + from);
  }
}

/* Penetration of a striker: its tip is in the head by this much. */
static double penetration_at(const TbView *view, uint32_t slot, const TbPhase *phase) {
  return tb_pool_displacement(view, slot, phase->q) +
         tb_truncated_modes_displacement(tb_slot_truncated(view, slot), phase->truncated[slot]) -
         (phase->z[slot] - tb_slot(view, slot)->bristles.coat) -
         (tb_slot(view, slot)->end.bends ? tb_stick_bow(view, slot, phase) : 0.0);
}

/* Clears the modes that the ranges leave out, which do not move at this place. */
static void clear_others(const TbModes *modes, TbModeRanges kept, double *shape) {
  for (uint32_t i = kept.first; i < modes->padded; i++) {
    if (i - kept.from >= kept.size) shape[i] = 0.0;
  }
}

static void find_place_on_head(TbView *view, uint32_t slot) {
  const TaborModel *model = view->model;
  TbSlot *s = tb_slot(view, slot);
  const bool hand = !tb_slot_strikes(s);
  const double *patch = tb_slot_is_palm(s)
                          ? model->palm_patch
                          : model->patches[hand ? TABOR_MAX_STRIKERS : s->striker.definition];
  double *shape = tb_slot_shape(view, slot);
  double *drive = view->high.scratch;
  if (tb_slot_is_bristles(s)) {
    tb_brush_shapes_shape(model, s->striker.definition, s->radius, s->angle, shape, drive);
  } else {
    tb_model_shape(model, s->head, s->radius, s->angle, patch, view->strikers.radial, shape);
    if (!hand) tb_model_high_drive(model, s->striker.definition, s->radius, s->angle, drive);
  }
  clear_others(&model->modes, tb_slot_modes(view, slot), shape);
  tb_pool_wake(view, shape);
  if (!hand) tb_high_band_step_of(view)->keep_drive(view, slot, drive);
  s->rest_height = tb_pool_displacement(view, slot, model->rest.q);
}

static void find_place_on_hoop(TbView *view, uint32_t slot) {
  const TaborModel *model = view->model;
  TbSlot *s = tb_slot(view, slot);
  tb_model_hoop_shape(model, s->angle, view->strikers.radial, tb_slot_shape(view, slot));
  tb_pool_wake(view, tb_slot_shape(view, slot));
  s->rest_height = model->def.hoop.height;
}

/* Finds the modes' shapes at a slot's place on head or hoop. */
static void find_place(TbView *view, uint32_t slot) {
  if (tb_slot(view, slot)->on_hoop) {
    find_place_on_hoop(view, slot);
  } else {
    find_place_on_head(view, slot);
  }
  couple(view, slot);
}

static void find_penetration(TbView *view, uint32_t slot) {
  const uint32_t row = tb_slot_row(&view->model->rows, slot);
  view->now.eta[row] = penetration_at(view, slot, &view->now);
  view->last.eta[row] = penetration_at(view, slot, &view->last);
}

void tb_pool_yield_anew(TbView *view) {
  couple_mufflers(view, moving_coupling);
  for (uint32_t i = TB_MUFFLERS; i < TB_MUFFLERS + TB_HEADS; i++) {
    if (in_play(view, i)) find_penetration(view, i);
  }
}

void tb_pool_rebuild(TbView *view, uint32_t slot) {
  tb_stick_place(view, slot);
  find_place(view, slot);
  prepare_law(view, slot);
  find_penetration(view, slot);
  view->solve.warm.force[tb_slot_row(&view->model->rows, slot)] = 0.0;
}

double tb_pool_contact_energy(const TbView *view, uint32_t slot, const TbPhase *next,
                              const TbPhase *now) {
  const uint32_t row = tb_slot_row(&view->model->rows, slot);
  const double sum = next->eta[row] + now->eta[row];
  return 0.5 * tb_contact_law_potential(&view->state->strikers.laws[slot], sum);
}

static double contact_energy(const TbView *view, uint32_t slot) {
  return tb_pool_contact_energy(view, slot, &view->now, &view->last);
}

void tb_pool_raise(TbView *view, uint32_t slot, double by) {
  const uint32_t row = tb_slot_row(&view->model->rows, slot);
  const double before = contact_energy(view, slot);
  tb_slot(view, slot)->bristles.coat += by;
  view->now.eta[row] += by;
  view->last.eta[row] += by;
  view->state->ledger.sums.injected += contact_energy(view, slot) - before;
}

void tb_pool_draw(TbView *view, uint32_t slot, double radius, double angle) {
  const double before = contact_energy(view, slot);
  tb_slot(view, slot)->radius = radius;
  tb_slot(view, slot)->angle = angle;
  find_place(view, slot);
  find_penetration(view, slot);
  view->state->ledger.sums.injected += contact_energy(view, slot) - before;
  tb_coupling_renew(view);
}

/* Makes a row stand for nothing: see TbSolve. */
static void clear_row(TbView *view, uint32_t slot) {
  const uint32_t row = tb_slot_row(&view->model->rows, slot);
  TbPhase *const phases[3] = {&view->next, &view->now, &view->last};
  for (int i = 0; i < 3; i++) {
    phases[i]->z[slot] = 0.0;
    memset(phases[i]->truncated[slot], 0, sizeof phases[i]->truncated[slot]);
    memset(phases[i]->bow[slot], 0, sizeof phases[i]->bow[slot]);
    phases[i]->eta[row] = TB_NOTHING;
  }
  memset(tb_slot_coupling(view, slot), 0, view->model->projection.wire_grid.size * sizeof(double));
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    view->strikers.slot_coupling[slot * TB_SLOTS + i] =
      view->strikers.slot_coupling[i * TB_SLOTS + slot] = 0.0;
  }
  view->contact_compliance[row] = view->b[row] = view->solve.warm.force[row] = 0.0;
}

static void book_removed(TbView *view, uint32_t slot) {
  TbState *state = view->state;
  const TbSlot *s = &state->strikers.slots[slot];
  if (tb_slot_strikes(s)) {
    state->ledger.sums.removed +=
      0.5 * tb_stick_motion(view, slot, view->now.z, view->last.z) + contact_energy(view, slot);
    state->ledger.sums.removed += tb_stick_bending(view, slot, &view->now, &view->last);
    state->ledger.sums.removed +=
      tb_truncated_modes_energy(tb_slot_truncated(view, slot), view->model->step_rate,
                                view->now.truncated[slot], view->last.truncated[slot]);
  }
}

static void clear_slot(TbView *view, uint32_t slot) {
  TbState *state = view->state;
  clear_row(view, slot);
  state->strikers.slots[slot] = (TbSlot){0};
  state->strikers.laws[slot] = (TbContactLaw){.kind = TB_CONTACT_LAW_GENERAL};
  state->strikers.mask &= ~(1u << slot);
}

void tb_pool_take_away(TbView *view, uint32_t slot) {
  const uint32_t other = tb_slot_other_end(view, slot);
  book_removed(view, slot);
  if (other != slot) book_removed(view, other);
  clear_slot(view, slot);
  if (other != slot) clear_slot(view, other);
  tb_coupling_renew(view);
}

void tb_pool_muffle(TbView *view) {
  const TaborModel *model = view->model;
  const TaborHeadDef *const sheet = model->body.sheet;
  for (uint32_t h = 0; h < model->body.surfaces; h++) {
    const uint32_t slot = TB_MUFFLERS + h;
    TbSlot *s = tb_slot(view, slot);
    const double strength =
      model->def.quality.losses ? view->state->live.values[TB_LIVE_MUFFLE + h].now : 0.0;
    if (strength == s->resistance) continue;
    if (strength == 0.0) {
      tb_pool_take_away(view, slot);
      continue;
    }
    const bool there = tb_slot_is_muffler(s);
    const TbSlot hand = {.kind = TB_SLOT_MUFFLER,
                         .head = h,
                         .radius = sheet[h].muffle_radius,
                         .angle = sheet[h].muffle_angle,
                         .resistance = strength};
    if (there) {
      *s = hand;
      prepare_law(view, slot);
    } else {
      tb_pool_put_hand(view, slot, &hand);
    }
  }
}

static bool row_touches(const TbView *view, uint32_t slot) {
  const uint32_t row = tb_slot_row(&view->model->rows, slot);
  return view->now.eta[row] > 0.0 || view->last.eta[row] > 0.0;
}

bool tb_pool_sounded(const TbView *view, uint32_t slot) {
  const TbSlot *slots = view->state->strikers.slots;
  return slots[slot].striker.sounded || slots[tb_slot_other_end(view, slot)].striker.sounded;
}

bool tb_pool_touches(const TbView *view, uint32_t slot) {
  return row_touches(view, slot) || row_touches(view, tb_slot_other_end(view, slot));
}

uint32_t tb_pool_obtain(TbView *view) {
  uint32_t oldest = TB_SLOTS;
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    const TbSlot *s = tb_slot(view, i);
    if (!tb_slot_in_play(s)) return i;
    if (!tb_slot_strikes(s) || (s->hold.held && !s->hold.leaving)) continue;
    if (!tb_pool_sounded(view, i) || tb_pool_touches(view, i)) continue;
    if (oldest == TB_SLOTS || s->serial < tb_slot(view, oldest)->serial) oldest = i;
  }
  if (oldest < TB_SLOTS) tb_pool_take_away(view, oldest);
  return oldest;
}

static void raise(TbView *view, uint32_t slot, double above) {
  const uint32_t row = tb_slot_row(&view->model->rows, slot);
  view->now.z[slot] += above;
  view->last.z[slot] += above;
  view->now.eta[row] -= above;
  view->last.eta[row] -= above;
}

/* `above` the surface now, or, where the head recedes faster, above it one sample ago. */
static void launch(TbView *view, uint32_t slot, double above) {
  const uint32_t row = tb_slot_row(&view->model->rows, slot);
  const double approach = tb_slot(view, slot)->striker.velocity * view->model->time_step;
  const double surface_now = view->now.eta[row], surface_last = view->last.eta[row];
  double z = surface_now;
  if (surface_last - approach > z) z = surface_last - approach;
  view->now.z[slot] = z;
  view->last.z[slot] = z + approach;
  view->now.eta[row] = surface_now - view->now.z[slot];
  view->last.eta[row] = surface_last - view->last.z[slot];
  if (view->last.eta[row] > 0.0) view->last.eta[row] = 0.0; /* rounding of z + approach */
  raise(view, slot, above);
}

static void book_launch(TbView *view, uint32_t slot) {
  view->state->ledger.sums.injected += 0.5 * tb_stick_motion(view, slot, view->now.z, view->last.z);
}

static void place(TbView *view, uint32_t slot, const TbSlot *striker) {
  *tb_slot(view, slot) = *striker;
  view->state->strikers.mask |= 1u << slot;
  view->now.z[slot] = view->last.z[slot] = 0.0;
}

void tb_pool_put(TbView *view, uint32_t slot, const TbSlot *striker, double above) {
  place(view, slot, striker);
  tb_pool_rebuild(view, slot);
  launch(view, slot, above);
  book_launch(view, slot);
  tb_coupling_renew(view);
}

void tb_pool_put_hand(TbView *view, uint32_t slot, const TbSlot *hand) {
  *tb_slot(view, slot) = *hand;
  view->state->strikers.mask |= 1u << slot;
  tb_pool_rebuild(view, slot);
  tb_coupling_renew(view);
}

void tb_pool_put_pair(TbView *view, const uint32_t pair[2], const TbSlot *tip, const TbSlot *shaft,
                      double above) {
  place(view, pair[0], tip);
  place(view, pair[1], shaft);
  for (int end = 0; end < 2; end++) tb_pool_rebuild(view, pair[end]);
  launch(view, pair[0], 0.0);
  launch(view, pair[1], above);
  for (int end = 0; end < 2; end++) book_launch(view, pair[end]);
  tb_coupling_renew(view);
}

/* True if a striker moves away and touches nothing, nor will in a moment. */
static bool is_leaving(const TbView *view, uint32_t slot) {
  const double gap = -view->now.eta[tb_slot_row(&view->model->rows, slot)];
  const TbSlot *s = tb_slot(view, slot);
  const double far = s->hold.held && !s->hold.leaving ? OUT_OF_HAND : AWAY;
  return gap > far && view->now.z[slot] > view->last.z[slot];
}

/* A tip that only rests on the head waits for no leave. */
static bool end_is_done(const TbView *view, uint32_t slot) {
  return tb_slot(view, slot)->end.rests || (!row_touches(view, slot) && is_leaving(view, slot));
}

static bool is_done(const TbView *view, uint32_t slot) {
  const TbSlot *s = tb_slot(view, slot);
  if (tb_slot_is_end(s) && end_is_done(view, slot) && end_is_done(view, s->end.other)) return true;
  if (tb_pool_touches(view, slot)) return false;
  if (s->age > (uint64_t)(LINGER * view->model->step_rate)) {
    const double gap = -view->now.eta[tb_slot_row(&view->model->rows, slot)];
    return !s->hold.held || s->hold.leaving || gap > OUT_OF_HAND;
  }
  return !tb_slot_is_end(s) && is_leaving(view, slot);
}

/* The hand on a cross-stick's shaft presses less and less, and takes the stick with it as the palm
 * leaves the head, or at once if it is lifted. */
static void relax_shaft(TbView *view, uint32_t slot) {
  TbSlot *s = tb_slot(view, slot);
  const double rate = view->model->step_rate;
  const double left = s->hold.leaving ? tb_hold_lift_time * rate - s->hold.leaving++
                                      : PALM_TIME * rate - (double)s->age;
  if (left > 1.0) {
    s->hold.press *= 1.0 - 1.0 / left;
  } else {
    tb_pool_take_away(view, slot);
  }
}

/* The palm has come off the head in the end: at once, it would let go of a head that moves. */
static void relax_palm(TbView *view, uint32_t slot) {
  TbSlot *s = tb_slot(view, slot);
  const double rate = view->model->step_rate, left = PALM_TIME * rate - (double)s->age;
  if (left <= 1.0) {
    tb_pool_take_away(view, slot);
  } else if (left < PALM_LIFT_TIME * rate) {
    s->resistance *= 1.0 - 1.0 / left;
    prepare_law(view, slot);
  }
}

/* One sample of a striker, in play or in a hand that lets it go. */
static void age_striker(TbView *view, uint32_t slot) {
  TbSlot *s = tb_slot(view, slot);
  s->age++;
  if (row_touches(view, slot)) s->striker.sounded = 1;
  if (s->hold.held && tb_slot_is_end(s)) {
    relax_shaft(view, slot);
    return;
  }
  if (s->hold.leaving) tb_hold_pull_up(view, slot);
  if (is_done(view, slot)) tb_pool_take_away(view, slot);
}

void tb_pool_retire(TbView *view) {
  TbState *state = view->state;
  if (state->strikers.mask == 0) return;
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    TbSlot *s = &state->strikers.slots[i];
    if (tb_slot_strikes(s)) age_striker(view, i);
    if (!tb_slot_is_palm(s)) continue;
    s->age++;
    relax_palm(view, i);
  }
}
