/* SPDX-License-Identifier: MIT */
/**
 * @file trace_file.h
 * `--trace`: displacements, forces and energy as CSV, one row per sample.
 */
#ifndef TABOR_HOST_TRACE_FILE_H
#define TABOR_HOST_TRACE_FILE_H

#include "base/output_file.h"

/** A buffer of rows for an open OutputFile, which it does not own. */
typedef struct TraceFile {
  OutputFile *output;
  char *text;       /**< rows not yet written */
  size_t length;    /**< bytes of text */
  uint64_t written; /**< bytes written so far */
} TraceFile;

/** Starts the file with the names of the columns. Free with trace_file_free(), whatever the
 * outcome. */
Outcome trace_file_open(TraceFile *trace, OutputFile *output);
/** Adds the state of @p drum at time @p time [s]. */
Outcome trace_file_row(TraceFile *trace, double time, const TaborDrum *drum);
/** Writes the rest; checks the size of the file if it has one. */
Outcome trace_file_finish(TraceFile *trace);
void trace_file_free(TraceFile *trace);

#endif
