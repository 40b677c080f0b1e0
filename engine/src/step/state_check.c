/* SPDX-License-Identifier: MIT */
#include "step/state_check.h"

#include <math.h>
#include <string.h>

#include "model/state_layout.h"
#include "state/event_budget.h"
#include "step/live_params.h"
#include "wires/pluck.h"

/* No number of a drum comes near this, whatever its unit. Its cube times the largest stiffness, and
 * what microphones make of it, are still finite. */
static const double MOST = 1e15;
static const double MOST_PLACE = 1e6; /* [m], [deg]: whole numbers are made of them */
static const double MOST_WAY = 1e12;  /* path of a brush [m] and its angle [deg], over its life */

static bool within(double value, double most) { return fabs(value) <= most; }

static bool all_within(const double *values, size_t count, double most) {
  bool within_all = true;
  for (size_t i = 0; i < count; i++) within_all &= within(values[i], most);
  return within_all;
}

/* An array of doubles, or of structs of doubles, as two arguments. */
#define NUMBERS(array) ((const double *)(const void *)(array)), (sizeof(array)) / (sizeof(double))

/* ---- slots ---------------------------------------------------------------------------------- */

static bool is_brush(const TaborModel *model, uint32_t definition) {
  return definition < model->def.striker_count &&
         model->def.striker[definition].kind == TABOR_STRIKER_BRUSH;
}

static bool slot_numbers(const TbSlot *s) {
  const double places[] = {s->end.along, s->radius, s->angle, s->bristles.coat};
  const TbStriker *striker = &s->striker;
  const TbHold *hold = &s->hold;
  const double others[] = {striker->mass,  striker->part, striker->velocity, striker->force_before,
                           hold->press,    hold->anchor,  hold->resistance,  hold->push,
                           s->rest_height, s->end.cross,  s->resistance,     s->bristles.due};
  return all_within(NUMBERS(places), MOST_PLACE) && all_within(NUMBERS(others), MOST) &&
         all_within(NUMBERS(s->end.bend), MOST) && s->end.along >= 0.0 && s->radius >= 0.0;
}

static bool slot_flags(const TbSlot *s) {
  const uint32_t flags[] = {s->hold.held, s->on_hoop, s->end.bends, s->end.rests,
                            s->striker.sounded};
  for (size_t i = 0; i < sizeof flags / sizeof *flags; i++) {
    if (flags[i] > 1u) return false;
  }
  return true;
}

static bool no_law(const TbContactLaw *law) { return law->kind == TB_CONTACT_LAW_GENERAL; }

/* Code that passes all slots looks at these even where none strikes. */
static bool no_striker(const TbSlot *s) {
  return !s->hold.held && !s->hold.leaving && !s->end.bends && !s->end.rests;
}

static bool free_slot(const TbState *state, uint32_t i) {
  const TbSlot *s = &state->strikers.slots[i];
  return no_striker(s) && s->striker.mass == 0.0 && no_law(&state->strikers.laws[i]);
}

static bool striker(const TaborModel *model, const TbState *state, uint32_t i) {
  const TbSlot *s = &state->strikers.slots[i];
  return s->striker.definition < model->def.striker_count && s->head == TABOR_HEAD_BATTER &&
         s->striker.mass > 0.0 && s->end.grip < TB_GRIPS &&
         state->strikers.laws[i].kind != TB_CONTACT_LAW_DAMPER;
}

static bool tip(const TaborModel *model, const TbState *state, uint32_t i) {
  return i < TB_MUFFLERS && !state->strikers.slots[i].end.rests && striker(model, state, i);
}

/* Its tip is on the head and its shaft on the hoop, where a hand presses one that rests. */
static bool stick_end(const TaborModel *model, const TbState *state, uint32_t i) {
  const TbSlot *s = &state->strikers.slots[i];
  const uint32_t other = s->end.other;
  if (i >= TB_MUFFLERS || other >= TB_MUFFLERS || other == i) return false;
  const TbSlot *o = &state->strikers.slots[other];
  if (s->hold.held && (!s->on_hoop || !o->end.rests)) return false;
  return tb_slot_is_end(o) && o->end.other == i && o->on_hoop != s->on_hoop &&
         o->end.bends == s->end.bends && o->end.grip == s->end.grip &&
         o->striker.definition == s->striker.definition && striker(model, state, i);
}

