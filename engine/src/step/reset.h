/* SPDX-License-Identifier: MIT */
#ifndef TB_RESET_H
#define TB_RESET_H

#include "state/state.h"

/* Puts `state` (tb_state_bytes() large) to rest; statistics and ledger restart. Audio-safe. */
void tb_step_reset(TbState *state, const TaborModel *model);

#endif
