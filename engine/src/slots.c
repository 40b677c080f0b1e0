/* SPDX-License-Identifier: MIT */
#include "slots.h"

#include <string.h>

#include "brush.h"
#include "live.h"
#include "power.h"

static const double AWAY = 0.005;       /* [m] */
static const double OUT_OF_HAND = 0.05; /* [m] */
static const double LINGER = 1.0;       /* [s] */

static bool in_play(const TbView *view, uint32_t slot) {
  return view->state->slots[slot].kind != TB_SLOT_FREE;
}

/* How the head yields at this slot to forces everywhere, over one step: its shape, what a unit force
 * does to the modes, and the compliance to the grid under the wires and to every other slot. */
static void couple(TbView *view, uint32_t slot) {
  const TaborModel *model = view->model;
  const TbModes *modes = &model->modes;
  const TbKernels *kernels = model->kernels;
  const uint32_t size = model->projection.bed.size;
  const double *shape = tb_slot_shape(view, slot);
  double *drive = tb_slot_drive(view, slot), *coupling = tb_slot_coupling(view, slot);
  for (uint32_t i = 0; i < modes->padded; i++) drive[i] = modes->g[i] * shape[i];
  tb_project(&model->projection, kernels, drive, coupling);
  for (uint32_t point = 0; point < size; point++) coupling[point] *= model->wires.side;
  for (uint32_t other = 0; other < TB_SLOTS; other++) {
    /* The lower slot's drive on the higher one's shape: the same bits whoever came first. */
    const uint32_t low = other < slot ? other : slot, high = other < slot ? slot : other;
    const double value =
      in_play(view, other) || other == slot
        ? kernels->dot(modes->padded, tb_slot_drive(view, low), tb_slot_shape(view, high))
        : 0.0;
    view->slot_coupling[slot * TB_SLOTS + other] = value;
    view->slot_coupling[other * TB_SLOTS + slot] = value;
  }
  view->slot_coupling[slot * TB_SLOTS + slot] += tb_slot_missing(view, slot)->compliance;
}

/* What a hand does at the tip of the stick that it presses. */
typedef struct Hand {
  double force, stiffness, damping;
} Hand;

static Hand hand_of(const TbView *view, const TbSlot *s) {
  if (!s->held) return (Hand){0.0, 0.0, 0.0};
  const TaborDrumDef *def = &view->model->def;
  const double share = 2.0 * s->part * view->state->live[TB_LIVE_GRIP].now;
  return (Hand){share * s->press, share * def->hand.stiffness,
                def->quality.losses ? share * def->hand.damping : 0.0};
}

/* Displacement of the striker itself one step after a unit force [m/N]. */
static double own_compliance(const TbView *view, const TbSlot *s) {
  const double k = view->model->time_step;
  return k * k / (s->mass + 0.5 * hand_of(view, s).damping * k);
}

static void prepare_law(TbView *view, uint32_t slot) {
  const TaborModel *model = view->model;
  const TbSlot *s = &view->state->slots[slot];
  TbLaw *law = &view->state->slot_laws[slot];
  const uint32_t row = model->wires.stride + slot;
  if (s->kind == TB_SLOT_HAND) {
    view->own[row] = 0.0;
    tb_law_damper(law, s->strength, model->time_step);
    return;
  }
  const TaborStrikerDef *def = &model->def.striker[s->definition];
  const double k = model->time_step, compliance = own_compliance(view, s);
  view->own[row] = compliance;
  tb_law_prepare(law, s->part * def->contact_stiffness, def->contact_exponent,
                 model->def.quality.losses ? def->contact_loss : 0.0, k,
                 TB_SLOPE_LIMIT / (compliance + view->slot_coupling[slot * TB_SLOTS + slot]));
}

static double head_at(const TbView *view, uint32_t slot, const double *q) {
  return view->model->kernels->dot(view->model->modes.padded, tb_slot_shape(view, slot), q);
}

/* Of a striker: its tip is in the head by this much. */
static double penetration_at(const TbView *view, uint32_t slot, const TbPhase *phase) {
  return head_at(view, slot, phase->q) +
         tb_mobility_displacement(tb_slot_missing(view, slot), phase->missing[slot]) -
         (phase->z[slot] - view->state->slots[slot].coat);
}

