/* SPDX-License-Identifier: MIT */
/**
 * @file sample_spool.h
 * Samples set aside in a temporary file without a name until all of them are known: how loud a sound
 * is shows only at its end, and it need not fit into memory.
 */
#ifndef TABOR_HOST_SPOOL_H
#define TABOR_HOST_SPOOL_H

#include <stddef.h>
#include <stdio.h>

#include "base/message.h"

typedef struct Spool {
  FILE *stream;
} Spool;

/** Free with spool_free(), whatever the outcome. */
Outcome spool_open(Spool *spool);
/** Appends samples, each of them exactly a float. */
Outcome spool_write(Spool *spool, const double *samples, size_t count);
/** Back to the first sample, for reading. */
Outcome spool_rewind(Spool *spool);
/** Reads the next samples; all of them must have been written. */
Outcome spool_read(Spool *spool, double *samples, size_t count);
void spool_free(Spool *spool);

#endif
