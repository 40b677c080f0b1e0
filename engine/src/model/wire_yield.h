/* SPDX-License-Identifier: MIT */
/* Compliance of the head under the wires by the modes that a model leaves out.
 *
 * Two-way modes end at omega_c. To the wires, a head without the modes above is too stiff: beyond
 * omega_c it answers like a mass, and the wires chatter on that mass, brighter than on a head. A
 * striker has the same trouble, at one place (truncated_modes.h). Here there are hundreds of
 * places, close enough together to feel each other.
 *
 * The modes above are the Bessel functions of the wires' head by itself, each with the mass of the
 * air on both sides (head_waves.h), from omega_c up to omega_t, the top of what is heard. On the
 * grid under the wires (wire_grid.h), mode i of unit mass has the shape c_i. In each symmetry class
 * the grid feels two matrices,
 *   A = Sum c_i c_i^T,  B = Sum c_i c_i^T/omega_i^2,
 * the inverse mass at high frequency and the compliance at low frequency. Both are kept by as many
 * modes as the class has points: with B v = lambda A v, v^T A v = 1, their shapes on the grid are
 * A v and their frequencies lambda^(-1/2). Thousands of modes are thus replaced by a few hundred,
 * which belong to TbModes like others, but are neither heard nor struck.
 *
 * Each decays by (omega_t - omega_c)/2: waves as short as these leave the wires, and what the rim
 * returns is left to the high band (high_band.h). Without losses, these modes keep the energy.
 *
 * Limits: A and B are those of the truncated modes on the grid. A difference between neighbouring
 * wires that the grid cannot represent does not yield. If omega_t is within LEAST_RATIO of omega_c,
 * nothing to speak of is missing. */
#ifndef TB_WIRE_YIELD_H
#define TB_WIRE_YIELD_H

#include "model/projection.h"

/* The modes that stand for those left out, by symmetry class. */
typedef struct TbWireYield {
  uint32_t count[4]; /* a multiple of 8 */
  double *omega[4];  /* [count]; 0 for padding */
  double *shape[4];  /* [count][points of the class] */
  double decay_rate; /* of all [1/s] */
} TbWireYield;

struct TaborModel;

/* Whether the head yields to the wires by more modes than the model has. */
bool tb_wire_yields(const struct TaborModel *model);

/* Prepares the modes from the head's bandwidth up to the model's top, on the grid of `projection`.
 * Returns TABOR_ERROR_MEMORY or TABOR_ERROR_NUMERICS on failure. */
TaborStatus tb_wire_yield_prepare(TbWireYield *yield, TbArena *arena,
                                  const struct TaborModel *model, const TbProjection *projection);

/* Gives the modes, which stand last in each group of `modes`, their coefficients, and the tables of
 * `projection` their shapes. side: of the wires. */
void tb_wire_yield_apply(const TbWireYield *yield, TbModes *modes, TbProjection *projection,
                         double side, double time_step);

#endif
