/* SPDX-License-Identifier: MIT */
/* The precision of a computation. A model chooses a precision when it is built; code that depends
 * on the precision is selected from tables indexed by TbPrecision. */
#ifndef TB_PRECISION_H
#define TB_PRECISION_H

typedef enum TbPrecision { TB_IN_DOUBLE, TB_IN_FLOAT } TbPrecision;

#endif
