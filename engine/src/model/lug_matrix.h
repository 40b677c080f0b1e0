/* SPDX-License-Identifier: MIT */
/* Coupling of the even heads' modes by uneven tension. Set-up only. */
#ifndef TB_LUG_MATRIX_H
#define TB_LUG_MATRIX_H

#include "model/model.h"

/* True if some head's lugs pull unevenly. */
bool tb_lugs_uneven(const TbBody *body);

/* dK_ab = Sum over heads of Int grad a . (N - T) grad b dA [1/s2] between the modes mode[count],
 * which are indices in model->modes. matrix[count][count] must be zero on entry. Returns false if
 * memory ran out. */
bool tb_lug_matrix(const TaborModel *model, TbArena *scratch, const uint32_t *mode, uint32_t count,
                   double *matrix);

#endif
