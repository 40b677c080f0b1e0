/* SPDX-License-Identifier: MIT */
/* Between modes and the wires' contact points in single precision, where contacts are solved in it (singlesolve.h).
 *
 * Penetrations are not read off displacements, of which a change over two samples is a ten-thousandth: they
 * advance by the change itself, next - last, rounded once it is known in double. What rounding adds up to, some
 * 1e-12 m, is taken back every 64 samples (tb_single_settle). Audio-safe. */
#ifndef TB_SINGLE_MOTION_H
#define TB_SINGLE_MOTION_H

#include "step/state.h"

/* view->change = what the free motion changes on the grid over two samples. */
void tb_single_project(TbView *view);

/* r of stretch.h on the grid. */
void tb_single_stretch(TbView *view);

/* view->modal from view->change, forces on the grid. */
void tb_single_project_forces(TbView *view);

/* Their part of b from view->change. */
void tb_single_penetrate(TbView *view);

/* solve.product[stride] += what a motion of the grid means at the points. */
void tb_single_renew(TbView *view, const double *motion);

/* Penetrations of both instants as displacements have them. */
void tb_single_settle(TbView *view);

#endif
