/* SPDX-License-Identifier: MIT */
#include "inspect/partials.h"

#include <math.h>
#include <stdlib.h>

#include "inspect/partial_tracker.h"

#define SHORTEST_WINDOW 0.02 /* [s], or up to 1.4 times as long */
#define WINDOWS 7            /* lengths, each twice the one before */
#define MOST_PEAKS 200       /* looked at in one spectrum */
#define NEAR 3.0             /* bins within which partials cannot be told apart */
#define LEAKY 16.0           /* bins within which what is weaker by */
#define LEAK 60.0            /* so much is not a partial of its own [dB] */
#define LOWEST 15.0          /* [Hz] */

/* What is accepted, round by round: first only partials that decay straight and need not be
   extrapolated far back to the onset, which noise would spoil; then those that need a longer window
   to be told from their neighbours; at last those that beat. The deviation of noise is 5.6 dB. */
static const struct Round {
  double deviation; /* of the levels from a straight line [dB] */
  double lag;       /* how far the partial has fallen when the window sees it [dB] */
} rounds[] = {{0.5, 12}, {1, 24}, {3, 30}};
#define ROUNDS (sizeof rounds / sizeof rounds[0])

#define ONSET_LEVEL 0.1  /* of the largest sample: the sound has begun */
#define ONSET_FLOOR 0.01 /* of the largest sample: before its first swing */

static double decibels(double factor) { return 20 * log10(factor); }

/* ---- onset ---- */

static double largest(const double *samples, size_t count) {
  double most = 0;
  for (size_t i = 0; i < count; i++) most = fmax(most, fabs(samples[i]));
  return most;
}

size_t find_onset(const double *samples, size_t count) {
  const double most = largest(samples, count);
  if (most == 0) return count;
  size_t onset = 0;
  while (fabs(samples[onset]) < ONSET_LEVEL * most) onset++;
  while (onset > 0 && fabs(samples[onset - 1]) > ONSET_FLOOR * most) onset--;
  return onset;
}

/* ---- windows ---- */

/* A power of two, as long at every rate as nearly as possible. */
static size_t shortest_window(double rate) {
  size_t length = 16;
  while ((double)length < SHORTEST_WINDOW * rate) length *= 2;
  return length;
}

size_t partials_least_samples(double rate) { return TRACKER_SAMPLES(shortest_window(rate)); }

/* ---- search ---- */

/* A search under way; frequencies in cycles per sample until the end. */
typedef struct Search {
  const PartialSearch *wanted;
  const double *samples;
  size_t count;
  Spectrum spectrum;
  PartialTracker tracker;
  Partials *found;
} Search;

/* Beside a found partial, too near to be told from it, or so weak that it is what leaks from it. */
static bool is_hidden(const Search *search, double frequency, double level) {
  const double bin = 1 / (double)search->spectrum.length;
  for (size_t i = 0; i < search->found->count; i++) {
    const Partial *const found = &search->found->list[i];
    const double distance = fabs(found->frequency - frequency);
    if (distance < NEAR * bin) return true;
    if (distance < LEAKY * bin && level < found->level - LEAK) return true;
  }
  return false;
}

/* A track that leads away from its peak is that of a neighbour. */
static bool is_sound(const Search *search, const Peak *peak, const PartialFit *fit,
                     const struct Round *round) {
  const double bin = 1 / (double)search->spectrum.length;
  return fit->deviation <= round->deviation && fit->lag <= round->lag &&
         fabs(fit->frequency - peak->frequency) < NEAR * bin &&
         !is_hidden(search, fit->frequency, decibels(fit->amplitude));
}

static void consider(Search *search, const Peak *peak, const struct Round *round) {
  Partials *const found = search->found;
  PartialFit fit;
  if (found->count == MOST_PARTIALS || is_hidden(search, peak->frequency, INFINITY)) return;
  if (peak->frequency * search->wanted->rate < LOWEST) return;
  if (!partial_tracker_fit(&search->tracker, search->samples, search->count, peak->frequency, &fit))
    return;
  if (!is_sound(search, peak, &fit, round)) return;
  found->list[found->count++] = (Partial){fit.frequency, decibels(fit.amplitude), fit.decay_rate};
}

/* All peaks through a window of @p length. */
static Outcome search_window(Search *search, size_t length, const struct Round *round) {
  Outcome outcome = spectrum_open(&search->spectrum, length);
  if (outcome == OUTCOME_OK) outcome = partial_tracker_open(&search->tracker, &search->spectrum);
  if (outcome == OUTCOME_OK) {
    Peak peaks[MOST_PEAKS];
    spectrum_compute(&search->spectrum, search->samples);
    const size_t count = spectrum_peaks(&search->spectrum, peaks, MOST_PEAKS);
    for (size_t i = 0; i < count; i++) consider(search, &peaks[i], round);
  }
  partial_tracker_free(&search->tracker);
  spectrum_free(&search->spectrum);
  return outcome;
}

static Outcome search_windows(Search *search, const struct Round *round) {
  const size_t shortest = shortest_window(search->wanted->rate);
  Outcome outcome = OUTCOME_OK;
  for (size_t length = shortest << (WINDOWS - 1); length >= shortest && outcome == OUTCOME_OK;
       length /= 2) {
    if (TRACKER_SAMPLES(length) <= search->count) outcome = search_window(search, length, round);
  }
  return outcome;
}

/* ---- the list ---- */

static int compare_partials(const void *left, const void *right) {
  const Partial *const a = left, *const b = right;
  return a->level > b->level ? -1 : a->level < b->level;
}

static void finish_list(const PartialSearch *wanted, Partials *partials) {
  qsort(partials->list, partials->count, sizeof partials->list[0], compare_partials);
  size_t count = 0;
  while (count < partials->count && count < wanted->most &&
         partials->list[count].level >= wanted->least_level) {
    partials->list[count].frequency *= wanted->rate;
    partials->list[count++].decay_rate *= wanted->rate;
  }
  partials->count = count;
}

Outcome partials_find(const PartialSearch *wanted, const double *samples, size_t count,
                      Partials *partials) {
  Search search = {.wanted = wanted, .samples = samples, .count = count, .found = partials};
  Outcome outcome = OUTCOME_OK;
  partials->count = 0;
  for (size_t i = 0; i < ROUNDS && outcome == OUTCOME_OK; i++) {
    outcome = search_windows(&search, &rounds[i]);
  }
  finish_list(wanted, partials);
  return outcome;
}
