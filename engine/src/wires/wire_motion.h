/* SPDX-License-Identifier: MIT */
/* Motion between modes and the wires' contact points, in the precision of the contact solve
 * (solve.h).
 *
 * In single precision, penetrations are not computed from displacements, whose change over two
 * samples is only a ten-thousandth of them. Instead they advance by the change itself, next - last,
 * rounded once it is known in double. The accumulated rounding, some 1e-12 m, is removed every 64
 * samples (`settle`). Audio-safe. */
#ifndef TB_WIRE_MOTION_H
#define TB_WIRE_MOTION_H

#include "state/state.h"

typedef struct TbWireMotion {
  /* view->change = the free motion on the grid; in single precision, its change over two
   * samples. */
  void (*project)(TbView *view);
  /* Computes r of stretch.h on the grid. */
  void (*stretch)(TbView *view);
  /* Computes the wires' part of b from view->change. */
  void (*penetrate)(TbView *view);
  /* Adds the effect of a motion of the grid to the response to the last forces at the wires'
   * points. */
  void (*renew)(TbView *view, const double *motion);
  /* Computes view->modal from view->change, the forces on the grid. */
  void (*project_forces)(TbView *view);
  /* Recomputes the penetrations of both instants from displacements. */
  void (*settle)(TbView *view);
} TbWireMotion;

/* Computes phase->eta[stride], the penetrations of the wires' contact points, from the
 * displacements of `phase`: eta = side w - v
 * + eta_rest + shift. w is the head's and v the wire's displacement from rest; `shift` is the
 * penetration added by moving the wires' ends [m]. */
void tb_penetrations_from_displacements(TbView *view, TbPhase *phase);

extern const TbWireMotion tb_wire_motion, tb_wire_motionf;

/* The functions for the contacts' precision. */
static inline const TbWireMotion *tb_wire_motion_of(const TbView *view) {
  static const TbWireMotion *const MOTIONS[] = {
    [TB_IN_DOUBLE] = &tb_wire_motion, [TB_IN_FLOAT] = &tb_wire_motionf};
  return MOTIONS[view->solve.in.precision];
}

#endif
