/* SPDX-License-Identifier: MIT */
/* Continuing a ringing drum on another model.
 *
 * To keep the displacements unchanged would make a parametric pump: toggling the tension by 10 %
 * every 64 samples multiplies the energy without bound. To keep phase and action per mode does not.
 * With t = w_d k, im = (q- - q cos t0)/sin t0, c = sqrt(sin t0/sin t1),
 *   q' = c q, q-' = c (q cos t1 + im sin t1);
 * the energy then follows w1/w0. Modes are matched by (m, place in their order, cosine or sine),
 * which is right while only tensions, masses, losses or quality changed. For another radius,
 * boundary or side, the old drum rings out under a short fade. Audio-safe but for tb_swap_map(). */
#include <math.h>
#include <string.h>

#include "drum/drum.h"
#include "drum/drum_create.h"
#include "math/portable_math.h"
#include "step/energy.h"
#include "step/live_params.h"
#include "step/penetration.h"
#include "step/step.h"
#include "step/stick_rigid.h"
#include "step/striker_pool.h"

static const double FADE = 0.03; /* [s] */
enum { MOST_FADES = 4 };         /* at once; a further one ends the oldest */

/* ---- set-up --------------------------------------------------------------------------------- */

static void map_mics(TaborSwap *swap) {
  const TaborDrumDef *from = &swap->old_model->def, *to = &swap->new_model->def;
  for (uint32_t i = 0; i < from->mic_count; i++) {
    const int mic = tabor_drum_def_find_mic(to, from->mic[i].name);
    swap->mics[i] = mic < 0 ? TB_NO_MIC : (uint8_t)mic;
  }
}

static bool continues(const TaborModel *a, const TaborModel *b) {
  return a->def.shell.radius == b->def.shell.radius && a->def.shell.depth == b->def.shell.depth &&
         a->def.shell.boundary == b->def.shell.boundary && a->def.two_headed == b->def.two_headed &&
         a->wires.count == b->wires.count && a->wires.head == b->wires.head &&
         a->wires.side == b->wires.side && a->def.wires.angle == b->def.wires.angle;
}

static uint32_t find_mode(const TaborModel *model, const TbHeadMode *wanted, uint8_t sine) {
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    if (model->modes.row[i] == TB_NO_MODE) continue;
    const TbHeadMode *mode = &model->head.modes[model->modes.row[i]];
    if (mode->m == wanted->m && mode->index == wanted->index && model->modes.sine[i] == sine)
      return i;
  }
  return TB_NO_MODE;
}

/* w_d k, or -1 for an overdamped mode. */
static double turn_per_sample(const TbHeadMode *mode, double k) {
  const double square = mode->omega * mode->omega - mode->decay_rate * mode->decay_rate;
  return square > 0.0 ? sqrt(square) * k : -1.0;
}

static void map_mode(TbMapping *map, uint32_t i, const TbHeadMode *from, const TbHeadMode *to,
                     double k) {
  const double t0 = turn_per_sample(from, k), t1 = turn_per_sample(to, k);
  if (t0 == t1 || t0 <= 0.0 || t1 <= 0.0) return; /* scale 0: copy */
  tb_sin_cos(t0, &map->sin_old[i], &map->cos_old[i]);
  tb_sin_cos(t1, &map->sin_new[i], &map->cos_new[i]);
  map->scale[i] = sqrt(map->sin_old[i] / map->sin_new[i]);
}

