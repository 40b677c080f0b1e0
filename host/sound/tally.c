/* SPDX-License-Identifier: MIT */
#include "sound/tally.h"

static uint32_t larger(uint32_t a, uint32_t b) { return a > b ? a : b; }

void tally_statistics(const Tally *tally, const TaborDrum *drum, TaborStatistics *statistics) {
  const TaborStatistics *const kept = &tally->statistics;
  tabor_drum_statistics(drum, statistics);
  statistics->frames += kept->frames;
  statistics->slept_frames += kept->slept_frames;
  statistics->strikes += kept->strikes;
  statistics->late_events += kept->late_events;
  statistics->misordered_events += kept->misordered_events;
  statistics->dropped_events += kept->dropped_events;
  statistics->solves += kept->solves;
  statistics->newton_iterations += kept->newton_iterations;
  statistics->newton_max = larger(statistics->newton_max, kept->newton_max);
  statistics->newton_capped += kept->newton_capped;
  statistics->work_corrected += kept->work_corrected;
  statistics->fallbacks += kept->fallbacks;
  statistics->guarded += kept->guarded;
  statistics->recovered += kept->recovered;
  statistics->contact_sum += kept->contact_sum;
  statistics->contact_max = larger(statistics->contact_max, kept->contact_max);
}

void tally_ledger(const Tally *tally, const TaborDrum *drum, TaborLedger *ledger) {
  const TaborLedger *const kept = &tally->ledger;
  tabor_drum_ledger(drum, ledger);
  ledger->injected += kept->injected;
  ledger->control += kept->control;
  ledger->head_loss += kept->head_loss;
  ledger->wire_loss += kept->wire_loss;
  ledger->contact_loss += kept->contact_loss;
  ledger->damper_loss += kept->damper_loss;
  ledger->shell_loss += kept->shell_loss;
  ledger->radiated += kept->radiated;
  ledger->removed += kept->removed;
  ledger->residual += kept->residual;
}

void tally_keep(Tally *tally, const TaborDrum *drum) {
  Tally sum;
  tally_statistics(tally, drum, &sum.statistics);
  tally_ledger(tally, drum, &sum.ledger);
  sum.statistics.in_play = 0;
  sum.ledger.control -= sum.ledger.stored;
  sum.ledger.stored = sum.ledger.high_band = 0;
  *tally = sum;
}
