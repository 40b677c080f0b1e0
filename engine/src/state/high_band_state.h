/* SPDX-License-Identifier: MIT */
/* The high band's part of a drum's state (air/high_band_step.h). */
#ifndef TB_HIGH_BAND_STATE_H
#define TB_HIGH_BAND_STATE_H

#include "model/model.h"

typedef struct TbHighBandState {
  uint64_t scattered;      /* steps of scattering since every mode had its own frequency */
  uint32_t wires_hold;     /* 1: wires take part of the modes' motion, the view's high.taken */
  uint32_t hold_steps;     /* steps since that was renewed */
  uint32_t struck;         /* 1: a striker other than a brush pushed the modes in the last step */
  TbWireContacts contacts; /* sums over these steps */
  TbWirePush push;
} TbHighBandState;

/* Its arrays. */
typedef struct TbHighBandView {
  void *drive;     /* [TB_SLOTS][padded], in its precision */
  void *turn;      /* [padded], likewise: a of TbRinging at the frequency that scattering gave */
  double *scratch; /* [padded] */
  void *taken;     /* [padded], in its precision: see high_band_step.h */
  float *force;    /* [padded] push of the wires */
  float *steady;   /* [padded] what stays of it: see model/high_band.h */
} TbHighBandView;

#endif
