/* SPDX-License-Identifier: MIT */
/* Each contact has a row. Rows stand in sets, one set for each kind of pair that touches: the
 * points of wires on a head, then the slots. A slot is a place in the striker pool for a striker,
 * hand or muffler. Each set's places, laws and compliance belong to the module that fills it:
 * model/wires.h, strikers/striker_pool.h. */
#ifndef TB_CONTACT_ROWS_H
#define TB_CONTACT_ROWS_H

#include <stdint.h>

/* Slots: strikers and hands, then a muffler for each head; a multiple of 8. */
#define TB_SLOTS 16u

/* Penetration of an unused row [m]. An unused row never touches, so loops may run over it. */
#define TB_NOTHING (-1e3)

typedef enum TbRowSet { TB_ROWS_OF_WIRES, TB_ROWS_OF_SLOTS, TB_ROW_SETS } TbRowSet;

/* Rows begin[set] to begin[set + 1] - 1 are those of a set; multiples of 8. */
typedef struct TbRows {
  uint32_t begin[TB_ROW_SETS + 1];
} TbRows;

/* `wire_rows`: TbWires.stride. */
static inline TbRows tb_rows(uint32_t wire_rows) {
  return (TbRows){{[TB_ROWS_OF_SLOTS] = wire_rows, [TB_ROW_SETS] = wire_rows + TB_SLOTS}};
}

static inline uint32_t tb_row_count(const TbRows *rows) { return rows->begin[TB_ROW_SETS]; }

/* Rows of the wires, which come first. */
static inline uint32_t tb_wire_rows(const TbRows *rows) { return rows->begin[TB_ROWS_OF_SLOTS]; }

static inline uint32_t tb_slot_row(const TbRows *rows, uint32_t slot) {
  return rows->begin[TB_ROWS_OF_SLOTS] + slot;
}

#endif
