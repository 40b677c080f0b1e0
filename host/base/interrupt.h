/* SPDX-License-Identifier: MIT */
/**
 * @file interrupt.h
 * Signals: nothing half-written stays behind, and the exit status tells which signal it was.
 */
#ifndef TABOR_HOST_INTERRUPT_H
#define TABOR_HOST_INTERRUPT_H

#include <signal.h>

/**
 * From now on SIGINT, SIGQUIT, SIGTERM and their like remove the guarded files and end the program with
 * 128 + signal (130, 143); SIGPIPE and SIGXFSZ become errors of the write that caused them.
 */
void interrupt_install(void);

/**
 * From now on SIGHUP, SIGINT, SIGQUIT and SIGTERM are only noted, so that the program can end by itself, and soon, and
 * keep what is finished.
 */
void interrupt_catch(void);
/** The number of the first that was noted, or 0. Any thread. */
int interrupt_caught(void);

/** Has @p call, which is async-signal-safe, called before such a signal ends the program. */
void interrupt_at_end(void (*call)(void));

/** Threads that may guard the files of a rendering at the same time. */
#define INTERRUPT_MOST_THREADS 256

/**
 * Holds signals back, so that creating or renaming a file and noting it down are one step. One thread
 * holds at a time, others wait: keep it short. A hold may lie within another.
 */
void interrupt_hold(sigset_t *before);
void interrupt_resume(const sigset_t *before);

/** Guards the file @p path (not copied) until interrupt_unguard(); signals are to be held. */
void interrupt_guard(const char *path);
void interrupt_unguard(const char *path);

#endif