/* What the head's modes are at a slot's place. */
static void find_place(TbView *view, uint32_t slot) {
  const TaborModel *model = view->model;
  TbSlot *s = &view->state->slots[slot];
  const bool hand = s->kind == TB_SLOT_HAND;
  const double *patch = model->patches[hand ? TABOR_MAX_STRIKERS : s->definition];
  tb_model_shape(model, s->head, s->radius, s->angle, patch, view->radial,
                 tb_slot_shape(view, slot));
  couple(view, slot);
  if (!hand)
    tb_model_high_drive(model, s->definition, s->radius, s->angle, tb_slot_high_drive(view, slot));
  s->rest_height = head_at(view, slot, model->rest.q);
}

static void find_penetration(TbView *view, uint32_t slot) {
  const uint32_t row = view->model->wires.stride + slot;
  view->now.eta[row] = penetration_at(view, slot, &view->now);
  view->last.eta[row] = penetration_at(view, slot, &view->last);
}

void tb_slots_rebuild(TbView *view, uint32_t slot) {
  find_place(view, slot);
  prepare_law(view, slot);
  find_penetration(view, slot);
  view->solve.force[view->model->wires.stride + slot] = 0.0;
}

/* What its contact stores [J]. */
static double contact_energy(const TbView *view, uint32_t slot) {
  const TbLaw *law = &view->state->slot_laws[slot];
  const uint32_t row = view->model->wires.stride + slot;
  return 0.5 *
         (tb_law_potential(law, view->now.eta[row]) + tb_law_potential(law, view->last.eta[row]));
}

void tb_slots_raise(TbView *view, uint32_t slot, double by) {
  const uint32_t row = view->model->wires.stride + slot;
  const double before = contact_energy(view, slot);
  view->state->slots[slot].coat += by;
  view->now.eta[row] += by;
  view->last.eta[row] += by;
  view->state->sums.injected += contact_energy(view, slot) - before;
}

void tb_slots_draw(TbView *view, uint32_t slot, double radius, double angle) {
  const double before = contact_energy(view, slot);
  view->state->slots[slot].radius = radius;
  view->state->slots[slot].angle = angle;
  find_place(view, slot);
  find_penetration(view, slot);
  view->state->sums.injected += contact_energy(view, slot) - before;
  tb_live_couple(view);
}

/* Makes a row stand for nothing: see TbSolve. */
static void clear_row(TbView *view, uint32_t slot) {
  const uint32_t stride = view->model->wires.stride, row = stride + slot;
  TbPhase *const phases[3] = {&view->next, &view->now, &view->last};
  for (int i = 0; i < 3; i++) {
    phases[i]->z[slot] = 0.0;
    memset(phases[i]->missing[slot], 0, sizeof phases[i]->missing[slot]);
    phases[i]->eta[row] = TB_NOTHING;
  }
  memset(tb_slot_coupling(view, slot), 0, view->model->projection.bed.size * sizeof(double));
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    view->slot_coupling[slot * TB_SLOTS + i] = view->slot_coupling[i * TB_SLOTS + slot] = 0.0;
  }
  view->own[row] = view->b[row] = view->solve.force[row] = 0.0;
}

void tb_slots_take_away(TbView *view, uint32_t slot) {
  TbState *state = view->state;
  TbSlot *s = &state->slots[slot];
  const uint32_t row = view->model->wires.stride + slot;
  if (s->kind == TB_SLOT_STRIKER) {
    const double velocity = (view->now.z[slot] - view->last.z[slot]) * view->model->sample_rate;
    state->sums.removed += 0.5 * (s->mass * velocity * velocity +
                                  tb_law_potential(&state->slot_laws[slot], view->now.eta[row]) +
                                  tb_law_potential(&state->slot_laws[slot], view->last.eta[row]));
    state->sums.removed += tb_mobility_energy(tb_slot_missing(view, slot), view->model->sample_rate,
                                              view->now.missing[slot], view->last.missing[slot]);
  }
  clear_row(view, slot);
  *s = (TbSlot){0};
  state->slot_laws[slot] = (TbLaw){.kind = TB_LAW_GENERAL};
  state->slot_mask &= ~(1u << slot);
  tb_live_apply(view);
}

void tb_slots_muffle(TbView *view) {
  const TaborModel *model = view->model;
  const TaborHeadDef *const heads[TB_HEADS] = {&model->def.batter, &model->def.resonant};
  for (uint32_t h = 0; h < model->head.heads; h++) {
    const uint32_t slot = TB_MUFFLERS + h;
    TbSlot *s = &view->state->slots[slot];
    const double strength =
      model->def.quality.losses ? view->state->live[TB_LIVE_MUFFLE + h].now : 0.0;
    if (strength == s->strength) continue;
    if (strength == 0.0) {
      tb_slots_take_away(view, slot);
      continue;
    }
    const bool there = s->kind == TB_SLOT_HAND;
    *s = (TbSlot){.kind = TB_SLOT_HAND,
                  .head = h,
                  .radius = heads[h]->muffle_radius,
                  .angle = heads[h]->muffle_angle,
                  .strength = strength};
    view->state->slot_mask |= 1u << slot;
    if (there) {
      prepare_law(view, slot);
    } else {
      tb_slots_rebuild(view, slot);
    }
  }
}