static bool bristles(const TaborModel *model, const TbState *state, uint32_t i) {
  const TbSlot *s = &state->strikers.slots[i];
  if (i < TB_BRISTLES || !striker(model, state, i)) return false;
  const TbBrush *brush = &state->strikers.brushes[(i - TB_BRISTLES) / TB_BRISTLE_GROUPS];
  return !s->end.bends && !s->end.rests && !s->on_hoop && s->hold.held && brush->active &&
         brush->definition == s->striker.definition && is_brush(model, s->striker.definition);
}

static bool damper(const TaborModel *model, const TbState *state, uint32_t i) {
  const TbSlot *s = &state->strikers.slots[i];
  return s->head < model->body.surfaces && no_striker(s) && !s->on_hoop &&
         state->strikers.laws[i].kind == TB_CONTACT_LAW_DAMPER;
}

static bool slot_of_kind(const TaborModel *model, const TbState *state, uint32_t i) {
  switch (state->strikers.slots[i].kind) {
  case TB_SLOT_FREE: return free_slot(state, i);
  case TB_SLOT_TIP: return tip(model, state, i);
  case TB_SLOT_END: return stick_end(model, state, i);
  case TB_SLOT_BRISTLES: return bristles(model, state, i);
  case TB_SLOT_HAND:
  case TB_SLOT_PALM: return i < TB_MUFFLERS && damper(model, state, i);
  case TB_SLOT_MUFFLER:
    return i >= TB_MUFFLERS && state->strikers.slots[i].head == i - TB_MUFFLERS &&
           damper(model, state, i);
  default: return false;
  }
}

/* The limit of a law that has none is infinite. */
static bool law_numbers(const TbContactLaw *law) {
  const double numbers[] = {law->stiffness, law->exponent, law->loss};
  const double limits[] = {law->limit, law->limit_force, law->limit_potential, law->limit_slope};
  return (unsigned)law->kind <= TB_CONTACT_LAW_DAMPER && all_within(NUMBERS(numbers), MOST) &&
         all_within(NUMBERS(limits), INFINITY);
}

static bool slots(const TaborModel *model, const TbState *state) {
  uint32_t mask = 0;
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    if (!slot_flags(&state->strikers.slots[i]) || !slot_numbers(&state->strikers.slots[i]))
      return false;
    if (!law_numbers(&state->strikers.laws[i]) || !slot_of_kind(model, state, i)) return false;
    mask |= (tb_slot_in_play(&state->strikers.slots[i]) ? 1u : 0u) << i;
  }
  return mask == state->strikers.mask;
}

static bool edge_grip(const TbEdgeGrip *edge) {
  return edge->held <= 1u && edge->strength >= 0.0 && edge->strength <= 100.0;
}

/* A brush whose bristles are gone, as after a swap, may have any definition: it ends in the next
 * step. */
static bool brushes(const TbState *state) {
  for (uint32_t b = 0; b < TB_BRUSHES; b++) {
    const TbBrush *brush = &state->strikers.brushes[b];
    const double places[] = {brush->radius, brush->x,     brush->y,      brush->dx,
                             brush->dy,     brush->along, brush->around, brush->slide};
    const double others[] = {brush->way, brush->track, brush->angle, brush->press};
    if (brush->active > 1u || !all_within(NUMBERS(places), MOST_PLACE)) return false;
    if (!all_within(NUMBERS(others), MOST_WAY)) return false;
    if (brush->way < 0.0 || brush->track < 0.0) return false;
  }
  return true;
}

/* A finger is on a wire of the drum, between two of its inner nodes. */
static bool plucks(const TaborModel *model, const TbState *state) {
  for (uint32_t w = 0; w < TABOR_MAX_WIRES; w++) {
    const TbPluck *pluck = &state->wires.plucks[w];
    const bool right = pluck->steps > 0 && state->wires.flung > 0 && w < model->wires.count &&
                       pluck->done < pluck->steps && pluck->node >= 1 &&
                       pluck->node + 2 <= model->wires.wires[w].cells;
    const bool none = pluck->steps == 0 && pluck->done == 0;
    if (!(right || none) || !(pluck->share >= 0.0 && pluck->share <= 1.0)) return false;
    if (!within(pluck->force, MOST)) return false;
  }
  return true;
}

/* ---- the rest of the head of a state -------------------------------------------------------- */

static bool flags(const TaborModel *model, const TbState *state) {
  const bool wires = model->wires.count > 0;
  return state->newest < 3u && state->asleep <= 1u && state->wires.lifted <= (wires ? 1u : 0u) &&
         state->wires.flung <= (wires ? TB_FLUNG : 0u) &&
         state->high.wires_hold <= (wires ? 1u : 0u) && state->high.struck <= 1u &&
         state->high.push.known <= 1u && state->high.push.left <= model->high.vanishes &&
         state->airborne <= 1u && state->hushed <= 1u && state->stretches <= 1u &&
         state->event_debt <= TB_DEBT_MOST && state->mics.heard >> model->def.mic_count == 0;
}

