/* SPDX-License-Identifier: MIT */
/* Places of bristle groups on a head. They lie on rings a hundredth of a head apart, so that mode
 * shapes at a place come from a table. A brush takes another place every few milliseconds, and
 * Bessel functions of a thousand modes would take most of its time. On a ring, the table's values
 * are those of tb_model_shape() and tb_model_high_drive(), to the bit. */
#ifndef TB_BRUSH_SHAPES_H
#define TB_BRUSH_SHAPES_H

#include "definition/params.h"

struct TaborModel;

#define TB_RINGS 128u

/* Tables of one brush; empty for other strikers. */
typedef struct TbBrushShapes {
  double apart;  /* distance of the rings, from radius 0 on [m] */
  double *rows;  /* [TB_RINGS][head.row_count]: radial shapes on the batter head */
  double *waves; /* [TB_RINGS][cosines]: drives of its high band */
} TbBrushShapes;

/* Prepares model->places for all brushes. Set-up only. */
TaborStatus tb_brush_shapes_prepare(struct TaborModel *model);

/* All below is audio-safe. */

/* Radius of the ring nearest to `radius` [m]. */
double tb_brush_shapes_ring(const struct TaborModel *model, uint32_t striker, double radius);
/* Computes shape[modes.padded] and drive[high.padded] on the ring of this radius. */
void tb_brush_shapes_shape(const struct TaborModel *model, uint32_t striker, double radius,
                           double angle, double *shape, double *drive);

#endif
