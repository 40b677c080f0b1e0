/* SPDX-License-Identifier: MIT */
/* The kernels in double. */
#define TB_TABLE TB_KERNELS
#include "kernels/kernels_tmpl.c"
