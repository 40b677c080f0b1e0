/* SPDX-License-Identifier: MIT */
/* The text of TbWireGrid and TbWireGridF, TbCompliance and TbComplianceF: see wire_grid.h and both.h. */

typedef struct TB_TYPE(TbCompliance) {
  uint32_t classes;
  uint32_t first[5];        /* of each class in a grid vector, as in TbWireGrid */
  const TB_REAL *matrix[4]; /* [points/8][points][8] */
} TB_TYPE(TbCompliance);

typedef struct TB_TYPE(TbWireGrid) {
  uint32_t wires, lanes;
  uint32_t halves, quarters; /* symmetries that are made use of, as in TbModes */
  uint32_t middle, half;     /* folded lanes, padded; all lanes where nothing is folded */
  uint32_t lines;            /* shapes across */
  uint32_t first_line[3];    /* lines of each class across */
  TB_REAL *across;           /* [wires][lines] */
  bool thinned;              /* `contract` and `expand` are used; else each lane is a column */
  uint32_t columns[2];       /* points per line of each class along, */
  uint32_t padded[2];        /* ... and up to 8 more */
  TB_REAL *contract[2];      /* [half][padded], `along` of each class, */
  TB_REAL *expand[2];        /* [columns][half], and transposed */
  uint32_t *place[2];        /* [lines][columns]: where in a grid vector */
  uint32_t size;             /* of a grid vector, */
  uint32_t first[5];         /* and where its classes begin */
} TB_TYPE(TbWireGrid);

/* Numbers of scratch that contracting and expanding need. */
static inline uint32_t TB_NAME(tb_wire_grid_scratch)(const TB_TYPE(TbWireGrid) * wire_grid) {
  const uint32_t padded =
    wire_grid->padded[0] > wire_grid->padded[1] ? wire_grid->padded[0] : wire_grid->padded[1];
  return wire_grid->lines * (wire_grid->lanes + 2u * wire_grid->half + padded);
}