bool tb_swap_map(TaborSwap *swap) {
  TbMapping *map = &swap->mapping;
  const TaborModel *from = swap->old_model, *to = swap->new_model;
  map->continues = continues(from, to);
  map_mics(swap);
  if (!map->continues) return true;
  const uint32_t n = to->modes.padded;
  const bool same = from->fingerprint == to->fingerprint;
  map->mode = tb_arena_take(&swap->arena, n, sizeof *map->mode);
  double **arrays[] = {&map->scale, &map->cos_old, &map->sin_old, &map->cos_new, &map->sin_new};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
    *arrays[i] = tb_arena_doubles(&swap->arena, n);
  }
  if (swap->arena.failed) return false;
  for (uint32_t i = 0; i < n; i++) {
    map->mode[i] = same ? i : TB_NO_MODE; /* those that stand for missing modes, see wire_yield.h */
    if (to->modes.row[i] == TB_NO_MODE) continue;
    const TbHeadMode *mode = &to->head.modes[to->modes.row[i]];
    map->mode[i] = find_mode(from, mode, to->modes.sine[i]);
    if (map->mode[i] == TB_NO_MODE) continue;
    map_mode(map, i, &from->head.modes[from->modes.row[map->mode[i]]], mode, to->time_step);
  }
  return true;
}

/* ---- on the audio thread -------------------------------------------------------------------- */

