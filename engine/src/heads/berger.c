/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "heads/stretch_law.h"

/* With single precision, G off its diagonal loses or creates energy as rounding has it: some 1e-8
 * of what it stores. */
static void mix(const TbView *view, const double *q) {
  const TaborModel *model = view->model;
  void (*const mixes[])(const TbMixing *mixing, const TbParts *moving, const double *x,
                        double *const out[TB_COUPLINGS]) = {
    [TB_IN_DOUBLE] = model->kernels->mix, [TB_IN_FLOAT] = model->kernelsf->mix};
  mixes[model->precision](&model->stretch.mixing, &view->moving, q, view->stretch.mixed);
}

/* next^T G now of head h off the diagonal, after mix() of now. */
static double mixed_square(const TbView *view, uint32_t h, const double *next) {
  const TbMixing *mixing = &view->model->stretch.mixing;
  double sum = 0.0;
  for (uint32_t b = 0; b < mixing->count; b++) {
    const TbMixingBlock *block = &mixing->block[b];
    for (uint32_t i = 0; i < block->count; i++) {
      sum += next[block->mode[i]] * view->stretch.mixed[h][block->mode[i]];
    }
  }
  return sum;
}

/* q^T G q of head h between two instants, after mix() of now. */
static double square_of(const TbView *view, uint32_t h, const double *next, const double *now) {
  const TbStretch *stretch = &view->model->stretch;
  const TbParts *parts = &stretch->parts;
  double square = mixed_square(view, h, next);
  for (uint32_t part = 0; part < parts->count; part++) {
    const uint32_t from = parts->from[part], to = from + parts->size[part];
    for (uint32_t i = from; i < to; i++) square += stretch->gain[h][i] * next[i] * now[i];
  }
  return square;
}

/* ---- whether heads stretch ------------------------------------------------------------------ */

/* 124 dB. Less lifts a head by 0.1 mm between two looks of has_risen(), which is about what `least`
 * is. */
static const double LOUD_AIR = 30.0; /* [Pa] */

bool tb_stretch_is_driven(const TbView *view) {
  const TbState *state = view->state;
  if (fabs(view->incident.now) > LOUD_AIR || state->wires.flung) return true;
  for (uint32_t slot = 0; state->strikers.mask >> slot; slot++) {
    if (tb_slot_strikes(&state->strikers.slots[slot])) return true;
  }
  return false;
}

/* Soft sound from outside, and wires, may make a head move without a stick: a look now and then. */
static bool has_risen(const TbView *view) {
  enum { STEPS = 64 };
  const TbStretch *stretch = &view->model->stretch;
  if (view->state->clock % STEPS > 0) return false;
  mix(view, view->now.q);
  for (uint32_t h = 0; h < stretch->count; h++) {
    const double square = square_of(view, h, view->now.q, view->now.q);
    if (stretch->factor[h] * square > stretch->least[h]) return true;
  }
  return false;
}

static uint32_t count_stretching(const TbView *view) {
  TbState *state = view->state;
  const TbStretch *stretch = &view->model->stretch;
  if (state->unstretched < stretch->hold) return stretch->count;
  if (tb_stretch_is_driven(view) || has_risen(view)) state->unstretched = 0;
  return state->unstretched < stretch->hold ? stretch->count : 0;
}

static double energy_of(const TbView *view, const double *next, const double *now) {
  const TbStretch *stretch = &view->model->stretch;
  double sum = 0.0;
  mix(view, now);
  for (uint32_t h = 0; h < stretch->count; h++) {
    const double square = square_of(view, h, next, now);
    sum += 0.25 * stretch->factor[h] * square * square;
  }
  return sum;
}

/* A head that stretches no more stores no stretch; one that begins to has it at once. */
static void book_change(TbView *view, uint32_t count) {
  TbState *state = view->state;
  const uint32_t stretches = count > 0;
  if (stretches == state->stretches) return;
  const double energy = energy_of(view, view->now.q, view->last.q);
  state->stretches = stretches;
  state->ledger.sums.control += stretches ? energy : -energy;
}

static uint32_t begin(TbView *view) {
  const uint32_t count = count_stretching(view);
  book_change(view, count);
  if (count > 0) mix(view, view->now.q);
  return count;
}

static double shift(const TbView *view) {
  (void)view;
  return 0.0;
}

/* Call after the tension's rises are known. */
static void count_unstretched(TbView *view) {
  TbState *state = view->state;
  const TbStretch *stretch = &view->model->stretch;
  const uint32_t most = stretch->hold < UINT32_MAX ? stretch->hold + 1u : 0u;
  if (state->unstretched < most) state->unstretched++;
  for (uint32_t h = 0; h < view->stretch.count; h++) {
    if (fabs(view->end.stretch[h]) > stretch->least[h]) state->unstretched = 0;
  }
}

static double energy(const TbView *view, const TbPhase *next, const TbPhase *now) {
  return view->state->stretches ? energy_of(view, next->q, now->q) : 0.0;
}

const TbStretchLaw tb_berger = {
  .begin = begin, .shift = shift, .end = count_unstretched, .energy = energy};
