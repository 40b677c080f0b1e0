/* SPDX-License-Identifier: MIT */
/* The contact solve in double. */
#include "step/contact_solve_tmpl.c"
