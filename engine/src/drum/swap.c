/* SPDX-License-Identifier: MIT */
/* Continuing a ringing drum on another model.
 *
 * To keep the displacements unchanged would make a parametric pump: toggling the tension by 10 %
 * every 64 samples multiplies the energy without bound. To keep phase and action per mode does not.
 * With t = w_d k, im = (q- - q cos t0)/sin t0, c = sqrt(sin t0/sin t1),
 *   q' = c q, q-' = c (q cos t1 + im sin t1);
 * the energy then follows w1/w0. Modes are matched by (m, place in their order, cosine or sine),
 * which is right while only tensions, masses, losses or quality changed; if the axis turns by d
 * (TaborModel.axis), copies a and b become a cos(m d) + b sin(m d) and b cos(m d) - a sin(m d). For
 * another radius, boundary or side, and where the drum is to be replaced, the old drum rings out
 * beside the new one. If the steps differ, c = (sin t0/k0)/(sin t1/k1) sqrt(w1/w0): the energy
 * (c sin t1/k1)^2 then follows w1/w0 exactly; what is no mode keeps place and velocity.
 *
 * Sound on its way to the microphones and the high band do not continue on another model. So the
 * old model plays on for 8 ms, in which the new one's sound travels 2.7 m, and then fades for 8 ms
 * against the new one's. Audio-safe but for tb_swap_map(). */
#include <math.h>
#include <string.h>

#include "drum/drum.h"
#include "drum/drum_create.h"
#include "heads/hihat_air.h"
#include "heads/moving_modes.h"
#include "math/portable_math.h"
#include "step/energy.h"
#include "step/live_params.h"
#include "strikers/stick.h"
#include "strikers/striker_pool.h"
#include "strikers/strokes.h"
#include "wires/wire_motion.h"

static const double RING_OUT = 0.03; /* [s] */
static const double HOLD = 0.008;    /* [s] */
static const double FADE = 0.008;    /* [s] */

/* ---- set-up --------------------------------------------------------------------------------- */

static int find_mic(const TaborDrumDef *def, const TaborDrumDef *other, uint32_t mic) {
  return mic < other->mic_count ? tabor_drum_def_find_mic(def, other->mic[mic].name) : -1;
}

/* By name. Two without a namesake in the other drum, in the same place, are taken for the same. */
static void map_mics(TaborSwap *swap) {
  const TaborDrumDef *from = &swap->old_model->def, *to = &swap->new_model->def;
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) {
    const int namesake = find_mic(from, to, i);
    const bool in_place = i < from->mic_count && i < to->mic_count && find_mic(to, from, i) < 0;
    const uint32_t other = in_place ? i : (uint32_t)TB_NO_MIC;
    swap->mics[i] = (uint8_t)(namesake >= 0 ? (uint32_t)namesake : other);
  }
}

static bool continues(const TaborModel *a, const TaborModel *b) {
  return a->def.body.kind == b->def.body.kind && a->def.shell.radius == b->def.shell.radius &&
         a->def.shell.depth == b->def.shell.depth &&
         a->def.shell.boundary == b->def.shell.boundary && a->def.two_headed == b->def.two_headed &&
         a->wires.count == b->wires.count && a->wires.head == b->wires.head &&
         a->wires.side == b->wires.side && (a->wires.count == 0 || a->axis == b->axis);
}

static uint32_t find_mode(const TaborModel *model, const TbBodyMode *wanted, uint8_t sine) {
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    if (model->modes.row[i] == TB_NO_MODE) continue;
    const TbBodyMode *mode = &model->body.modes[model->modes.row[i]];
    if (mode->m == wanted->m && mode->index == wanted->index && model->modes.sine[i] == sine)
      return i;
  }
  return TB_NO_MODE;
}

/* w_d k, or -1 for an overdamped mode. */
static double turn_per_sample(const TbBodyMode *mode, double k) {
  const double square = mode->omega * mode->omega - mode->decay_rate * mode->decay_rate;
  return square > 0.0 ? sqrt(square) * k : -1.0;
}

