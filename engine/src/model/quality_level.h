/* SPDX-License-Identifier: MIT */
/* The accuracy of a quality level: bandwidths, numbers of modes and contact points, accuracy.
 * Set-up only. */
#ifndef TB_QUALITY_LEVEL_H
#define TB_QUALITY_LEVEL_H

#include "bodies/body.h"
#include "kernels/precision.h"

/* Modes that a model may have at any quality; those with more solve their contacts less exactly,
 * see model.c. */
#define TB_FEW_MODES 4096u

typedef struct TbLevel {
  double bandwidth, top; /* two-way, and with the high band [Hz] */
  uint32_t newton_cap, inner_cap, wire_cells;
  double tolerance, inner_tolerance; /* of the contact solve */
  double grid_tolerance;             /* of the grid under the wires */
  TbPrecision precision, tables;     /* of contacts and high band; between modes and that grid */
} TbLevel;

/* Steps per sample: 1 or 2. */
uint32_t tb_level_steps(uint32_t quality, double sample_rate);
/* The level `quality`, with what the definition says otherwise. */
TbLevel tb_level(const TaborDrumDef *def, uint32_t quality, double sample_rate);
/* Limits of the heads' modes; `points` is the number of contact points of all wires, `rate` that of
 * steps. */
TbBodyLimits tb_level_limits(uint32_t quality, uint32_t points, double rate);

#endif
