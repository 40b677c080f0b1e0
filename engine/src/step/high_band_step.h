/* SPDX-License-Identifier: MIT */
/* The state of the high band (model/high_band.h) in one precision; high_band_step_tmpl.c is compiled for each. Audio-safe. */
#ifndef TB_HIGH_BAND_STEP_H
#define TB_HIGH_BAND_STEP_H

#include "step/state.h"

typedef struct TbHighBandStep {
  /* Moves all modes from view->now to view->next; returns what microphone `mic` hears of them. */
  TbPair (*move)(const TbView *view, uint32_t mic, TbRingParts parts);
  /* Pushes the batter head's modes in view->next by a force at a slot. */
  void (*strike)(const TbView *view, uint32_t slot, double force);
  /* Sums of a microphone over the modes. */
  TbPair (*sums)(const TbView *view, uint32_t mic, const TbPhase *phase);
  /* Keeps what a unit force at a slot does, drive[begin[1]]. */
  void (*keep_drive)(const TbView *view, uint32_t slot, const double *drive);
  /* Energy between view->last and view->now [J]. */
  double (*energy)(const TbView *view);
  /* Sets to 0 what is next to nothing in both. */
  void (*clear_small)(const TbView *view);
} TbHighBandStep;

extern const TbHighBandStep tb_high_band_step, tb_high_band_stepf;

/* The one of the model's precision. */
static inline const TbHighBandStep *tb_high_band_step_of(const TbView *view) {
  static const TbHighBandStep *const RINGS[] = {
    [TB_IN_DOUBLE] = &tb_high_band_step, [TB_IN_FLOAT] = &tb_high_band_stepf};
  return RINGS[view->model->high.precision];
}

#endif
