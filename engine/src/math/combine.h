/* SPDX-License-Identifier: MIT */
/* The inner loop of Cholesky's factor and of the eigensolver. */
#ifndef TB_COMBINE_H
#define TB_COMBINE_H

#include <stdint.h>

/* out[k] += sign * (sum over j of factors[j] rows[j * stride + k]), k < length, j < count. For each
 * k, the sum runs in the order of j, so the width of the machine's registers makes no difference.
 * `out` may overlap neither `factors` nor the rows. */
void tb_combine_rows(uint32_t length, uint32_t count, const double *factors, const double *rows,
                     uint32_t stride, double sign, double *out);

#endif