bool tb_slots_touches(const TbView *view, uint32_t slot) {
  const uint32_t row = view->model->wires.stride + slot;
  return view->now.eta[row] > 0.0 || view->last.eta[row] > 0.0;
}

/* A free slot, if need be that of the oldest striker which touches nothing; TB_SLOTS if none. */
static uint32_t obtain(TbView *view) {
  uint32_t oldest = TB_SLOTS;
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    const TbSlot *s = &view->state->slots[i];
    if (s->kind == TB_SLOT_FREE) return i;
    if (s->kind != TB_SLOT_STRIKER || s->held || tb_slots_touches(view, i)) continue;
    if (oldest == TB_SLOTS || s->serial < view->state->slots[oldest].serial) oldest = i;
  }
  if (oldest < TB_SLOTS) tb_slots_take_away(view, oldest);
  return oldest;
}

static const double STICK = 0.4, USUAL_PIVOT = 0.12; /* [m] */

/* Mass at the tip of a rod held at `pivot` from its butt, in units of its mass. */
static double tip_part(double pivot) {
  const double place = pivot / STICK, aside = 0.5 - place, lever = 1.0 - place;
  return (1.0 / 12.0 + aside * aside) / (lever * lever);
}

static double mass_of(const TbView *view, const TbStroke *stroke) {
  const TaborDrumDef *def = &view->model->def;
  const double mass = def->striker[stroke->striker].mass;
  return stroke->buzz ? mass * (tip_part(def->hand.pivot) / tip_part(USUAL_PIVOT)) : mass;
}

/* A hand that strikes again lifts the stick that it pressed. */
static void free_hand(TbView *view, uint32_t id) {
  for (uint32_t i = 0; i < TB_MUFFLERS && id != 0; i++) {
    const TbSlot *s = &view->state->slots[i];
    if (s->kind == TB_SLOT_STRIKER && s->held && s->id == id) tb_slots_take_away(view, i);
  }
}

/* On the surface now, or, where the head recedes faster, just above it one sample ago. */
static void launch(TbView *view, uint32_t slot) {
  const uint32_t row = view->model->wires.stride + slot;
  const double approach = view->state->slots[slot].velocity * view->model->time_step;
  const double surface_now = view->now.eta[row], surface_last = view->last.eta[row];
  double z = surface_now;
  if (surface_last - approach > z) z = surface_last - approach;
  view->now.z[slot] = z;
  view->last.z[slot] = z + approach;
  view->now.eta[row] = surface_now - view->now.z[slot];
  view->last.eta[row] = surface_last - view->last.z[slot];
  if (view->last.eta[row] > 0.0) view->last.eta[row] = 0.0; /* rounding of z + approach */
}

double tb_slots_press_force(double pressure) { return 0.3 * tb_power(8.0 / 0.3, pressure); }

void tb_slots_hold(TbView *view, uint32_t slot, double force) {
  TbSlot *s = &view->state->slots[slot];
  if (!s->held) s->anchor = view->now.z[slot];
  s->held = 1;
  s->press = force;
  view->own[view->model->wires.stride + slot] = own_compliance(view, s);
}

void tb_slots_put(TbView *view, uint32_t slot, const TbSlot *striker, double above) {
  TbState *state = view->state;
  const uint32_t row = view->model->wires.stride + slot;
  state->slots[slot] = *striker;
  state->slot_mask |= 1u << slot;
  view->now.z[slot] = view->last.z[slot] = 0.0;
  tb_slots_rebuild(view, slot);
  launch(view, slot);
  view->now.z[slot] += above;
  view->last.z[slot] += above;
  view->now.eta[row] -= above;
  view->last.eta[row] -= above;
  const double speed = (view->now.z[slot] - view->last.z[slot]) * view->model->sample_rate;
  state->sums.injected += 0.5 * striker->mass * speed * speed;
}

