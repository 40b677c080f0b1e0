/* SPDX-License-Identifier: MIT */
/* Where the arrays of a drum's state lie (step/state.h): their sizes depend on the model alone. */
#ifndef TB_STATE_LAYOUT_H
#define TB_STATE_LAYOUT_H

#include "model/model.h"

/* How many arrays by rows and by points of the grid TbSingle has. */
enum { TB_SINGLE_ROWS = 19, TB_SINGLE_GRIDS = 6 };

void tb_layout_prepare(TbLayout *layout, const TaborModel *model);

#endif
