/* SPDX-License-Identifier: MIT */
/* Lists all arrays of a model. Set-up only. */
#ifndef TB_MODEL_ARRAYS_H
#define TB_MODEL_ARRAYS_H

#include "model/model.h"
#include "saved_model/transfer.h"

/* `model` is the transfer's record. Writing leaves it as it is. */
void tb_model_arrays(TbTransfer *transfer, TaborModel *model);

#endif
