/* SPDX-License-Identifier: MIT */
#include "model/state_layout.h"

/* Doubles of TbSolveWork. */
static size_t work_doubles(const TaborModel *model) {
  return TB_WORK_ROWS * TB_STATE_ROWS + TB_WORK_GRIDS * TB_STATE_GRID +
         tb_wire_grid_scratch(&model->projection.wire_grid);
}

/* Floats of TbSolveWorkF, and of TbView.modalf; the grid's scratch is none where there is no such
 * grid. */
static size_t work_floats(const TaborModel *model) {
  static const size_t ROWS[] = {[TB_IN_DOUBLE] = 0, [TB_IN_FLOAT] = TB_WORKF_ROWS},
                      GRIDS[] = {[TB_IN_DOUBLE] = 0, [TB_IN_FLOAT] = TB_WORKF_GRIDS},
                      MODES[] = {[TB_IN_DOUBLE] = 0, [TB_IN_FLOAT] = 2};
  return ROWS[model->contacts] * TB_STATE_ROWS + GRIDS[model->contacts] * model->wire_gridf.size +
         MODES[model->contacts] * TB_STATE_MODES +
         tb_pad(tb_wire_grid_scratchf(&model->wire_gridf));
}

static size_t place(size_t *total, size_t count) {
  const size_t at = *total;
  *total += TB_ALIGNED(count * sizeof(double));
  return at;
}

#define PLACE(name, kind, most, copies, count)                                                     \
  for (uint32_t copy = 0; copy < (copies); copy++) layout->name[copy] = place(&total, (count));
#define PLACE_VIEWED(name, kind, most, copies, count, field) PLACE(name, kind, most, copies, count)

void tb_layout_prepare(TbLayout *layout, const TaborModel *model) {
  size_t total = 0;
  *layout = (TbLayout){.total = 0};
  TB_OTHER_ARRAYS(PLACE)
  TB_VIEWED_ARRAYS(PLACE_VIEWED)
  layout->total = total;
}

#define VISIT(name, kind, most, copies, count)                                                     \
  for (uint32_t copy = 0; copy < (copies); copy++) {                                               \
    const size_t from = model->layout.name[copy];                                                  \
    if (!visit(context, kind, from, from + (count) * sizeof(double))) return false;                \
  }
#define VISIT_VIEWED(name, kind, most, copies, count, field) VISIT(name, kind, most, copies, count)

bool tb_layout_visit(const TaborModel *model, TbVisitArray *visit, void *context) {
  TB_OTHER_ARRAYS(VISIT)
  TB_VIEWED_ARRAYS(VISIT_VIEWED)
  return true;
}
