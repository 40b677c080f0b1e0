/* SPDX-License-Identifier: MIT */
/* The step of the high band (high_band_step.h), compiled once per precision: see real.h. */
#include "air/high_band_step.h"

#include <string.h>

#include "kernels/real.h"
#include "math/draw.h"

/* [m kg^1/2]; denormals begin at 1e-308, in single precision at 1e-38. */
static const Real VANISHED = REAL(SINGLE ? 1e-30 : 1e-150);

static const TYPE_OF(TbKernels) * kernels_of(const TbView *view) {
  return view->model->NAME_OF(kernels);
}

static const TYPE_OF(TbRinging) * ringing_of(const TbView *view) {
  return &view->model->high.NAME_OF(ringing);
}

static Real *drive_of(const TbView *view, uint32_t slot) {
  return (Real *)view->high.drive + (size_t)slot * view->model->high.padded;
}

static void begin(const TbView *view) {
  const TbHighBand *high = &view->model->high;
  view->state->high.scattered = 0;
  if (high->count) memcpy(view->high.turn, ringing_of(view)->a, high->padded * sizeof(Real));
}

/* Limited to what flows into the bed (wire_hold.h). */
static void hold(const TbView *view, const double *resistance) {
  const TbHighBand *high = &view->model->high;
  const uint32_t head = view->model->wires.head;
  const Real *share = ringing_of(view)->hold;
  Real *held = view->high.taken, most[TB_HOLD_BANDS];
  for (uint32_t band = 0; band < TB_HOLD_BANDS; band++) {
    most[band] = (Real)(view->model->time_step * high->wire_hold.most[band]);
  }
  for (uint32_t i = high->begin[head]; i < high->begin[head + 1]; i++) {
    const uint32_t band = high->hold_band[i];
    const Real part = share[i] * (Real)resistance[band];
    held[i] = part * most[band] / (part + most[band]);
  }
}

/* True if wires take part of a block's motion. */
static bool holds(const TbView *view, uint32_t from) {
  const TbHighBand *high = &view->model->high;
  const uint32_t head = view->model->wires.head;
  return view->state->high.wires_hold && !view->state->wires.lifted && from >= high->begin[head] &&
         from < high->begin[head + 1];
}

enum { BLOCK = 8 };

/* Random numbers of a block of modes, from -1 to 1. */
static void draw(const TbHighBand *high, uint64_t place, Real drawn[BLOCK]) {
  const uint64_t bits[2] = {tb_draw_bits(high->seed, 2 * place),
                            tb_draw_bits(high->seed, 2 * place + 1)};
  for (uint32_t i = 0; i < BLOCK; i++) {
    const int32_t part = (int32_t)(bits[i / 4] >> 16 * (i % 4) & 0xffff);
    drawn[i] = (Real)(2 * part - 0xffff) * REAL(1.0 / 0xffff);
  }
}

static void scatter(const TbView *view) {
  const TbHighBand *high = &view->model->high;
  const uint64_t step = view->state->high.scattered++, block = step % high->scatter_steps;
  if (BLOCK * block >= high->padded) return;
  const uint32_t from = (uint32_t)(BLOCK * block);
  const TYPE_OF(TbRinging) *ringing = ringing_of(view);
  Real drawn[BLOCK] __attribute__((aligned(64)));
  draw(high, step, drawn);
  const TYPE_OF(TbScattering)
    scattering = {.a = ringing->a + from,
                  .b = ringing->b + from,
                  .walk = ringing->walk + from,
                  .held = (const Real *)view->high.taken + from,
                  .draw = drawn,
                  .now = (const Real *)view->now.high + from,
                  .wires = holds(view, from) ? (Real)high->scatter_by_wires : REAL(0.0),
                  .last = (Real *)view->last.high + from,
                  .turn = (Real *)view->high.turn + from};
  kernels_of(view)->turn_phases(&scattering);
}

static TbPair move(const TbView *view, uint32_t mic, TbRingParts parts) {
  const TYPE_OF(TbRinging) *ringing = ringing_of(view);
  const TYPE_OF(TbRing) ring = {.parts = parts,
                                .a = view->high.turn,
                                .b = ringing->b,
                                .now = view->now.high,
                                .last = view->last.high,
                                .next = view->next.high,
                                .push = view->high.force,
                                .share = (Real)view->state->high.push.share,
                                .held = view->high.taken,
                                .ahead = ringing->ahead[mic],
                                .behind = ringing->behind[mic]};
  return kernels_of(view)->resonate(&ring);
}

static void strike(const TbView *view, uint32_t slot, double force) {
  kernels_of(view)->axpy(view->model->high.begin[1], view->next.high, (Real)force,
                         drive_of(view, slot));
}

static TbPair sums(const TbView *view, uint32_t mic, const TbPhase *phase) {
  const TYPE_OF(TbRinging) *ringing = ringing_of(view);
  return kernels_of(view)->two_dots(view->model->high.padded, ringing->ahead[mic],
                                    ringing->behind[mic], phase->high);
}

static void keep_drive(const TbView *view, uint32_t slot, const double *drive) {
  Real *kept = drive_of(view, slot);
  for (uint32_t i = 0; i < view->model->high.begin[1]; i++) kept[i] = (Real)drive[i];
}

static double energy(const TbView *view) {
  const TbHighBand *high = &view->model->high;
  const double rate = view->model->step_rate;
  const Real *next = view->now.high, *now = view->last.high;
  double sum = 0.0;
  for (uint32_t i = 0; i < high->padded; i++) {
    sum += tb_pole_energy(rate, high->stiffness[i], (double)next[i], (double)now[i]);
  }
  return 0.5 * sum;
}

static double heard(const TbView *view) {
  const TbHighBand *high = &view->model->high;
  const Real *now = view->now.high, *last = view->last.high;
  double sum = 0.0;
  for (uint32_t i = 0; i < high->padded; i++) {
    const double step = (double)(now[i] - last[i]);
    sum += view->model->resting.heard_high[i] * step * step;
  }
  return sum;
}

/* Without branches: the compiler takes several at once. */
static void clear_small(const TbView *view) {
  Real *now = view->now.high, *last = view->last.high;
  for (uint32_t i = 0; i < view->model->high.padded; i++) {
    const bool gone = (REAL_SIZE(now[i]) < VANISHED) & (REAL_SIZE(last[i]) < VANISHED);
    now[i] = gone ? REAL(0.0) : now[i];
    last[i] = gone ? REAL(0.0) : last[i];
  }
}

const TbHighBandStep NAME_OF(tb_high_band_step) = {begin, scatter,    hold,   move,  strike,
                                                   sums,  keep_drive, energy, heard, clear_small};
