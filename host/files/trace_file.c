/* SPDX-License-Identifier: MIT */
#include "files/trace_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BUFFER 65536
#define LONGEST_ROW 256 /* seven numbers of at most 25 characters */

static const char header[] =
  "time_s,head_m,wire_m,striker_m,striker_force_n,wire_force_n,energy_j\n";

static Outcome flush_text(TraceFile *trace) {
  const Outcome outcome = output_write(trace->output, trace->text, trace->length);
  trace->written += trace->length;
  trace->length = 0;
  return outcome;
}

Outcome trace_file_open(TraceFile *trace, OutputFile *output) {
  *trace = (TraceFile){.output = output, .text = malloc(BUFFER)};
  if (!trace->text) return fail_memory();
  memcpy(trace->text, header, sizeof header - 1);
  trace->length = sizeof header - 1;
  return OUTCOME_OK;
}

static void append(TraceFile *trace, const char *format, double number) {
  const int length = snprintf(trace->text + trace->length, BUFFER - trace->length, format, number);
  trace->length += (size_t)length;
}

/* 17 digits give the very same double back. An absent part is an empty field. */
static void append_field(TraceFile *trace, double number) {
  trace->text[trace->length++] = ',';
  if (!isnan(number)) append(trace, "%.17g", number);
}

Outcome trace_file_row(TraceFile *trace, double time, const TaborDrum *drum) {
  TaborProbe probe;
  TaborLedger ledger;
  tabor_drum_probe(drum, &probe);
  tabor_drum_ledger(drum, &ledger);
  const double fields[] = {probe.head,          probe.wire,       probe.striker,
                           probe.striker_force, probe.wire_force, ledger.stored};
  append(trace, "%.12g", time);
  for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) append_field(trace, fields[i]);
  trace->text[trace->length++] = '\n';
  return trace->length > BUFFER - LONGEST_ROW ? flush_text(trace) : OUTCOME_OK;
}

Outcome trace_file_finish(TraceFile *trace) {
  const Outcome outcome = flush_text(trace);
  if (outcome != OUTCOME_OK || trace->output->kind == OUTPUT_STREAMED) return outcome;
  FileStatus status;
  if (!file_status_of(trace->output->descriptor, &status)) return output_failure(trace->output);
  if (status.size == trace->written) return OUTCOME_OK;
  return fail("cannot write '%s': it is not complete", trace->output->name);
}

void trace_file_free(TraceFile *trace) {
  free(trace->text);
  *trace = (TraceFile){0};
}