static void map_mode(TbMapping *map, uint32_t i, const TbBodyMode *from, const TbBodyMode *to) {
  const double t0 = turn_per_sample(from, map->step_from), t1 = turn_per_sample(to, map->step_to);
  if (t0 == t1 || t0 <= 0.0 || t1 <= 0.0) return; /* scale 0: copy */
  tb_sin_cos(t0, &map->sin_old[i], &map->cos_old[i]);
  tb_sin_cos(t1, &map->sin_new[i], &map->cos_new[i]);
  const double sines = map->sin_old[i] / map->sin_new[i];
  map->scale[i] =
    map->ratio == 1.0 ? sqrt(sines) : map->ratio * sines * sqrt(t1 / (t0 * map->ratio));
}

/* Copies of one frequency turn into each other. */
static void map_twin(TbMapping *map, uint32_t i, const TaborModel *from, const TaborModel *to) {
  const uint32_t m = to->body.modes[to->modes.row[i]].m;
  const bool sine = to->modes.sine[i] != 0;
  double sine_turn, cosine_turn;
  if (from->axis == to->axis || m == 0) return;
  map->twin[i] = find_mode(from, &to->body.modes[to->modes.row[i]], !sine);
  tb_sin_cos_degrees(to->axis - from->axis, &sine_turn, &cosine_turn);
  map->of_mode[i] = tb_angular(m, false, sine_turn, cosine_turn);
  map->of_twin[i] = tb_angular(m, true, sine_turn, cosine_turn) * (sine ? -1.0 : 1.0);
}

bool tb_swap_map(TaborSwap *swap) {
  TbMapping *map = &swap->mapping;
  const TaborModel *from = swap->old_model, *to = swap->new_model;
  map->continues = continues(from, to);
  map->step_from = from->time_step;
  map->step_to = to->time_step;
  map->ratio = to->time_step / from->time_step;
  map_mics(swap);
  if (!map->continues) return true;
  const uint32_t n = to->modes.padded;
  const bool same = from->fingerprint == to->fingerprint;
  map->mode = tb_arena_take(&swap->arena, n, sizeof *map->mode);
  map->twin = tb_arena_take(&swap->arena, n, sizeof *map->twin);
  double **arrays[] = {&map->scale,   &map->cos_old, &map->sin_old, &map->cos_new,
                       &map->sin_new, &map->of_mode, &map->of_twin};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
    *arrays[i] = tb_arena_doubles(&swap->arena, n);
  }
  if (swap->arena.failed) return false;
  for (uint32_t i = 0; i < n; i++) {
    map->mode[i] =
      same ? i : TB_NO_MODE; /* those that stand for truncated modes, see wire_yield.h */
    map->twin[i] = TB_NO_MODE;
    if (to->modes.row[i] == TB_NO_MODE) continue;
    const TbBodyMode *mode = &to->body.modes[to->modes.row[i]];
    map->mode[i] = find_mode(from, mode, to->modes.sine[i]);
    if (map->mode[i] == TB_NO_MODE) continue;
    map_mode(map, i, &from->body.modes[from->modes.row[map->mode[i]]], mode);
    map_twin(map, i, from, to);
  }
  return true;
}

/* ---- on the audio thread -------------------------------------------------------------------- */

/* Displacement of the new mode i in an old instant. */
static double turned(const TbMapping *map, uint32_t i, const double *q) {
  const uint32_t twin = map->twin[i];
  if (twin == TB_NO_MODE) return q[map->mode[i]];
  return map->of_mode[i] * q[map->mode[i]] + map->of_twin[i] * q[twin];
}

static void carry_modes(const TbMapping *map, const TbView *from, TbView *to) {
  for (uint32_t i = 0; i < to->model->modes.padded; i++) {
    if (map->mode[i] == TB_NO_MODE) continue;
    const double q = turned(map, i, from->now.q), last = turned(map, i, from->last.q);
    const double c = map->scale[i];
    if (c == 0.0) {
      to->now.q[i] = q;
      to->last.q[i] = tb_step_ago(q, last, map->ratio);
      continue;
    }
    const double im = (last - q * map->cos_old[i]) / map->sin_old[i];
    to->now.q[i] = c * q;
    to->last.q[i] = c * (q * map->cos_new[i] + im * map->sin_new[i]);
  }
}

/* Linear interpolation between grids; the same grid copies. */
static void carry_nodes(const TbWire *from, const TbWire *to, const double *source,
                        double *target) {
  for (uint32_t i = 1; i < to->cells; i++) {
    const double place = (double)i * (double)from->cells / (double)to->cells;
    const uint32_t node = (uint32_t)place;
    const double part = place - (double)node;
    target[i] =
      part == 0.0 ? source[node] : source[node] + part * (source[node + 1] - source[node]);
  }
}

