/* SPDX-License-Identifier: MIT */
/**
 * @file counted_calls.h
 * Counts calls that are forbidden in an audio thread: functions that allocate, lock, sleep or
 * access files. The linker routes every such call of the test and the engine through counters;
 * CMakeLists.txt lists them.
 */
#ifndef TABOR_TESTS_COUNTED_CALLS_H
#define TABOR_TESTS_COUNTED_CALLS_H

/** Starts to count the calls of this thread. */
void count_calls_begin(void);
/** Stops counting; returns the number of calls. */
long count_calls_end(void);
/** A cmocka test that the counters work; a broken counter would hide forbidden calls. */
void the_counters_count(void **state);

#endif
