/* SPDX-License-Identifier: MIT */
/* The step of the high band (model/high_band.h) in one precision; high_band_step_tmpl.c is compiled
 * for each. Audio-safe. */
#ifndef TB_HIGH_BAND_STEP_H
#define TB_HIGH_BAND_STEP_H

#include "state/state.h"

typedef struct TbHighBandStep {
  /* Fills view->high.turn: every mode swings at its own frequency, and scattering begins anew. */
  void (*begin)(const TbView *view);
  /* Draws the frequencies of eight modes anew, without a change of their phase and amplitude, so
   * that over time all lose their phase at the rates of scattering.h. Wires in contact scatter as
   * much as they take: 2 s more, s the decay rate by view->high.taken. Not while a striker pushes:
   * modes then lean by what it holds them, which is no motion whose phase could change. */
  void (*scatter)(const TbView *view);
  /* Fills view->high.taken: the part of each mode's motion that the wires take in a step, from the
   * resistance of all their points in each band of TbWireHold [N s/m]. */
  void (*hold)(const TbView *view, const double *resistance);
  /* Moves all modes from view->now to view->next. Returns the sums over the modes for microphone
   * `mic`. */
  TbPair (*move)(const TbView *view, uint32_t mic, TbRingParts parts);
  /* Applies a force at a slot (a place in the striker pool) to the batter head's modes in
   * view->next. */
  void (*strike)(const TbView *view, uint32_t slot, double force);
  /* Sums of a microphone over the modes. */
  TbPair (*sums)(const TbView *view, uint32_t mic, const TbPhase *phase);
  /* Stores the response to a unit force at a slot, drive[begin[1]]. */
  void (*keep_drive)(const TbView *view, uint32_t slot, const double *drive);
  /* Energy between view->last and view->now [J]. */
  double (*energy)(const TbView *view);
  /* Power that microphones hear of the motion from view->last to view->now, as a part of full
   * scale, squared. */
  double (*heard)(const TbView *view);
  /* Sets displacements that are negligible at both instants to 0. */
  void (*clear_small)(const TbView *view);
} TbHighBandStep;

extern const TbHighBandStep tb_high_band_step, tb_high_band_stepf;

/* The functions for the precision of the model's high band. */
static inline const TbHighBandStep *tb_high_band_step_of(const TbView *view) {
  static const TbHighBandStep *const RINGS[] = {
    [TB_IN_DOUBLE] = &tb_high_band_step, [TB_IN_FLOAT] = &tb_high_band_stepf};
  return RINGS[view->model->high.precision];
}

#endif
