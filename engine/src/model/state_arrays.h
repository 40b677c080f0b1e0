/* SPDX-License-Identifier: MIT */
/* The arrays of a drum's state (state/state.h), a line each:
 *   name in TbLayout; kind of its numbers; how many such arrays there may be and are; numbers in
 *   each; where TbView has it.
 * Layout, view, reset and check of saved states follow these lists. `model` is the model, `copy`
 * counts the arrays of a line. Kinds (TbArrayKind): doubles; floats; numbers in the high band's
 * precision, in the room of doubles; scratch, which is filled before it is read. */
#ifndef TB_STATE_ARRAYS_H
#define TB_STATE_ARRAYS_H

typedef enum TbArrayKind { TB_DOUBLES, TB_FLOATS, TB_HIGH_REALS, TB_SCRATCH } TbArrayKind;

/* Contacts (a row is one), points of the grid, modes. */
#define TB_STATE_ROWS (tb_row_count(&model->rows))
#define TB_STATE_GRID (model->projection.wire_grid.size)
#define TB_STATE_MODES (model->modes.padded)
/* Floats, two in the room of a double: fields, displacements and gradient. */
#define TB_STATE_PLATE                                                                             \
  ((tb_von_karman_scratch(&model->plate.tables) + 2u * tb_pad(2u * model->plate.tables.pairs)) / 2u)

/* Arrays that the view has elsewhere: instants (TbPhase), and workspaces of the solve, which have
 * no name here. */
#define TB_OTHER_ARRAYS(ARRAY)                                                                     \
  ARRAY(q, TB_DOUBLES, 3, 3, TB_STATE_MODES)                                                       \
  ARRAY(v, TB_DOUBLES, 3, 3, model->wires.node_count)                                              \
  ARRAY(eta, TB_DOUBLES, 3, 3, TB_STATE_ROWS)                                                      \
  ARRAY(high, TB_HIGH_REALS, 3, 3, model->high.padded)                                             \
  ARRAY(work, TB_SCRATCH, 1, 1, work_doubles(model))                                               \
  ARRAY(workf, TB_SCRATCH, 1, 1, work_floats(model) / 2u)

#define TB_VIEWED_ARRAYS(ARRAY)                                                                    \
  ARRAY(bend, TB_DOUBLES, 1, 1, model->wires.node_count, bend)                                     \
  ARRAY(head, TB_DOUBLES, 1, 1, TB_STATE_ROWS, head)                                               \
  ARRAY(rest_load, TB_DOUBLES, 1, 1, TB_STATE_ROWS, rest_load)                                     \
  ARRAY(contact_compliance, TB_DOUBLES, 1, 1, TB_STATE_ROWS, contact_compliance)                   \
  ARRAY(b, TB_DOUBLES, 1, 1, TB_STATE_ROWS, b)                                                     \
  ARRAY(s, TB_DOUBLES, 1, 1, TB_STATE_ROWS, s)                                                     \
  ARRAY(force, TB_DOUBLES, 1, 1, TB_STATE_ROWS, solve.warm.force)                                  \
  ARRAY(product, TB_DOUBLES, 1, 1, TB_STATE_ROWS, solve.warm.product)                              \
  ARRAY(grid, TB_DOUBLES, 1, 1, TB_STATE_GRID, solve.warm.grid)                                    \
  ARRAY(change, TB_DOUBLES, 1, 1, TB_STATE_GRID, change)                                           \
  ARRAY(modal, TB_DOUBLES, 1, 1, TB_STATE_MODES, modal)                                            \
  ARRAY(high_drive, TB_HIGH_REALS, 1, 1, (size_t)TB_SLOTS * model->high.padded, high.drive)        \
  ARRAY(high_scratch, TB_SCRATCH, 1, 1, model->high.padded, high.scratch)                          \
  ARRAY(high_force, TB_FLOATS, 1, 1, model->high.padded / 2u, high.force)                          \
  ARRAY(high_steady, TB_FLOATS, 1, 1, model->high.padded / 2u, high.steady)                        \
  ARRAY(high_turn, TB_HIGH_REALS, 1, 1, model->high.padded, high.turn)                             \
  ARRAY(high_taken, TB_HIGH_REALS, 1, 1, model->high.padded, high.taken)                           \
  ARRAY(stretch_pull, TB_DOUBLES, TB_COUPLINGS, model->stretch.count, TB_STATE_MODES,              \
        stretch.pull[copy])                                                                        \
  ARRAY(stretch_mixed, TB_DOUBLES, TB_COUPLINGS, model->stretch.count, TB_STATE_MODES,             \
        stretch.mixed[copy])                                                                       \
  ARRAY(plate_scratch, TB_SCRATCH, 1, 1, TB_STATE_PLATE, stretch.scratch)                          \
  ARRAY(stretch_grid, TB_DOUBLES, TB_COUPLINGS, model->stretch.count, TB_STATE_GRID,               \
        solve.in.stretch_grid[copy])                                                               \
  ARRAY(stretch_carry, TB_DOUBLES, 1, 1, TB_STATE_GRID + TB_SLOTS, stretch.carry)                  \
  ARRAY(coupling, TB_DOUBLES, 1, 1, (size_t)TB_SLOTS *TB_STATE_GRID, strikers.coupling)            \
  ARRAY(slot_coupling, TB_DOUBLES, 1, 1, (size_t)TB_SLOTS *TB_SLOTS, strikers.slot_coupling)       \
  ARRAY(shape, TB_DOUBLES, 1, 1, (size_t)TB_SLOTS *TB_STATE_MODES, strikers.shape)                 \
  ARRAY(drive, TB_DOUBLES, 1, 1, (size_t)TB_SLOTS *TB_STATE_MODES, strikers.drive)                 \
  ARRAY(radial, TB_DOUBLES, 1, 1, model->body.row_count, strikers.radial)                          \
  ARRAY(delay, TB_DOUBLES, TABOR_MAX_MICS, model->def.mic_count, model->mics[copy].delay + 1u,     \
        mics.delay[copy])

#endif
