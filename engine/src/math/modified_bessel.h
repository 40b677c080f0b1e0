/* SPDX-License-Identifier: MIT */
/* Modified Bessel functions by backward recurrence, as in bessel.h ([DLMF] 3.6(iv), 10.74(iv)).
 *
 * I_{l-1}(x) = (2 l/x) I_l(x) + I_{l+1}(x) is stable downwards, and all of its terms are positive;
 * exp(x) = I_0 + 2 (I_1 + I_2 + ...) then scales the result. Only + - * /, sqrt and comparisons are
 * used: the same bits on every machine. Relative error below 1e-13 for orders to 256 and arguments
 * to 300, as long as the value is above 1e-250. */
#ifndef TB_MODIFIED_BESSEL_H
#define TB_MODIFIED_BESSEL_H

#include <stdint.h>

/* i[0] = exp(-x) I_m(x) and i[1] = exp(-x) I_{m+1}(x), x > 0. Set-up only. */
void tb_modified_bessel_pair(uint32_t m, double x, double i[2]);

#endif
