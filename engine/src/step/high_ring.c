/* SPDX-License-Identifier: MIT */
/* The high band in double. */
#include "step/high_ring_tmpl.c"
