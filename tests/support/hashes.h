/* SPDX-License-Identifier: MIT */
/* Hashes of what drums give: for sound_hashes and kit_hashes. */
#ifndef TABOR_TEST_HASHES_H
#define TABOR_TEST_HASHES_H

#include <stddef.h>
#include <stdint.h>

#include "tabor/tabor.h"

/* FNV-1a, 64 bits. */
typedef uint64_t Hash;

static const Hash HASH_START = 14695981039346656037u;

static inline Hash hash_bytes(Hash hash, const void *bytes, size_t size) {
  const unsigned char *p = bytes;
  for (size_t i = 0; i < size; i++) hash = (hash ^ p[i]) * 1099511628211u;
  return hash;
}

static inline Hash hash_number(Hash hash, double number) {
  return hash_bytes(hash, &number, sizeof number);
}

static inline Hash hash_count(Hash hash, uint64_t count) {
  return hash_bytes(hash, &count, sizeof count);
}

static inline Hash hash_ledger(Hash hash, const TaborDrum *drum) {
  TaborLedger l;
  tabor_drum_ledger(drum, &l);
  const double numbers[] = {l.injected,  l.control,      l.stored,      l.head_loss,
                            l.wire_loss, l.contact_loss, l.damper_loss, l.shell_loss,
                            l.radiated,  l.removed,      l.high_band,   l.residual};
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
    hash = hash_number(hash, numbers[i]);
  return hash;
}

static inline Hash hash_statistics(Hash hash, const TaborDrum *drum) {
  TaborStatistics s;
  tabor_drum_statistics(drum, &s);
  const uint64_t counts[] = {
    s.frames,         s.slept_frames, s.strikes,           s.late_events, s.misordered_events,
    s.dropped_events, s.solves,       s.newton_iterations, s.newton_max,  s.newton_capped,
    s.work_corrected, s.fallbacks,    s.guarded,           s.recovered,   s.contact_sum,
    s.contact_max,    s.in_play};
  for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) hash = hash_count(hash, counts[i]);
  return hash;
}

#endif