static void carry_modes(const TbMapping *map, const TbView *from, TbView *to) {
  for (uint32_t i = 0; i < to->model->modes.padded; i++) {
    const uint32_t source = map->mode[i];
    if (source == TB_NO_MODE) continue;
    const double q = from->now.q[source], last = from->last.q[source];
    const double c = map->scale[i];
    if (c == 0.0) {
      to->now.q[i] = q;
      to->last.q[i] = last;
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

static void carry_wires(const TbView *from, TbView *to) {
  for (uint32_t w = 0; w < to->model->wires.count; w++) {
    const TbWire *a = &from->model->wires.wires[w], *b = &to->model->wires.wires[w];
    carry_nodes(a, b, from->now.v + a->first_node, to->now.v + b->first_node);
    carry_nodes(a, b, from->last.v + a->first_node, to->last.v + b->first_node);
  }
}

/* A live value that the player moved, or that both definitions share, goes on as it is. */
static void carry_live(const TbView *from, TbView *to) {
  TbLiveParam fresh[TB_LIVE_COUNT], old_fresh[TB_LIVE_COUNT];
  memcpy(fresh, to->state->live, sizeof fresh);
  tb_live_params_definition(from->model, old_fresh);
  for (uint32_t i = 0; i < TB_LIVE_COUNT; i++) {
    const TbLiveParam *live = &from->state->live[i];
    const bool untouched = live->left == 0 && live->now == old_fresh[i].now;
    to->state->live[i] = untouched ? fresh[i] : *live;
  }
}

/* Penetrations follow from displacements; where nothing changed they are the same to the bit. */
static void carry_contacts(const TbView *from, TbView *to) {
  const uint32_t stride = to->model->wires.stride;
  if (from->model->fingerprint == to->model->fingerprint) {
    const size_t bytes = (stride + TB_SLOTS) * sizeof(double);
    memcpy(to->now.eta, from->now.eta, bytes);
    memcpy(to->last.eta, from->last.eta, bytes);
    memcpy(to->solve.warm.force, from->solve.warm.force, bytes);
    to->state->lifted = from->state->lifted;
    to->state->gap = from->state->gap;
    tb_view_lift(to, from->state->lifted != 0);
    return;
  }
  tb_penetrations_from_displacements(to, &to->now);
  tb_penetrations_from_displacements(to, &to->last);
}

static void carry_missing(const TbView *from, TbView *to, uint32_t slot) {
  double *now = to->now.missing[slot], *last = to->last.missing[slot];
  memcpy(now, from->now.missing[slot], sizeof from->now.missing[slot]);
  memcpy(last, from->last.missing[slot], sizeof from->last.missing[slot]);
  tb_residual_modes_carry(tb_slot_missing(from, slot), tb_slot_missing(to, slot), now, last);
}

static void carry_bending(const TbView *from, TbView *to, uint32_t slot) {
  double *now = to->now.bow[slot], *last = to->last.bow[slot];
  TbSlot *s = &to->state->slots[slot];
  if (s->bends && !s->partner) s->bends = tb_rigid_stick_bends(to, s->definition);
  if (!s->bends) return;
  memcpy(now, from->now.bow[slot], sizeof from->now.bow[slot]);
  memcpy(last, from->last.bow[slot], sizeof from->last.bow[slot]);
  tb_stick_carry(tb_rigid_stick_body(from, slot), tb_rigid_stick_body(to, slot), now, last);
}

/* A striker that the other model has, and a brush if it is one. */
static bool is_known(const TaborModel *model, const TbSlot *slot) {
  const TaborStrikerDef *striker = &model->def.striker[slot->definition];
  if (slot->definition >= model->def.striker_count) return false;
  return !slot->bristles || striker->kind == TABOR_STRIKER_BRUSH;
}

static void carry_slots(const TbView *from, TbView *to) {
  const bool same = from->model->fingerprint == to->model->fingerprint;
  const uint32_t first = to->model->wires.stride;
  to->state->serial = from->state->serial;
  memcpy(to->state->brushes, from->state->brushes, sizeof to->state->brushes);
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    const TbSlot *slot = &from->state->slots[i];
    const bool muffles = i >= TB_MUFFLERS && i < TB_BRISTLES;
    if (slot->kind == TB_SLOT_FREE || muffles || !is_known(to->model, slot)) continue;
    to->state->slots[i] = *slot;
    to->state->slot_mask |= 1u << i;
    to->now.z[i] = from->now.z[i];
    to->last.z[i] = from->last.z[i];
    carry_missing(from, to, i);
    carry_bending(from, to, i);
  }
  tb_pool_muffle(to);
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    if (to->state->slots[i].kind == TB_SLOT_FREE) continue;
    const double force = from->solve.warm.force[from->model->wires.stride + i];
    const double now = to->now.eta[first + i], last = to->last.eta[first + i];
    tb_pool_rebuild(to, i);
    if (same) {
      to->solve.warm.force[first + i] = force;
      to->state->slot_laws[i] = from->state->slot_laws[i];
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
  memcpy(to->stretch_carry, from->stretch_carry, carried);
}

/* Modes of the high band are chosen anew in every model: only the same model's go on. */
static void carry_high(const TbView *from, TbView *to) {
  if (from->model->fingerprint != to->model->fingerprint) return;
  const size_t bytes = to->model->high.padded * sizeof(double);
  memcpy(to->now.high, from->now.high, bytes);
  memcpy(to->last.high, from->last.high, bytes);
  memcpy(to->high_held, from->high_held, bytes);
  to->state->held = from->state->held;
  to->state->hold_steps = from->state->hold_steps;
  to->state->contacts = from->state->contacts;
}

static void carry_sound(const TaborSwap *swap, const TbView *from, TbView *to) {
  for (uint32_t i = 0; i < from->model->def.mic_count; i++) {
    const uint32_t mic = swap->mics[i];
    if (mic == TB_NO_MIC || from->model->mics[i].delay != to->model->mics[mic].delay) continue;
    memcpy(to->delay[mic], from->delay[i], (to->model->mics[mic].delay + 1u) * sizeof(double));
    to->state->delay_at[mic] = from->state->delay_at[i];
    memcpy(to->state->treble[mic], from->state->treble[i], sizeof to->state->treble[mic]);
  }
}

static void continue_on(const TaborSwap *swap, TbView *from, TbView *to) {
  TbState *state = to->state;
  state->clock = from->state->clock;
  state->asleep = from->state->asleep;
  state->quiet_checks = from->state->quiet_checks;
  carry_modes(&swap->mapping, from, to);
  carry_wires(from, to);
  carry_live(from, to);
  memcpy(state->shift, from->state->shift, sizeof state->shift);
  tb_live_params_apply(to);
  carry_contacts(from, to);
  carry_slots(from, to);
  carry_high(from, to);
  carry_sound(swap, from, to);
}

static void exchange(TaborDrum *drum, TaborSwap *swap) {
  TbState *old_state = drum->state;
  TaborModel *old_model = drum->model;
  drum->state = swap->state;
  drum->model = swap->new_model;
  swap->state = old_state;
  swap->held[1] = old_model; /* the drum's reference to the old one against ours to the new */
}

/* Ends the fades from *link on, the oldest included. Who is done may be freed at once. */
static void end_fades(TaborSwap **link) {
  TaborSwap *swap = *link;
  *link = NULL;
  while (swap) {
    TaborSwap *before = swap->before;
    atomic_store(&swap->done, true);
    swap = before;
  }
}

static void begin_fade(TaborDrum *drum, TaborSwap *swap) {
  TaborSwap **link = &drum->fading;
  for (int i = 1; *link && i < MOST_FADES; i++) link = &(*link)->before;
  end_fades(link);
  swap->fade_length = swap->fade_left = (uint32_t)(FADE * drum->model->sample_rate);
  swap->before = drum->fading;
  drum->fading = swap;
}

/* What fades already goes on into the microphones of its names. */
static void redirect_fades(TaborDrum *drum, const TaborSwap *swap) {
  for (TaborSwap *fading = drum->fading; fading; fading = fading->before) {
    for (uint32_t i = 0; i < fading->old_model->def.mic_count; i++) {
      if (fading->mics[i] != TB_NO_MIC) fading->mics[i] = swap->mics[fading->mics[i]];
    }
  }
}

bool tb_swap_act(TaborDrum *drum, TaborSwap *swap) {
  if (atomic_exchange(&swap->used, true)) return false;
  if (swap->old_model != drum->model) {
    atomic_store(&swap->done, true); /* it holds nothing of this drum's: free it */
    return false;
  }
  redirect_fades(drum, swap);
  TbView from = tb_view(drum->state, drum->model);
  TbView to = tb_view(swap->state, swap->new_model);
  to.state->sums = from.state->sums;
  to.state->statistics = from.state->statistics;
  to.state->event_debt = from.state->event_debt;
  const double before = tb_energy_stored(&from, &from.now, &from.last);
  if (swap->mapping.continues) continue_on(swap, &from, &to);
  to.state->sums.control += tb_energy_stored(&to, &to.now, &to.last) - before;
  exchange(drum, swap);
  const bool rings = !swap->mapping.continues && !swap->state->asleep;
  if (rings) {
    begin_fade(drum, swap);
  } else {
    atomic_store(&swap->done, true);
  }
  return true;
}

/* Bits of the old drum's microphones that anybody hears. */
static uint32_t heard_before(const TaborSwap *swap, uint32_t heard) {
  uint32_t before = 0;
  for (uint32_t i = 0; i < swap->old_model->def.mic_count; i++) {
    if (swap->mics[i] != TB_NO_MIC) before |= (heard >> swap->mics[i] & 1u) << i;
  }
  return before;
}

static void fade(TaborSwap *swap, uint32_t heard, double *pressure) {
  TbView view = tb_view(swap->state, swap->old_model);
  double ringing[TABOR_MAX_MICS] = {0.0};
  tb_step(&view, heard_before(swap, heard), ringing);
  const double gain = (double)swap->fade_left / (double)(swap->fade_length + 1u);
  for (uint32_t i = 0; i < swap->old_model->def.mic_count; i++) {
    if (swap->mics[i] != TB_NO_MIC) pressure[swap->mics[i]] += gain * ringing[i];
  }
  swap->fade_left--;
}

/* None ends later than those that began after it. */
void tb_swap_fade(TaborDrum *drum, uint32_t heard, double *pressure) {
  TaborSwap **link = &drum->fading;
  for (TaborSwap *swap = *link; swap; swap = swap->before) fade(swap, heard, pressure);
  while (*link && (*link)->fade_left > 0) link = &(*link)->before;
  end_fades(link);
}

void tb_swap_finish(TaborDrum *drum) { end_fades(&drum->fading); }

bool tabor_swap_done(const TaborSwap *swap) { return atomic_load(&swap->done); }
