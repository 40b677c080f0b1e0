/* SPDX-License-Identifier: MIT */
/* The wires' part of a drum's state (wires/wire_motion.h, step/wire_clearance.h). */
#ifndef TB_WIRE_STATE_H
#define TB_WIRE_STATE_H

#include "model/model.h"

/* A finger on a wire: see wires/pluck.h. */
typedef struct TbPluck {
  uint32_t steps, done; /* until it lets go, and so far; 0: there is none */
  uint32_t node;        /* first of the two that it pulls, counted on the wire */
  uint32_t unused;
  double share; /* of the second one */
  double force; /* F0 [N], away from the head */
} TbPluck;

typedef struct TbWireState {
  uint32_t lifted; /* they hang clear of the head: see wire_clearance.h */
  uint32_t flung;  /* checks until plucked wires count as calm: see pluck.h */
  double gap;      /* least clearance of lifted wires [m] */
  TbWireCoefficients coefficients[TABOR_MAX_WIRES];
  double shift[TABOR_MAX_WIRES]; /* penetration gained since rest by moving the ends [m] */
  TbPluck plucks[TABOR_MAX_WIRES];
} TbWireState;

#endif
