/* SPDX-License-Identifier: MIT */
/* The wires' part of a drum's state (wires/wire_motion.h, step/wire_clearance.h). */
#ifndef TB_WIRE_STATE_H
#define TB_WIRE_STATE_H

#include "model/model.h"

typedef struct TbWireState {
  uint32_t lifted; /* they hang clear of the head: see wire_clearance.h */
  double gap;      /* least clearance of lifted wires [m] */
  TbWireCoefficients coefficients[TABOR_MAX_WIRES];
  double shift[TABOR_MAX_WIRES]; /* penetration gained since rest by moving the ends [m] */
} TbWireState;

#endif
