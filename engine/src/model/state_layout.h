/* SPDX-License-Identifier: MIT */
/* Layout of the arrays of a drum's state (state_arrays.h). Their sizes depend on the model alone.
 */
#ifndef TB_STATE_LAYOUT_H
#define TB_STATE_LAYOUT_H

#include "model/model.h"

/* Number of arrays by rows (a row is one contact) and by grid points that TbSolveWork and
 * TbSolveWorkF have beside the drum's own. */
enum { TB_WORK_ROWS = 11, TB_WORK_GRIDS = 3, TB_WORKF_ROWS = 20, TB_WORKF_GRIDS = 6 };

void tb_layout_prepare(TbLayout *layout, const TaborModel *model);

/* Calls `visit` with the kind of each array, where it begins and where it ends, in bytes from the
 * first array. Stops when that returns false, and returns false then. */
typedef bool TbVisitArray(void *context, TbArrayKind kind, size_t from, size_t end);
bool tb_layout_visit(const TaborModel *model, TbVisitArray *visit, void *context);

#endif
