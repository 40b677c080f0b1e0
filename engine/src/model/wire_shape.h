/* SPDX-License-Identifier: MIT */
/* The shape of a wire that is bent along its length.
 *
 *   z(s) = A sqrt(2/12) Sum_j cos(g_j s/L + p_j), j = 1 to 12,
 *
 * z [m] is where the unloaded wire lies, away from the head, less where a straight one would lie;
 * s [m] counts from its middle. g_j is normally distributed with variance 1, p_j uniform,
 * both drawn from the seed and the wire's number. Over many wires, z(s) has mean 0, root mean
 * square A at every s, and correlation exp(-d^2/(2 L^2)) between places a distance d apart, the
 * characteristic function of g.
 *
 * Assumptions. A snare wire is a coil drawn out of straight and soldered at its ends, and keeps
 * bends of its making. We know of no measurement of them: the Gaussian correlation is the simplest
 * choice. The bent shape is free of stress under the wire's tension and stays the same when the
 * tension changes: it adds no stiffness and only moves the datum of the penetration. Bends sideways
 * are left out. Limiting case: A = 0 is a straight wire, exactly. */
#ifndef TB_WIRE_SHAPE_H
#define TB_WIRE_SHAPE_H

#include "tabor/tabor.h"

#define TB_WIRE_WAVES 12u

typedef struct TbWireShape {
  double height;                                          /* of each wave [m]: A sqrt(2/12) */
  double wavenumber[TB_WIRE_WAVES], phase[TB_WIRE_WAVES]; /* [1/m], [rad] */
} TbWireShape;

/* Draws the shape of wire `index`, from 0. The same bits on every machine. Set-up only. */
void tb_wire_shape_draw(TbWireShape *shape, const TaborWiresDef *wires, uint32_t index);

/* z [m] at s [m] from the middle. Set-up only. */
double tb_wire_shape_height(const TbWireShape *shape, double s);

#endif
