/* SPDX-License-Identifier: MIT */
/* The profile of a plate along a radius: its thickness, and how far it rises at rest.
 *
 *   h(r) = h_0 (1 + (t - 1) r/R)                          t: taper
 *   w0(r) = b (1 - r^2/R^2)                               bow
 *         + H (1 - r^2/a^2)^2           for r < a         bell
 *         + S L (u^3 - u^4/2)           for r > R - L     flange; u = (r - (R - L))/L
 * upward; its slope and its curvature count. The bell meets the bow without a step of its slope,
 * and so does the flange, whose slope grows to S at the edge. Set-up only. */
#ifndef TB_PLATE_PROFILE_H
#define TB_PLATE_PROFILE_H

#include <stdbool.h>

#include "tabor/tabor.h"

typedef struct TbPlateProfile {
  double thickness; /* h [m] */
  double slope;     /* dw0/dr */
  double curvature; /* d2w0/dr2 [1/m] */
} TbPlateProfile;

/* At the distance r from the middle, 0 <= r <= radius. */
TbPlateProfile tb_plate_profile(const TaborPlateDef *plate, double radius, double r);

/* Nothing rises at rest. */
bool tb_plate_is_flat(const TaborPlateDef *plate);

#endif
