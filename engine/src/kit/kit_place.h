/* SPDX-License-Identifier: MIT */
/* The places of a kit's drums, and the kit as each of them sees it from there. Set-up only.
 *
 * A drum's own frame has its origin in the centre of the batter head, z along the axis, out of the
 * drum. The kit's frame becomes the drum's by a turn by `tilt` about the horizontal axis across
 * `facing`. */
#ifndef TB_KIT_PLACE_H
#define TB_KIT_PLACE_H

#include "tabor/kit.h"

/* Distance [m] at which a drum is heard for the others, large beside a drum: its pressure there is
 * that of its sound far away. */
#define TB_KIT_FAR 9.0

typedef struct TbPoint {
  double x, y, z;
} TbPoint;

TbPoint tb_kit_drum_place(const TaborKitDrumDef *drum);
double tb_kit_distance(TbPoint a, TbPoint b);
/* The overhead: 0 left, 1 right. */
TbPoint tb_kit_overhead(const TaborKitDef *def, int side);

#endif
