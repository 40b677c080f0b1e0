/* SPDX-License-Identifier: MIT */
/**
 * @file suggest.h
 * "did you mean ...": finds the name in a list that is nearest to an unknown word.
 */
#ifndef TABOR_HOST_SUGGEST_H
#define TABOR_HOST_SUGGEST_H

#include <stddef.h>

/** Returns name @p index of a list, or NULL past its end. */
typedef const char *NameAt(const void *list, size_t index);

/**
 * Finds the name nearest to @p word by edit distance (insertions, deletions, substitutions and
 * swaps of neighbours; cutting the end off counts as one). NULL if more than a third of the word
 * would have to change.
 */
const char *suggest(const char *word, NameAt *name_at, const void *list);

/**
 * Writes "; did you mean 'PREFIXname'?" for the nearest name to @p hint, or "" without one; returns
 * @p hint.
 */
const char *suggest_hint(char *hint, size_t size, const char *word, const char *prefix,
                         NameAt *name_at, const void *list);

/**
 * Works like suggest_hint(), but writes "; there are: a, b, c" if no name is near: for lists that
 * fit into a line. "..." replaces names that do not fit.
 */
const char *suggest_choice(char *hint, size_t size, const char *word, const char *prefix,
                           NameAt *name_at, const void *list);

#endif
