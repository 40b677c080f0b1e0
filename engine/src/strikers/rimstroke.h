/* SPDX-License-Identifier: MIT */
/* Strokes on the hoop: places the sticks of stick.h into slots of the striker pool.
 * Audio-safe. */
#ifndef TB_RIMSTROKE_H
#define TB_RIMSTROKE_H

#include "strikers/striker_pool.h"

/* Places a rimshot, a cross-stick or a stroke on the rim. Returns false if no slot is free for
 * it. */
bool tb_rimstroke(TbView *view, const TbStroke *stroke);

#endif
