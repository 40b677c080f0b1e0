/* SPDX-License-Identifier: MIT */
/* The cost of building a model, from its sizes, before anything is built.
 *
 * Times are sums of the products that set-up computes, each with the time that one takes. The sizes
 * of eigenproblems follow from how many zeros Bessel functions have below a limit, sizes of the
 * grid under the wires from the head's shortest wave: L k/(2 pi) half waves along a length L.
 * Pitches are turned into tensions by a formula. The times per product were fitted to 430 random
 * definitions at live, and 30 builds of 0.1 to 360 s at all qualities, on one core of an AMD EPYC
 * of 2024. Set-up only. */
#ifndef TB_BUILD_ESTIMATE_H
#define TB_BUILD_ESTIMATE_H

#include "math/arena.h"

/* Processor time [s] of the stages of a build, and memory. */
typedef struct TbBuildCost {
  double tuning, heads, grid, contacts, high_band; /* as tabor_model_create() goes through them */
  double bytes;
} TbBuildCost;

double tb_build_seconds(const TbBuildCost *cost);
/* Cost of a valid definition, at a quality that is not the default. Pitches count with the search
 * for their tensions. */
TaborStatus tb_build_cost(const TaborDrumDef *def, uint32_t quality, double sample_rate,
                          const TaborAllocator *allocator, TbBuildCost *cost, TaborError *error);
/* Seconds, bytes and the parameter whose half saves most of the time. */
TaborStatus tb_build_estimate(const TaborDrumDef *def, uint32_t quality, double sample_rate,
                              const TaborAllocator *allocator, TaborModelEstimate *estimate,
                              TaborError *error);

#endif
