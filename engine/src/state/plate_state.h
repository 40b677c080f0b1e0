/* SPDX-License-Identifier: MIT */
/* A plate's part of the state: its large deflections (heads/von_karman.h), and the air between two
 * (heads/hihat_air.h). */
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

/* Volumes [m^3] are of a step; the last two fields are of no effect between steps. */
typedef struct TbHihatAirState {
  double pressure;    /* p [Pa] */
  double energy;      /* e [J]; below 0 by what the contacts of one step took too much */
  double by_contacts; /* what contacts added to W in the last step */
  double mean;        /* P [Pa] */
  double foreseen;    /* W without contacts */
} TbHihatAirState;

#endif
