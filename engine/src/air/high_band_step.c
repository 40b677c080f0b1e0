/* SPDX-License-Identifier: MIT */
/* The high band in double. */
#include "air/high_band_step_tmpl.c"
