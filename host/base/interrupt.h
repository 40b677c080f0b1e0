/* SPDX-License-Identifier: MIT */
/**
 * @file interrupt.h
 * Signal handling: removes partial files, and the exit status shows which signal came.
 */
#ifndef TABOR_HOST_INTERRUPT_H
#define TABOR_HOST_INTERRUPT_H

#include "platform/signals.h"

/**
 * Installs the handlers. SIGINT, SIGQUIT, SIGTERM and similar signals remove the guarded files and
 * end the program with 128 + signal (130, 143). SIGPIPE and SIGXFSZ become errors of the write that
 * caused them.
 */
void interrupt_install(void);

/**
 * From now on SIGHUP, SIGINT, SIGQUIT and SIGTERM are only recorded. The program must then end soon
 * by itself and can keep its finished work.
 */
void interrupt_catch(void);
/** Number of the first recorded signal, or 0. Any thread. */
int interrupt_caught(void);

/** Sets @p call, which must be async-signal-safe, to be called before a signal ends the program. */
void interrupt_at_end(void (*call)(void));

/** Most threads that may guard the files of a rendering at the same time. */
#define INTERRUPT_MOST_THREADS 256

/**
 * Blocks signals until interrupt_resume(), so that creating or renaming a file and recording it are
 * one step. One thread holds at a time and others wait, so keep it short. Holds may be nested.
 */
void interrupt_hold(SignalMask *before);
void interrupt_resume(const SignalMask *before);

/** Guards the file @p path (not copied) until interrupt_unguard(). Call both while signals are
 * held. */
void interrupt_guard(const char *path);
void interrupt_unguard(const char *path);

#endif
