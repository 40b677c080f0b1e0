/* SPDX-License-Identifier: MIT */
/**
 * @file drum_script.h
 * A performance for the system tests: a list of events at absolute frames, played on a drum in
 * blocks of any size. Uses only the public interface.
 */
#ifndef TEST_DRUM_SCRIPT_H
#define TEST_DRUM_SCRIPT_H

#include "tabor/tabor.h"

enum { SCRIPT_MAX_EVENTS = 32, SCRIPT_FRAMES = 4800 };

/** Events in order of time; frames count from the start of the performance. */
typedef struct Script {
  TaborEvent events[SCRIPT_MAX_EVENTS];
  uint32_t count;
} Script;

/** Result of a performance: the samples of every microphone, and the final ledger and statistics.
 */
typedef struct Take {
  float *samples; /**< [mic][frame] */
  uint32_t mics, frames;
  TaborLedger ledger;
  TaborStatistics statistics;
} Take;

/** Chooses the size of the next block; @p context is passed through. */
typedef uint32_t BlockSize(void *context);

/** A model of built-in preset @p preset at 48 kHz; fails the test on an error. */
TaborModel *script_model(const char *preset, TaborQuality quality, TaborInstructions instructions);
/** A model of a definition at 48 kHz; fails the test on an error. */
TaborModel *script_model_of(const TaborDrumDef *def, TaborQuality quality,
                            TaborInstructions instructions);
/** Leaves the drum few modes: it is built and played in a moment, whatever its quality. */
void script_narrow(TaborDrumDef *def);
/** The model of a preset that script_narrow() has changed. */
TaborModel *script_narrow_model(const char *preset, TaborQuality quality,
                                TaborInstructions instructions);
/** A drum of @p model; fails the test on an error. */
TaborDrum *script_drum(TaborModel *model);

/** A stroke of the definition's first striker; angle in degrees. */
TaborEvent script_strike(uint32_t frame, double velocity, double radius, double angle);
/** A change of live parameter @p key, which must exist. */
TaborEvent script_parameter(uint32_t frame, const char *key, double value);
void script_add(Script *script, TaborEvent event);
/**
 * Covers every kind of event: strokes at odd frames and two at once, moving live parameters while
 * the drum rings, a damping hand that comes and goes, removed strikers.
 */
void script_everything(Script *script);

/** Plays frames @p from to @p to of @p script in blocks of @p size(@p context). */
void script_play(TaborDrum *drum, const Script *script, uint32_t from, uint32_t to, BlockSize *size,
                 void *context, Take *take);
/** Plays the whole script on @p drum in blocks of 64. */
void script_play_all(TaborDrum *drum, const Script *script, Take *take);

/** Allocates a take of @p frames frames for all microphones of @p model. */
Take take_create(const TaborModel *model, uint32_t frames);
void take_destroy(Take *take);
/** Largest absolute sample, over all microphones. */
double take_peak(const Take *take);
/** Fails the test, naming @p what and the first differing sample, unless both hold the same bits.
 */
void take_assert_same(const Take *a, const Take *b, const char *what);

/** Returns 64. */
uint32_t blocks_of_64(void *context);
/** Returns the uint32_t that @p context points to. */
uint32_t blocks_of(void *context);

#endif
