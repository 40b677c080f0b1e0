/* SPDX-License-Identifier: MIT */
/**
 * @file sample_spool.h
 * Stores samples in an unnamed temporary file until all of them are known. The peak of a sound is
 * known only at its end, and the sound may be larger than memory.
 */
#ifndef TABOR_HOST_SAMPLE_SPOOL_H
#define TABOR_HOST_SAMPLE_SPOOL_H

#include <stddef.h>
#include <stdio.h>

#include "base/message.h"

typedef struct SampleSpool {
  FILE *stream;
} SampleSpool;

/** Creates the file. Free with sample_spool_free(), whatever the outcome. */
Outcome sample_spool_open(SampleSpool *spool);
/** Appends samples, each exactly representable as a float. */
Outcome sample_spool_write(SampleSpool *spool, const double *samples, size_t count);
/** Goes back to the first sample, for reading. */
Outcome sample_spool_rewind(SampleSpool *spool);
/** Reads the next @p count samples, which must have been written. */
Outcome sample_spool_read(SampleSpool *spool, double *samples, size_t count);
void sample_spool_free(SampleSpool *spool);

#endif
