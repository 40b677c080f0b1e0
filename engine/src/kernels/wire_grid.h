/* SPDX-License-Identifier: MIT */
/* The head's motion under the bed of wires, on a coarse grid, in both precisions: TbWireGrid and
 * TbWireGridF.
 *
 * The head is smooth on the scale of half its shortest wavelength, while contact points lie closer.
 * Lane j is the contact point of number j along each wire:
 *   w(lane j, wire v) = Sum_l across[v][l] Sum_a along[j][a] c[l][a],
 * and forces go back through the transposed table,
 *   C[l][a] = Sum_j along[j][a] Sum_v across[v][l] f[v][j].
 * So the work done on the head is f w = C c to rounding, however coarse the grid.
 *
 * The shapes across and along are the principal components of the modes' own shapes at the contact
 * points (Karhunen-Loeve: the fewest shapes that reach a given accuracy). A single wire has one
 * shape across, 1. A grid along that would save nothing is left out. For a single wire without a
 * grid along, the transfer is exact.
 *
 * Mirror symmetries make classes that do not mix: even or odd along (x -> -x) times even or odd
 * across (y -> -y). If the bed is its own mirror image across, wires and their images go in pairs,
 * and even lines come before the odd ones. Half the lanes represent all: the folded f_j + f_mirror
 * and f_j - f_mirror. Without a grid along these are the points. TbWireGridF with a grid along does
 * not fold (halves = 1): the classes along stand side by side and each shape covers all lanes,
 * since folding costs more than it saves when a register holds twice as many numbers.
 *
 * A grid vector holds class after class (even along first, then even across first), each as
 * [line][column] padded with zeros to a multiple of 8. The head's response to a grid vector is
 * c = G C (TbCompliance), one matrix per class. kernels.h has the kernels that use these types. */
#ifndef TB_WIRE_GRID_H
#define TB_WIRE_GRID_H

#include <stdbool.h>
#include <stdint.h>

/* Elements before the scratch's parts, which folding reads and does not use. */
enum { TB_WIRE_GRID_SLACK = 8 };

#define TB_TEMPLATE "kernels/wire_grid_tmpl.h"
#include "kernels/both.h"

static inline uint32_t tb_wire_grid_class(const TbWireGrid *wire_grid, uint32_t along,
                                          uint32_t across) {
  return along * wire_grid->quarters + across;
}

#endif
