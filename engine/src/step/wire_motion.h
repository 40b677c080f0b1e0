/* SPDX-License-Identifier: MIT */
/* Between modes and the wires' contact points, in the precision that contacts are solved in (solve.h).
 *
 * In single precision penetrations are not read off displacements, of which a change over two samples is a
 * ten-thousandth: they advance by the change itself, next - last, rounded once it is known in double. What rounding
 * adds up to, some 1e-12 m, is taken back every 64 samples (`settle`). Audio-safe. */
#ifndef TB_WIRE_MOTION_H
#define TB_WIRE_MOTION_H

#include "step/state.h"

typedef struct TbWireMotion {
  /* view->change = the free motion on the grid, in single precision what it changes over two samples. */
  void (*project)(TbView *view);
  /* r of stretch.h on the grid. */
  void (*stretch)(TbView *view);
  /* The wires' part of b from view->change. */
  void (*penetrate)(TbView *view);
  /* The response to the last forces at the wires' points += what a motion of the grid means there. */
  void (*renew)(TbView *view, const double *motion);
  /* view->modal from view->change, forces on the grid. */
  void (*project_forces)(TbView *view);
  /* Penetrations of both instants as displacements have them. */
  void (*settle)(TbView *view);
} TbWireMotion;

extern const TbWireMotion tb_wire_motion, tb_wire_motionf;

/* The one of the contacts' precision. */
static inline const TbWireMotion *tb_wire_motion_of(const TbView *view) {
  static const TbWireMotion *const MOTIONS[] = {
    [TB_IN_DOUBLE] = &tb_wire_motion, [TB_IN_FLOAT] = &tb_wire_motionf};
  return MOTIONS[view->solve.in.precision];
}

#endif
