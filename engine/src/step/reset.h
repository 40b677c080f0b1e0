/* SPDX-License-Identifier: MIT */
/* A drum at rest. Audio-safe. */
#ifndef TB_RESET_H
#define TB_RESET_H

#include "step/state.h"

/* Puts `state` (tb_state_bytes() large) to rest; statistics and ledger restart. */
void tb_state_reset(TbState *state, const TaborModel *model);

#endif
