/* SPDX-License-Identifier: MIT */
#include "kit/kit_division.h"

#include <string.h>

/* Part of the time that passes, above which a second thread is used, and below which it is left. */
static const double BUSY = 0.25, IDLE = 0.2;
static const double GAIN = 0.95;  /* of the dearest part, for which drums change their part */
static const double SPARE = 1.05; /* of the dearest part, for which a thread is left out */

void kit_division_begin(KitDivision *division, uint32_t drums, uint32_t most) {
  memset(division, 0, sizeof *division);
  division->drums = drums;
  division->most = most < drums ? most : drums;
  division->parts = 1;
  division->part[0] = (1u << drums) - 1u;
}

static double cost_of(const KitDivision *division, uint32_t part) REALTIME;
static double cost_of(const KitDivision *division, uint32_t part) {
  double sum = 0;
  for (uint32_t i = 0; i < division->drums; i++) {
    if (part >> i & 1u) sum += division->cost[i];
  }
  return sum;
}

static double dearest(const KitDivision *division, const uint32_t *part, uint32_t parts) REALTIME;
static double dearest(const KitDivision *division, const uint32_t *part, uint32_t parts) {
  double most = 0;
  for (uint32_t i = 0; i < parts; i++) {
    const double cost = cost_of(division, part[i]);
    if (cost > most) most = cost;
  }
  return most;
}

static uint32_t dearest_drum(const KitDivision *division, uint32_t left) REALTIME;
static uint32_t dearest_drum(const KitDivision *division, uint32_t left) {
  uint32_t found = division->drums;
  for (uint32_t i = 0; i < division->drums; i++) {
    if (!(left >> i & 1u)) continue;
    if (found == division->drums || division->cost[i] > division->cost[found]) found = i;
  }
  return found;
}

static void divide(const KitDivision *division, uint32_t *part, uint32_t parts) REALTIME;
static void divide(const KitDivision *division, uint32_t *part, uint32_t parts) {
  double sum[TABOR_KIT_DRUMS] = {0};
  uint32_t left = (1u << division->drums) - 1u;
  memset(part, 0, TABOR_KIT_DRUMS * sizeof *part);
  while (left != 0) {
    const uint32_t drum = dearest_drum(division, left);
    uint32_t to = 0;
    for (uint32_t i = 1; i < parts; i++) {
      if (sum[i] < sum[to]) to = i;
    }
    part[to] |= 1u << drum;
    sum[to] += division->cost[drum];
    left &= ~(1u << drum);
  }
}

/* No more parts than make the dearest one cheaper. */
static void divide_between(KitDivision *division, uint32_t most) REALTIME;
static void divide_between(KitDivision *division, uint32_t most) {
  uint32_t part[TABOR_KIT_DRUMS], parts = 0;
  divide(division, part, most);
  const double least = dearest(division, part, most);
  do {
    divide(division, part, ++parts);
  } while (dearest(division, part, parts) > SPARE * least);
  const double before = dearest(division, division->part, division->parts);
  if (parts == division->parts && dearest(division, part, parts) > GAIN * before) return;
  memcpy(division->part, part, sizeof part);
  division->parts = parts;
}

void kit_division_renew(KitDivision *division, double now) {
  const double passed = now - division->begun;
  double spent = 0;
  for (uint32_t i = 0; i < division->drums; i++) {
    spent += division->seconds[i];
    division->cost[i] = 0.5 * (division->cost[i] + division->seconds[i]);
    division->seconds[i] = 0;
  }
  const bool is_first = division->begun == 0;
  const double enough = division->parts > 1 ? IDLE : BUSY;
  division->begun = now;
  if (!is_first) divide_between(division, spent < enough * passed ? 1 : division->most);
}
