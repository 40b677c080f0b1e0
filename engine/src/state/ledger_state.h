/* SPDX-License-Identifier: MIT */
/* The energy account's part of a drum's state (step/energy.h). */
#ifndef TB_LEDGER_STATE_H
#define TB_LEDGER_STATE_H

#include "tabor/tabor.h"

typedef struct TbLedgerState {
  TaborLedger sums; /* stored and residual are not kept */
  TaborStatistics statistics;
  double sound_work;      /* that sound from outside has done since the last reset [J] */
  double radiated_beyond; /* part of sums.radiated that the modes did not lose to the air
                             (radiated_power.h) [J] */
} TbLedgerState;

#endif
