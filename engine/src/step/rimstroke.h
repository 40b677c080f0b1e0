/* SPDX-License-Identifier: MIT */
/* Strokes on the hoop: placing the sticks of stick_rigid.h into slots. Audio-safe. */
#ifndef TB_RIMSTROKE_H
#define TB_RIMSTROKE_H

#include "step/striker_pool.h"

/* Places a rimshot, a cross-stick or a stroke on the rim; false if there is no room for it. */
bool tb_rimstroke(TbView *view, const TbStroke *stroke);

#endif
