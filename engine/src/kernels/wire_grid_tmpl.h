/* SPDX-License-Identifier: MIT */
/* Defines TbWireGrid and TbWireGridF, TbCompliance and TbComplianceF: see wire_grid.h and
 * both.h. */

typedef struct TB_TYPE(TbCompliance) {
  uint32_t classes;
  uint32_t first[5];        /* start of each class, as in TbWireGrid */
  const TB_REAL *matrix[4]; /* [points/8][points][8] */
} TB_TYPE(TbCompliance);

typedef struct TB_TYPE(TbWireGrid) {
  uint32_t wires, lanes;
  uint32_t halves, quarters; /* symmetries in use, as in TbModes */
  uint32_t middle, half;     /* folded lanes, padded; all lanes without folding */
  uint32_t lines;            /* shapes across */
  uint32_t first_line[3];    /* lines of each class across */
  TB_REAL *across;           /* [wires][lines] */
  bool thinned; /* `rows_to_grid` and `grid_to_rows` are used; otherwise each lane is a column */
  uint32_t columns[2];  /* points per line of each class along */
  uint32_t padded[2];   /* the same, padded to a multiple of 8 */
  TB_REAL *contract[2]; /* [half][padded]: `along` of each class */
  TB_REAL *expand[2];   /* [columns][half]: its transpose */
  uint32_t *place[2];   /* [lines][columns]: index in a grid vector */
  uint32_t size;        /* of a grid vector */
  uint32_t first[5];    /* start of each class in a grid vector */
} TB_TYPE(TbWireGrid);

/* Length of the scratch array of `rows_to_grid` and `grid_to_rows`. */
static inline uint32_t TB_NAME(tb_wire_grid_scratch)(const TB_TYPE(TbWireGrid) * wire_grid) {
  const uint32_t padded =
    wire_grid->padded[0] > wire_grid->padded[1] ? wire_grid->padded[0] : wire_grid->padded[1];
  return TB_WIRE_GRID_SLACK + wire_grid->lines * (wire_grid->lanes + 2u * wire_grid->half + padded);
}
