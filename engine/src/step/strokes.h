/* SPDX-License-Identifier: MIT */
/* What a player's hands do to the drum: a stroke begins here, whatever its technique, and so do pressing, damping
 * and letting go. What a striker does then is in striker_pool.h, brush.h and rimstroke.h. Audio-safe. */
#ifndef TB_STROKES_H
#define TB_STROKES_H

#include "step/striker_pool.h"

/* Places a stroke; false if there is no room among strikers in contact. */
bool tb_strike(TbView *view, const TbStroke *stroke);
/* Lays a hand of `strength` [N s/m] on the head, or moves the one with this id. */
bool tb_damp(TbView *view, uint32_t id, double strength, double radius, double angle);
/* Presses the strikers with this id, or all for 0, pressure 0 to 1; false if none is in play. */
bool tb_press(TbView *view, uint32_t id, double pressure);
/* Takes away strikers and hands with this id, or all for 0; mufflers stay. */
void tb_release(TbView *view, uint32_t id);

#endif
