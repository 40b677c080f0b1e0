/* SPDX-License-Identifier: MIT */
/**
 * @file sample_spool.h
 * Samples set aside in a temporary file without a name until all of them are known: how loud a sound
 * is shows only at its end, and it need not fit into memory.
 */
#ifndef TABOR_HOST_SAMPLE_SPOOL_H
#define TABOR_HOST_SAMPLE_SPOOL_H

#include <stddef.h>
#include <stdio.h>

#include "base/message.h"

typedef struct SampleSpool {
  FILE *stream;
} SampleSpool;

/** Free with sample_spool_free(), whatever the outcome. */
Outcome sample_spool_open(SampleSpool *spool);
/** Appends samples, each of them exactly a float. */
Outcome sample_spool_write(SampleSpool *spool, const double *samples, size_t count);
/** Back to the first sample, for reading. */
Outcome sample_spool_rewind(SampleSpool *spool);
/** Reads the next samples; all of them must have been written. */
Outcome sample_spool_read(SampleSpool *spool, double *samples, size_t count);
void sample_spool_free(SampleSpool *spool);

#endif