/* Modes that move without strikers never rest. */
static bool moving(const TaborModel *model, const TbState *state) {
  const TbParts *parts = &model->stretch.parts;
  for (uint32_t i = 0; i < parts->count; i++) {
    const uint32_t count = state->moving[i];
    if (count % 8u != 0 || count < model->resting.floor[i]) return false;
    if (count > parts->end[i] - parts->from[i]) return false;
  }
  return true;
}

static bool microphones(const TaborModel *model, const TbState *state) {
  for (uint32_t mic = 0; mic < model->def.mic_count; mic++) {
    if (state->mics.delay_at[mic] > model->mics[mic].delay) return false;
  }
  return all_within(NUMBERS(state->mics.treble), MOST) &&
         all_within(NUMBERS(state->mics.halved), MOST) &&
         all_within(NUMBERS(state->mics.response), MOST) &&
         all_within(NUMBERS(state->mics.ears), MOST) && all_within(NUMBERS(state->mics.kick), MOST);
}

static bool hihat_air(const TbHihatAirState *air) {
  const double numbers[] = {air->pressure, air->energy, air->by_contacts, air->mean, air->foreseen};
  return all_within(NUMBERS(numbers), MOST);
}

/* Its energy, psi^2 - C, may be negative. */
static bool plate(const TbPlateState *plate) {
  return all_within(NUMBERS(plate->psi), MOST) && plate->shift >= 0.0 &&
         within(plate->shift, MOST) && within(plate->energy, MOST) && plate->part >= 0.0 &&
         plate->part <= 1.0;
}

static bool numbers(const TbState *state) {
  return within(state->incident, MOST) && within(state->ledger.sound_work, MOST) &&
         within(state->ledger.radiated_beyond, MOST) &&
         all_within(NUMBERS(state->wires.coefficients), MOST) &&
         all_within(NUMBERS(state->wires.shift), MOST) &&
         all_within(NUMBERS(state->strikers.z), MOST) &&
         all_within(NUMBERS(state->strikers.truncated), MOST) &&
         all_within(NUMBERS(state->strikers.bow), MOST) &&
         all_within((const double *)&state->high.contacts, 3, MOST) &&
         within(state->high.push.share, 1.0) &&
         all_within((const double *)&state->ledger.sums, sizeof state->ledger.sums / sizeof(double),
                    INFINITY);
}

static bool head(const TaborModel *model, const TbState *state) {
  return flags(model, state) && moving(model, state) && microphones(model, state) &&
         numbers(state) && plate(&state->plate) && hihat_air(&state->air) &&
         tb_live_params_in_range(state) && slots(model, state) &&
         edge_grip(&state->strikers.edge) && brushes(state) && plucks(model, state);
}

/* ---- arrays --------------------------------------------------------------------------------- */

static bool doubles(const char *bytes, size_t from, size_t end) {
  bool within_all = true;
  for (; from < end; from += sizeof(double)) {
    double number;
    memcpy(&number, bytes + from, sizeof number);
    within_all &= within(number, MOST);
  }
  return within_all;
}

static bool floats(const char *bytes, size_t from, size_t end) {
  bool within_all = true;
  for (; from < end; from += sizeof(float)) {
    float number;
    memcpy(&number, bytes + from, sizeof number);
    within_all &= within((double)number, MOST);
  }
  return within_all;
}

typedef struct Arrays {
  const TaborModel *model;
  const char *bytes;
} Arrays;

static bool array(void *context, TbArrayKind kind, size_t from, size_t end) {
  static bool (*const HIGH[])(const char *, size_t,
                              size_t) = {[TB_IN_DOUBLE] = doubles, [TB_IN_FLOAT] = floats};
  const Arrays *arrays = context;
  switch (kind) {
  case TB_DOUBLES: return doubles(arrays->bytes, from, end);
  case TB_FLOATS: return floats(arrays->bytes, from, end);
  case TB_HIGH_REALS: return HIGH[arrays->model->high.precision](arrays->bytes, from, end);
  default: return true; /* scratch */
  }
}

bool tb_state_check(const TaborModel *model, const void *bytes) {
  TbState state; /* some 20 kB; its arrays are checked where they are */
  memcpy(&state, bytes, sizeof state);
  Arrays arrays = {model, (const char *)bytes + tb_state_head_bytes()};
  return head(model, &state) && tb_layout_visit(model, array, &arrays);
}
