/* SPDX-License-Identifier: MIT */
/**
 * @file suggest.h
 * "did you mean ...": the nearest of a list of names to one that does not exist.
 */
#ifndef TABOR_HOST_SUGGEST_H
#define TABOR_HOST_SUGGEST_H

#include <stddef.h>

/** Name @p index of a list, or NULL past its end. */
typedef const char *NameAt(const void *list, size_t index);

/**
 * Nearest name to @p word by edit distance (insertions, deletions, substitutions and swaps of
 * neighbours; cutting the end off counts as one), or NULL if none is near: more than a third of the
 * word would have to change.
 */
const char *suggest(const char *word, NameAt *name_at, const void *list);

/**
 * Writes "; did you mean 'PREFIXname'?" for the nearest name, or "", to @p hint; returns @p hint.
 */
const char *suggest_hint(char *hint, size_t size, const char *word, const char *prefix,
                         NameAt *name_at, const void *list);

/**
 * The same or, if no name is near, "; there are: a, b, c" as far as it fits: for lists that a line
 * can hold. Names that do not fit leave "..." behind.
 */
const char *suggest_choice(char *hint, size_t size, const char *word, const char *prefix,
                           NameAt *name_at, const void *list);

#endif
