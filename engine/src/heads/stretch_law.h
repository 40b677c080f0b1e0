/* SPDX-License-Identifier: MIT */
/* How the scalars of stretch.h depend on the modes: for membranes by Berger's approximation
 * (berger.c), for plates by von Karman's equations (von_karman.h). Audio-safe. */
#ifndef TB_STRETCH_LAW_H
#define TB_STRETCH_LAW_H

#include "state/state.h"

typedef struct TbStretchLaw {
  /* Decides how many scalars act in this step, and fills view->stretch.mixed for them; books what
   * begins and what ends. */
  uint32_t (*begin)(TbView *view);
  /* The sum to be added to Y^T (x + q-). */
  double (*shift)(const TbView *view);
  /* Call after view->end.stretch is known. */
  void (*end)(TbView *view);
  /* Energy stored between two instants [J]. */
  double (*energy)(const TbView *view, const TbPhase *next, const TbPhase *now);
} TbStretchLaw;

extern const TbStretchLaw tb_berger, tb_von_karman;

/* A stick, or loud sound from outside, makes large deflections within a few steps. */
bool tb_stretch_is_driven(const TbView *view);

#endif
