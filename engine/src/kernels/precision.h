/* SPDX-License-Identifier: MIT */
/* Which of two precisions something is computed in. A model chooses when it is built; what depends on it comes from
 * tables that have this as their index. */
#ifndef TB_PRECISION_H
#define TB_PRECISION_H

typedef enum TbPrecision { TB_IN_DOUBLE, TB_IN_FLOAT } TbPrecision;

#endif
