/* SPDX-License-Identifier: MIT */
/* Bands of a plate's modes above those that large deflections couple: see heads/cascade.h. */
#ifndef TB_CASCADE_H
#define TB_CASCADE_H

#include <stdint.h>

#include "tabor/tabor.h"

enum { TB_CASCADE_BANDS = 24 };

typedef struct TbCascade {
  uint32_t bands; /* 0: there is no cascade */
  uint32_t
    first[TB_CASCADE_BANDS + 1]; /* modes of band b: mode[first[b]] .. mode[first[b + 1]-1] */
  uint32_t *mode;                /* the first band is the highest of the coupled ones */
  uint32_t low_count, *low;      /* large waves, at whose energy the rest is scattered */
  double rate[TB_CASCADE_BANDS]; /* kappa of the edge above each band [J^-0.9/s] */
} TbCascade;

/* Fills model->cascade, after model->plate. Set-up only. */
TaborStatus tb_cascade_prepare(TaborModel *model);

#endif
