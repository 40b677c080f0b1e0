/* SPDX-License-Identifier: MIT */
/* The player's hands: a stroke of any technique begins here, and so do pressing, damping and
 * releasing. striker_pool.h, brush.h and rimstroke.h describe the striker's motion from then on.
 * Audio-safe. */
#ifndef TB_STROKES_H
#define TB_STROKES_H

#include "strikers/striker_pool.h"

/* Places a stroke. Returns false if all strikers are in contact and none can be replaced. */
bool tb_strike(TbView *view, const TbStroke *stroke);
/* Lays a hand of `strength` [N s/m] on the head, or moves the hand with this id. */
bool tb_damp(TbView *view, uint32_t id, double strength, double radius, double angle);
/* Presses the strikers with this id (0: all), pressure 0 to 1. Returns false if none is in play. */
bool tb_press(TbView *view, uint32_t id, double pressure);
/* Removes strikers and hands with this id (0: all); mufflers stay. */
void tb_release(TbView *view, uint32_t id);

#endif
