/* SPDX-License-Identifier: MIT */
/**
 * @file said.h
 * Stands in for host/base/message.h's messages in the tests of single modules: what would have been printed
 * is kept.
 */
#ifndef TABOR_TESTS_SAID_H
#define TABOR_TESTS_SAID_H

extern char said[1024];     /**< the newest message; "" after said_nothing() */
extern unsigned said_count; /**< messages since then */
void said_nothing(void);

#endif
