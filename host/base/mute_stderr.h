/* SPDX-License-Identifier: MIT */
/**
 * @file mute_stderr.h
 * Suppresses output on standard error, for libraries that print there.
 */
#ifndef TABOR_HOST_MUTE_STDERR_H
#define TABOR_HOST_MUTE_STDERR_H

/**
 * Suppresses all output on standard error until mute_stderr_end(), which takes the returned value.
 * Any thread; a second thread that calls this waits, so do nothing in between that may hang.
 */
int mute_stderr_begin(void);
void mute_stderr_end(int kept);

#endif