static void carry_wires(const TbView *from, TbView *to, double ratio) {
  for (uint32_t w = 0; w < to->model->wires.count; w++) {
    const TbWire *a = &from->model->wires.wires[w], *b = &to->model->wires.wires[w];
    carry_nodes(a, b, from->now.v + a->first_node, to->now.v + b->first_node);
    carry_nodes(a, b, from->last.v + a->first_node, to->last.v + b->first_node);
  }
  for (uint32_t i = 0; i < to->model->wires.node_count; i++) {
    to->last.v[i] = tb_step_ago(to->now.v[i], to->last.v[i], ratio);
  }
}

static TbLiveParam at_steps(TbLiveParam live, double ratio) {
  live.left = tb_steps_left(live.left, ratio);
  live.step *= ratio;
  return live;
}

/* A live value that the player moved, or that both definitions share, goes on as it is. */
static void carry_live(const TbView *from, TbView *to, double ratio) {
  to->state->live.stamp = from->state->live.stamp;
  TbLiveParam fresh[TB_LIVE_COUNT], old_fresh[TB_LIVE_COUNT];
  memcpy(fresh, to->state->live.values, sizeof fresh);
  tb_live_params_definition(from->model, old_fresh);
  for (uint32_t i = 0; i < TB_LIVE_COUNT; i++) {
    const TbLiveParam *live = &from->state->live.values[i];
    const bool untouched = live->left == 0 && live->now == old_fresh[i].now;
    to->state->live.values[i] = untouched ? fresh[i] : at_steps(*live, ratio);
  }
}

/* Penetrations follow from displacements; where nothing changed they are the same to the bit. */
static void carry_contacts(const TbView *from, TbView *to) {
  if (from->model->fingerprint == to->model->fingerprint) {
    const size_t bytes = tb_row_count(&to->model->rows) * sizeof(double);
    memcpy(to->now.eta, from->now.eta, bytes);
    memcpy(to->last.eta, from->last.eta, bytes);
    memcpy(to->solve.warm.force, from->solve.warm.force, bytes);
    to->state->wires.lifted = from->state->wires.lifted;
    to->state->wires.gap = from->state->wires.gap;
    tb_view_lift(to, from->state->wires.lifted != 0);
    return;
  }
  tb_penetrations_from_displacements(to, &to->now);
  tb_penetrations_from_displacements(to, &to->last);
}

static void carry_truncated(const TbView *from, TbView *to, uint32_t slot, double ratio) {
  double *now = to->now.truncated[slot], *last = to->last.truncated[slot];
  memcpy(now, from->now.truncated[slot], sizeof from->now.truncated[slot]);
  memcpy(last, from->last.truncated[slot], sizeof from->last.truncated[slot]);
  tb_truncated_modes_carry(tb_slot_truncated(from, slot), tb_slot_truncated(to, slot), ratio, now,
                           last);
}

static void carry_bending(const TbView *from, TbView *to, uint32_t slot, double ratio) {
  double *now = to->now.bow[slot], *last = to->last.bow[slot];
  TbSlot *s = tb_slot(to, slot);
  if (tb_slot_is_tip(s) && s->end.bends) s->end.bends = tb_stick_bends(to, s->striker.definition);
  if (!s->end.bends) return;
  memcpy(now, from->now.bow[slot], sizeof from->now.bow[slot]);
  memcpy(last, from->last.bow[slot], sizeof from->last.bow[slot]);
  tb_stick_carry(tb_stick_body(from, slot), tb_stick_body(to, slot), ratio, now, last);
}

static TbSlot slot_at_steps(TbSlot slot, double ratio) {
  slot.hold.leaving = tb_steps_left(slot.hold.leaving, ratio);
  slot.age = (uint64_t)((double)slot.age / ratio);
  return slot;
}

