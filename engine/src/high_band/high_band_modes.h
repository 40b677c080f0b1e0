/* SPDX-License-Identifier: MIT */
/* Choice of the high band's modes from all Bessel functions of both heads. Set-up only. */
#ifndef TB_HIGH_BAND_MODES_H
#define TB_HIGH_BAND_MODES_H

#include "bodies/body.h"

/* One Bessel function of one head, or a mode of the enclosed air with the wave that it is on a
 * head; cosine and sine copies together, at unit modal mass. */
typedef struct TbHighMode {
  uint32_t head, m;
  bool of_air;
  double in_head; /* part of its energy */
  uint32_t band;  /* sixth of an octave */
  double zero, slope, scale, omega;
  double decay_rate,
    radiation_rate;  /* [1/s]; of both sides or the outer one, in decay_rate or yet to be added */
  double scattering; /* variance of the phase that it gains per time [rad2/s]: see scattering.h */
  double loudness;   /* the largest over microphones */
  double fields[2 * TABOR_MAX_MICS];
} TbHighMode;

/* Chosen modes in the order of their bands; NULL if memory ran out. */
typedef struct TbHighModes {
  TbHighMode *modes;
  uint32_t count;      /* of modes */
  uint32_t copies;     /* of modes, sine copies counted */
  uint32_t candidates; /* Bessel functions to choose from */
} TbHighModes;

/* The drum that they are of. */
typedef struct TbHighDrum {
  const TaborDrumDef *def;
  const TbBody *body;  /* its two-way modes */
  double time_step;    /* [s] */
  uint32_t wired_head; /* on which wires lie; TB_HEADS: none */
} TbHighDrum;

/* Chooses modes up to `top` [Hz], at most `most` with copies. Returns false if memory ran out. */
bool tb_high_modes_choose(TbHighModes *chosen, TbArena *scratch, const TbHighDrum *drum, double top,
                          uint32_t most);

#endif
