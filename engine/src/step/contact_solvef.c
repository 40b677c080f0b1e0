/* SPDX-License-Identifier: MIT */
/* The contact solve in single precision. */
#define TB_FLOAT
#include "step/contact_solve_tmpl.c"