static void carry_slots(const TbView *from, TbView *to, double ratio) {
  const bool same = from->model->fingerprint == to->model->fingerprint;
  const uint32_t first = to->model->wires.stride;
  to->state->strikers.serial = from->state->strikers.serial;
  tb_hands_carry(from, to, ratio);
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *slot = tb_slot(from, i);
    if (!tb_slot_in_play(slot) || tb_slot_is_muffler(slot)) continue;
    if (!tb_striker_is_known(to->model, slot)) continue;
    *tb_slot(to, i) = slot_at_steps(*slot, ratio);
    to->state->strikers.mask |= 1u << i;
    to->now.z[i] = from->now.z[i];
    to->last.z[i] = tb_step_ago(from->now.z[i], from->last.z[i], ratio);
    carry_truncated(from, to, i, ratio);
    carry_bending(from, to, i, ratio);
  }
  tb_pool_muffle(to);
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    if (!tb_slot_in_play(tb_slot(to, i))) continue;
    const double force = from->solve.warm.force[tb_slot_row(&from->model->rows, i)];
    const double now = to->now.eta[first + i], last = to->last.eta[first + i];
    tb_pool_rebuild(to, i);
    if (same) {
      to->solve.warm.force[first + i] = force;
      to->state->strikers.laws[i] = from->state->strikers.laws[i];
      to->now.eta[first + i] = now;
      to->last.eta[first + i] = last;
    }
  }
  tb_live_params_apply(to);
  if (!same) return;
  const size_t carried = (to->model->projection.wire_grid.size + TB_SLOTS) * sizeof(double);
  memcpy(to->solve.warm.product, from->solve.warm.product, (first + TB_SLOTS) * sizeof(double));
  memcpy(to->solve.warm.grid, from->solve.warm.grid,
         to->model->projection.wire_grid.size * sizeof(double));
  memcpy(to->stretch.carry, from->stretch.carry, carried);
}

/* Modes of the high band are chosen anew in every model: only the same model's go on. */
static void carry_high(const TbView *from, TbView *to) {
  if (from->model->fingerprint != to->model->fingerprint) return;
  const size_t bytes = to->model->high.padded * sizeof(double);
  memcpy(to->now.high, from->now.high, bytes);
  memcpy(to->last.high, from->last.high, bytes);
  memcpy(to->high.taken, from->high.taken, bytes);
  memcpy(to->high.turn, from->high.turn, bytes);
  memcpy(to->high.force, from->high.force, bytes / 2u);
  memcpy(to->high.steady, from->high.steady, bytes / 2u);
  to->state->high.wires_hold = from->state->high.wires_hold;
  to->state->high.hold_steps = from->state->high.hold_steps;
  to->state->high.scattered = from->state->high.scattered;
  to->state->high.struck = from->state->high.struck;
  to->state->high.contacts = from->state->high.contacts;
  to->state->high.push = from->state->high.push;
}

/* In another model modes come to rest, heads to be linear, and what contacts do to modes is summed,
 * anew. */
static void carry_rest(const TbView *from, TbView *to) {
  if (from->model->fingerprint != to->model->fingerprint) return;
  to->state->airborne = from->state->airborne;
  memcpy(to->modal, from->modal, to->model->modes.padded * sizeof(double));
  to->state->unstretched = from->state->unstretched;
  memcpy(to->state->moving, from->state->moving, sizeof to->state->moving);
  tb_view_move(to);
  memcpy(to->strikers.slot_coupling, from->strikers.slot_coupling,
         (size_t)TB_SLOTS * TB_SLOTS * sizeof(double));
}

static void carry_sound(const TaborSwap *swap, const TbView *from, TbView *to) {
  for (uint32_t i = 0; i < to->model->def.mic_count; i++) {
    const uint32_t mic = swap->mics[i];
    if (mic == TB_NO_MIC || from->model->steps != to->model->steps) continue;
    if (from->model->mics[mic].delay != to->model->mics[i].delay) continue;
    memcpy(to->mics.delay[i], from->mics.delay[mic],
           (to->model->mics[i].delay + 1u) * sizeof(double));
    to->state->mics.delay_at[i] = from->state->mics.delay_at[mic];
    memcpy(to->state->mics.treble[i], from->state->mics.treble[mic],
           sizeof to->state->mics.treble[i]);
    memcpy(to->state->mics.halved[i], from->state->mics.halved[mic],
           sizeof to->state->mics.halved[i]);
    if (from->model->def.mic[mic].response != to->model->def.mic[i].response) continue;
    memcpy(to->state->mics.response[i], from->state->mics.response[mic],
           sizeof to->state->mics.response[i]);
  }
}

