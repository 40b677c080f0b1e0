/* SPDX-License-Identifier: MIT */
/* The high band in single precision. */
#define TB_FLOAT
#include "step/high_ring_tmpl.c"