bool tb_slots_strike(TbView *view, const TbStroke *stroke) {
  TbState *state = view->state;
  if (view->model->def.striker[stroke->striker].kind == TABOR_STRIKER_BRUSH) {
    return tb_brush_strike(view, stroke);
  }
  if (stroke->sweep) return false;
  free_hand(view, stroke->id);
  const uint32_t slot = obtain(view);
  if (slot == TB_SLOTS) return false;
  const TbSlot striker = {.kind = TB_SLOT_STRIKER,
                          .id = stroke->id,
                          .serial = ++state->serial,
                          .mass = mass_of(view, stroke),
                          .part = 1.0,
                          .definition = stroke->striker,
                          .radius = stroke->radius,
                          .angle = stroke->angle,
                          .velocity = stroke->velocity};
  tb_slots_put(view, slot, &striker, 0.0);
  if (stroke->buzz) tb_slots_hold(view, slot, tb_slots_press_force(stroke->pressure));
  state->statistics.strikes++;
  tb_live_apply(view);
  return true;
}

bool tb_slots_press(TbView *view, uint32_t id, double pressure) {
  bool found = tb_brush_press(view, id, pressure);
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    const TbSlot *s = &view->state->slots[i];
    if (s->kind != TB_SLOT_STRIKER || (id != 0 && s->id != id)) continue;
    tb_slots_hold(view, i, tb_slots_press_force(pressure));
    found = true;
  }
  if (found) tb_live_apply(view);
  return found;
}

void tb_slots_regrip(TbView *view) {
  bool found = false;
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *s = &view->state->slots[i];
    if (!s->held) continue;
    view->own[view->model->wires.stride + i] = own_compliance(view, s);
    found = true;
  }
  if (found) tb_live_apply(view);
}

double tb_slots_free_height(const TbView *view, uint32_t slot) {
  const TbSlot *s = &view->state->slots[slot];
  const double now = view->now.z[slot], last = view->last.z[slot];
  if (!s->held) return 2.0 * now - last;
  const Hand hand = hand_of(view, s);
  const double k = view->model->time_step;
  const double inertia = s->mass / (k * k), damping = hand.damping / (2.0 * k);
  const double pull = hand.force + hand.stiffness * (now - s->anchor);
  return (inertia * (2.0 * now - last) + damping * last - pull) / (inertia + damping);
}

TbHandWork tb_slots_hand_work(const TbView *view) {
  TbHandWork work = {0.0, 0.0};
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *s = &view->state->slots[i];
    if (!s->held) continue;
    const Hand hand = hand_of(view, s);
    const double moved = view->next.z[i] - view->last.z[i];
    work.done -= 0.5 * moved * (hand.force + hand.stiffness * (view->now.z[i] - s->anchor));
    work.lost += 0.25 * hand.damping * view->model->sample_rate * moved * moved;
  }
  return work;
}

static uint32_t find_hand(const TbView *view, uint32_t id) {
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    const TbSlot *s = &view->state->slots[i];
    if (s->kind == TB_SLOT_HAND && s->id == id) return i;
  }
  return TB_SLOTS;
}

bool tb_slots_damp(TbView *view, uint32_t id, double strength, double radius, double angle) {
  uint32_t slot = id ? find_hand(view, id) : TB_SLOTS;
  if (slot == TB_SLOTS) slot = obtain(view);
  if (slot == TB_SLOTS) return false;
  TbState *state = view->state;
  state->slots[slot] = (TbSlot){.kind = TB_SLOT_HAND,
                                .id = id,
                                .serial = ++state->serial,
                                .radius = radius,
                                .angle = angle,
                                .strength = strength};
  state->slot_mask |= 1u << slot;
  tb_slots_rebuild(view, slot);
  tb_live_apply(view);
  return true;
}

void tb_slots_release(TbView *view, uint32_t id) {
  tb_brush_release(view, id);
  for (uint32_t i = 0; i < TB_MUFFLERS; i++) {
    if (in_play(view, i) && (id == 0 || view->state->slots[i].id == id))
      tb_slots_take_away(view, i);
  }
}

void tb_slots_retire(TbView *view) {
  TbState *state = view->state;
  if (state->slot_mask == 0) return;
  const uint64_t linger = (uint64_t)(LINGER * view->model->sample_rate);
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    TbSlot *s = &state->slots[i];
    if (s->kind != TB_SLOT_STRIKER) continue;
    s->age++;
    if (tb_slots_touches(view, i)) continue;
    const double gap = -view->now.eta[view->model->wires.stride + i];
    const bool leaving = view->now.z[i] > view->last.z[i];
    const bool gone = s->held ? gap > OUT_OF_HAND : gap > AWAY || s->age > linger;
    if (gone && (leaving || s->age > linger)) tb_slots_take_away(view, i);
  }
}
