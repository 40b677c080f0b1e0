/* SPDX-License-Identifier: MIT */
/* The bed (bed.h) and the head's compliance under it (compliance.h) in single precision, for singlesolve.h.
 *
 * The same shapes, w(lane j, wire v) = Sum_l across[v][l] Sum_a along[j][a] c[l][a], but the classes of symmetry
 * along stand side by side and each shape covers all lanes, so that nothing has to be folded. Forces go back
 * through the same numbers: `contract` reads them as [lane][column], `expand` as [column][lane]. */
#ifndef TB_SINGLE_BED_H
#define TB_SINGLE_BED_H

#include "model/compliance.h"

typedef struct TbSingleBed {
  uint32_t wires, lanes, quarters, lines, even_lines; /* as in TbBed */
  uint32_t columns, padded;                           /* of all classes along, and up to 8 more */
  uint32_t size;                                      /* of a grid vector */
  float *across;                                      /* [wires][lines] */
  float *contract;                                    /* [lanes][padded] */
  float *expand;                                      /* [columns][lanes] */
  uint32_t *place;                                    /* [lines][columns]: where in a grid vector */
  uint32_t classes;                                   /* of the compliance, */
  uint32_t first[5];                                  /* where each begins in a grid vector, */
  const float *matrix[4];                             /* and its matrix, [points/8][points][8] */
} TbSingleBed;

/* Floats of scratch that contracting and expanding need. */
static inline uint32_t tb_single_bed_scratch(const TbSingleBed *bed) {
  return bed->lines * (bed->lanes + bed->padded);
}

/* Rounds the bed's own shapes to single precision, so that both precisions mean the same grid, and copies it. */
bool tb_single_bed_prepare(TbSingleBed *single, TbArena *arena, TbBed *bed,
                           const TbCompliance *compliance);

#endif
