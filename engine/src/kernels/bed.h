/* SPDX-License-Identifier: MIT */
/* The head's motion under the bed of wires, on a coarse grid.
 *
 * The head is smooth on the scale of half its shortest wavelength, while contact points lie closer:
 * w(lane j, wire v) = Sum_l across[v][l] Sum_a along[j][a] c[l][a], and forces go back through the
 * transposed table, C[l][a] = Sum_j along[j][a] Sum_v across[v][l] f[v][j], so that the work done on
 * the head is f w = C c to rounding, however coarse the grid.
 *
 * The shapes across and along are the principal components of the modes' own shapes at the contact
 * points (Karhunen-Loeve: the fewest that reach a given accuracy). One wire has one shape across,
 * 1, and a grid that would save nothing along is left out: then all is exact.
 *
 * Mirror symmetries make classes that do not mix: even or odd along (x -> -x) times even or odd across
 * (y -> -y). Half the lanes stand for all: the folded f_j + f_mirror and f_j - f_mirror.
 *
 * A grid vector holds class after class (even along first, then even across first), each as
 * [line][column] padded with zeros to 8. */
#ifndef TB_BED_H
#define TB_BED_H

#include "kernels/kernels.h"
#include "model/wires.h"

typedef struct TbBed {
  uint32_t wires, lanes, middle;
  uint32_t halves, quarters; /* symmetries, as in TbModes */
  uint32_t half;             /* folded lanes, padded; all lanes without symmetry */
  uint32_t lines;            /* shapes across */
  uint32_t first_line[3];    /* lines of each class across */
  uint32_t columns[2];       /* points per line of each class along */
  bool thinned;              /* `squeeze` and `spread` are used */
  double *across;            /* [wires][lines] */
  double *squeeze[2];        /* [columns/8][half][8], transposed `along` of each class */
  double *spread[2];         /* [half/8][columns][8] */
  uint32_t first[5];         /* where each class begins in a grid vector, and its size */
  uint32_t size;
} TbBed;

static inline uint32_t tb_bed_class(const TbBed *bed, uint32_t along, uint32_t across) {
  return along * bed->quarters + across;
}

/* Doubles of scratch that the functions below need. */
static inline uint32_t tb_bed_scratch(const TbBed *bed) {
  return bed->lines * bed->lanes + 3u * bed->half + 8u;
}

/* C from forces f[wires * lanes]. Audio-safe, as is the next. */
void tb_bed_contract(const TbBed *bed, const TbKernels *kernels, const double *f, double *scratch,
                     double *grid);

/* w[wires * lanes] from c. */
void tb_bed_expand(const TbBed *bed, const TbKernels *kernels, const double *grid, double *scratch,
                   double *w);

#endif
