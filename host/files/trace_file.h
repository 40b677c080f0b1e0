/* SPDX-License-Identifier: MIT */
/**
 * @file trace_file.h
 * `--trace`: displacements, forces and energy as CSV, a row a sample.
 */
#ifndef TABOR_HOST_TRACE_FILE_H
#define TABOR_HOST_TRACE_FILE_H

#include "base/output_file.h"

/** Rows on their way to an open OutputFile, which it does not own. */
typedef struct TraceFile {
  OutputFile *output;
  char *text;       /**< not yet written */
  size_t length;    /**< of it */
  uint64_t written; /**< bytes before it */
} TraceFile;

/** Starts the file with its columns' names. Free with trace_file_free(), whatever the outcome. */
Outcome trace_file_open(TraceFile *trace, OutputFile *output);
/** Adds the state of @p drum, which is that of time @p time [s]. */
Outcome trace_file_row(TraceFile *trace, double time, const TaborDrum *drum);
/** Writes what is left; where the file has a size, checks it. */
Outcome trace_file_finish(TraceFile *trace);
void trace_file_free(TraceFile *trace);

#endif
