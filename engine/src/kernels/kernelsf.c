/* SPDX-License-Identifier: MIT */
/* The kernels in single precision. */
#define TB_FLOAT
#define TB_TABLE TB_KERNELS_F
#include "kernels/kernels_tmpl.c"
