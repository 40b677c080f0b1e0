/* SPDX-License-Identifier: MIT */
/* Gauss-Legendre quadrature ([DLMF] 3.5(v)): panels of 16 points, and single rules of any size. */
#ifndef TB_QUADRATURE_H
#define TB_QUADRATURE_H

#include <stdint.h>

#define TB_PANEL 16u

/* Nodes and weights of `panels` equal panels on (from, to); both arrays hold panels * 16 values. */
void tb_quadrature(double from, double to, uint32_t panels, double *nodes, double *weights);

/* The rule of `count` points on (-1, 1), nodes ascending. */
void tb_gauss_rule(uint32_t count, double *nodes, double *weights);

#endif
