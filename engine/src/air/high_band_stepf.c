/* SPDX-License-Identifier: MIT */
/* The high band in single precision. */
#define TB_FLOAT
#include "air/high_band_step_tmpl.c"
