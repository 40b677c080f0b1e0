/* SPDX-License-Identifier: MIT */
/* The high band's part of a drum's state (air/high_band_step.h). */
#ifndef TB_HIGH_BAND_STATE_H
#define TB_HIGH_BAND_STATE_H

#include "model/model.h"

typedef struct TbHighBandState {
  uint32_t held;           /* wires hold modes: the view's high.held */
  uint32_t hold_steps;     /* samples since that was renewed */
  TbWireContacts contacts; /* sums over these samples */
} TbHighBandState;

/* Its arrays. */
typedef struct TbHighBandView {
  void *drive;     /* [TB_SLOTS][padded], in its precision */
  double *scratch; /* [padded] */
  void *held;      /* [padded], in its precision: see high_band_step.h */
  float *force;    /* [padded] of the wires */
} TbHighBandView;

#endif
