/* SPDX-License-Identifier: MIT */
/* A plate's part of the state: its large deflections (heads/von_karman.h). */
#ifndef TB_PLATE_STATE_H
#define TB_PLATE_STATE_H

#include <stdint.h>

typedef struct TbPlateState {
  double psi[3];  /* of the three phases: between that instant and the one before [sqrt J] */
  double shift;   /* C [J] */
  double energy;  /* of the coupled modes at the last look [J] */
  double part;    /* of the coupling that acts, 0 to 1 */
  uint64_t draws; /* of the cascade, so far */
} TbPlateState;

#endif
