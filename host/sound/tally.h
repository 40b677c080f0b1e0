/* SPDX-License-Identifier: MIT */
/**
 * @file tally.h
 * What drums have counted, through silences, which reset a drum's own counters, and where another drum comes.
 * All zero is nothing yet. Real-time safe.
 */
#ifndef TABOR_HOST_TALLY_H
#define TABOR_HOST_TALLY_H

#include <tabor/tabor.h>

#include "base/realtime.h"

typedef struct Tally {
  TaborStatistics statistics; /**< in_play is 0 */
  TaborLedger ledger;         /**< nothing is stored: what was has gone as work of control */
} Tally;

/** Keeps what @p drum has counted, which is reset or leaves now. */
void tally_keep(Tally *tally, const TaborDrum *drum) REALTIME;
/** All that was kept, with what @p drum has counted since. */
void tally_statistics(const Tally *tally, const TaborDrum *drum,
                      TaborStatistics *statistics) REALTIME;
void tally_ledger(const Tally *tally, const TaborDrum *drum, TaborLedger *ledger) REALTIME;

#endif
