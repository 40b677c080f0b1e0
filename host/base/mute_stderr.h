/* SPDX-License-Identifier: MIT */
/**
 * @file mute_stderr.h
 * Libraries print on standard error what is none of the user's business: not while it is muted.
 */
#ifndef TABOR_HOST_MUTE_STDERR_H
#define TABOR_HOST_MUTE_STDERR_H

/**
 * Keeps what anybody prints on standard error from now on from being seen; gives what mute_stderr_end() takes.
 * Any thread; others that want it meanwhile wait, so nothing that may hang belongs in between.
 */
int mute_stderr_begin(void);
void mute_stderr_end(int kept);

#endif
