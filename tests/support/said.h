/* SPDX-License-Identifier: MIT */
/**
 * @file said.h
 * Replaces the messages of host/base/message.h in tests of single modules: keeps them instead of
 * printing them.
 */
#ifndef TABOR_TESTS_SAID_H
#define TABOR_TESTS_SAID_H

extern char said[1024];     /**< the newest message; "" after said_nothing() */
extern unsigned said_count; /**< messages since said_nothing() */
/** Forgets all messages. */
void said_nothing(void);

#endif
