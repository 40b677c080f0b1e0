/* SPDX-License-Identifier: MIT */
/* The microphones' part of a drum's state (air/mic_output.h). */
#ifndef TB_MIC_STATE_H
#define TB_MIC_STATE_H

#include "model/mic_response.h"
#include "state/halve_rate.h"

/* A microphone's sums over the modes: A(n), B(n), B(n-1); see TbMic. */
typedef struct TbEar {
  double ahead, behind, behind_before;
} TbEar;

typedef struct TbMicState {
  uint32_t delay_at[TABOR_MAX_MICS];
  double treble[TABOR_MAX_MICS][3]; /* last input, last two outputs: see force_equalizer.h */
  double halved[TABOR_MAX_MICS][TB_HALVE_MEMORY]; /* see halve_rate.h */
  TbResponseMemory response[TABOR_MAX_MICS];      /* see mic_response.h */
  uint32_t heard;                                 /* whose `ears` are those of this instant */
  TbEar ears[TABOR_MAX_MICS];
  double kick[TABOR_MAX_MICS]; /* of a plate's large deflections, to come [Pa] */
} TbMicState;

#define TB_NO_TAP UINT32_MAX
#define TB_NO_EAR UINT32_MAX

/* Delay lines, and what of the microphones a step finds on the way. */
typedef struct TbMicView {
  double *delay[TABOR_MAX_MICS]; /* [delay + 1] */
  uint32_t
    ear; /* the microphone that the last pass over the modes has heard (step.c), or TB_NO_EAR */
  uint32_t tap;  /* a microphone whose signal is wanted before its delay, or TB_NO_TAP */
  double tapped; /* this signal of the newest step [Pa] */
} TbMicView;

#endif
