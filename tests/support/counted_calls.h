/* SPDX-License-Identifier: MIT */
/**
 * @file counted_calls.h
 * Counts what an audio thread must not call: what allocates, locks, sleeps or touches files. The linker sends
 * every such call of the test, the engine's included, through counters; CMakeLists.txt lists them.
 */
#ifndef TABOR_TESTS_COUNTED_CALLS_H
#define TABOR_TESTS_COUNTED_CALLS_H

/** From now on the calls of this thread count. */
void count_calls_begin(void);
/** How many there were. */
long count_calls_end(void);
/** A cmocka test that the counters count: one that cannot would find nothing either. */
void the_counters_count(void **state);

#endif