static void continue_on(const TaborSwap *swap, TbView *from, TbView *to) {
  TbState *state = to->state;
  const double ratio = swap->mapping.ratio;
  state->clock = from->state->clock;
  state->asleep = from->state->asleep;
  state->quiet_checks = from->state->quiet_checks;
  state->hushed = from->state->hushed;
  state->stretches = from->state->stretches;
  if (to->model->plate.tables.pairs > 0) {
    state->plate = from->state->plate;
    *to->now.psi = *from->now.psi;
  }
  tb_hihat_air_carry(from, to);
  (void)tb_moving_wake(to, NULL);
  carry_modes(&swap->mapping, from, to);
  carry_wires(from, to, ratio);
  carry_live(from, to, ratio);
  memcpy(state->wires.shift, from->state->wires.shift, sizeof state->wires.shift);
  tb_live_params_apply(to);
  carry_contacts(from, to);
  carry_slots(from, to, ratio);
  carry_rest(from, to);
  carry_high(from, to);
  carry_sound(swap, from, to);
}

/* The tail gets the old drum's state, and the swap its spare memory and its reference to the model.
 */
static void exchange(TaborDrum *drum, TaborSwap *swap) {
  TbState *const state = swap->tail->state;
  TbTail *const spare = swap->spare;
  swap->tail->state = drum->state;
  swap->tail->model = swap->held[1] = drum->model;
  swap->spare = drum->spare;
  drum->state = state;
  drum->spare = spare;
  drum->model = swap->new_model;
}

/* Former sounds stay at the outputs that they had, or go to those of their names. */
static void route(TaborDrum *drum, TaborSwap *swap) {
  if (swap->routed) {
    memcpy(swap->tail->mics, drum->route.mics, sizeof swap->tail->mics);
  } else {
    memcpy(swap->tail->mics, swap->mics, sizeof swap->mics);
    tb_tails_redirect(drum, swap->mics);
  }
  drum->route = swap->route;
}

/* Every microphone that goes on has the response that it had. */
static bool hears_alike(const TaborSwap *swap) {
  const TaborDrumDef *from = &swap->old_model->def, *to = &swap->new_model->def;
  for (uint32_t i = 0; i < to->mic_count; i++) {
    const uint32_t mic = swap->mics[i];
    if (mic != TB_NO_MIC && from->mic[mic].response != to->mic[i].response) return false;
  }
  return true;
}

static bool is_same(const TaborSwap *swap) {
  return swap->old_model->fingerprint == swap->new_model->fingerprint && hears_alike(swap);
}

static void begin_tail(TaborDrum *drum, TaborSwap *swap, bool continues) {
  const double rate = drum->model->sample_rate;
  if (swap->tail->state->asleep && !drum->tails) return;
  if (continues && is_same(swap)) return;
  if (continues) {
    tb_tails_begin(drum, swap->tail, (uint32_t)(HOLD * rate), (uint32_t)(FADE * rate));
  } else {
    tb_tails_begin(drum, swap->tail, 0, (uint32_t)(RING_OUT * rate));
  }
}

bool tb_swap_act(TaborDrum *drum, TaborSwap *swap, bool anew) {
  const bool continues = swap->mapping.continues && !anew;
  if (atomic_exchange(&swap->used, true)) return false;
  if (swap->old_model != drum->model) {
    atomic_store(&swap->acted, true); /* it holds nothing of this drum's: free it */
    return false;
  }
  TbView from = tb_view(drum->state, drum->model);
  TbView to = tb_view(swap->tail->state, swap->new_model);
  to.state->ledger = from.state->ledger;
  to.state->event_debt = from.state->event_debt;
  const double before = tb_energy_stored(&from, &from.now, &from.last);
  if (continues) continue_on(swap, &from, &to);
  to.state->live.output = from.state->live.output;
  to.state->ledger.sums.control += tb_energy_stored(&to, &to.now, &to.last) - before;
  exchange(drum, swap);
  route(drum, swap);
  begin_tail(drum, swap, continues);
  drum->at_rest = !continues;
  atomic_store(&swap->acted, true);
  return true;
}

bool tabor_swap_done(const TaborSwap *swap) {
  return atomic_load(&swap->acted) && !atomic_load(&swap->tail->sounds) &&
         !atomic_load(&swap->spare->sounds);
}
