/* SPDX-License-Identifier: MIT */
/**
 * @file tally.h
 * Sums the counters of drums. A silence resets a drum's own counters, and a new drum starts its own at zero;
 * the tally keeps the counts from before. All members zero is an empty tally. Real-time safe.
 */
#ifndef TABOR_HOST_TALLY_H
#define TABOR_HOST_TALLY_H

#include <tabor/tabor.h>

#include "base/realtime.h"

typedef struct Tally {
  TaborStatistics statistics; /**< in_play is 0 */
  TaborLedger
    ledger; /**< stored energy is 0: energy that was stored is booked as work of control */
} Tally;

/** Adds the counters of @p drum; call before the drum is reset or leaves. */
void tally_keep(Tally *tally, const TaborDrum *drum) REALTIME;
/** The sum of the kept counters and the current ones of @p drum. */
void tally_statistics(const Tally *tally, const TaborDrum *drum,
                      TaborStatistics *statistics) REALTIME;
/** The same sum for the energy ledger. */
void tally_ledger(const Tally *tally, const TaborDrum *drum, TaborLedger *ledger) REALTIME;

#endif
