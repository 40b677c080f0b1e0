/* SPDX-License-Identifier: MIT */
/* The text of TbBed and TbBedF, TbCompliance and TbComplianceF: see bed.h and both.h. */

typedef struct TB_TYPE(TbCompliance) {
  uint32_t classes;
  uint32_t first[5];        /* of each class in a grid vector, as in TbBed */
  const TB_REAL *matrix[4]; /* [points/8][points][8] */
} TB_TYPE(TbCompliance);

typedef struct TB_TYPE(TbBed) {
  uint32_t wires, lanes;
  uint32_t quarters;      /* symmetry, as in TbModes */
  uint32_t lines;         /* shapes across */
  uint32_t first_line[3]; /* lines of each class across */
  uint32_t size;          /* of a grid vector */
  TB_REAL *across;        /* [wires][lines] */
#if TB_REAL_IS_FLOAT
  uint32_t columns, padded; /* of all classes along, and up to 8 more */
  float *contract;          /* [lanes][padded] */
  float *expand;            /* [columns][lanes] */
  uint32_t *place;          /* [lines][columns]: where in a grid vector */
#else
  uint32_t middle;
  uint32_t halves;     /* symmetry, as in TbModes */
  uint32_t half;       /* folded lanes, padded; all lanes without symmetry */
  uint32_t columns[2]; /* points per line of each class along */
  bool thinned;        /* `squeeze` and `spread` are used */
  double *squeeze[2];  /* [columns/8][half][8], transposed `along` of each class */
  double *spread[2];   /* [half/8][columns][8] */
  uint32_t first[5];   /* where each class begins in a grid vector, and its size */
#endif
} TB_TYPE(TbBed);

/* Numbers of scratch that contracting and expanding need. */
static inline uint32_t TB_NAME(tb_bed_scratch)(const TB_TYPE(TbBed) * bed) {
#if TB_REAL_IS_FLOAT
  return bed->lines * (bed->lanes + bed->padded);
#else
  return bed->lines * bed->lanes + 3u * bed->half + 8u;
#endif
}
