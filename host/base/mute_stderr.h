/* SPDX-License-Identifier: MIT */
/**
 * @file mute_stderr.h
 * Libraries print on standard error what is none of the user's business: not while they are hushed.
 */
#ifndef TABOR_HOST_HUSH_H
#define TABOR_HOST_HUSH_H

/**
 * Keeps what anybody prints on standard error from now on from being seen; gives what hush_end() takes.
 * Any thread; others that want it meanwhile wait, so nothing that may hang belongs in between.
 */
int hush_begin(void);
void hush_end(int kept);

#endif
