/* SPDX-License-Identifier: MIT */
/* The high band in double. */
#include "step/high_band_step_tmpl.c"
