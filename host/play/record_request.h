/* SPDX-License-Identifier: MIT */
/**
 * @file record_request.h
 * The recording that a command line asks for by --record and --format.
 */
#ifndef TABOR_HOST_RECORD_REQUEST_H
#define TABOR_HOST_RECORD_REQUEST_H

#include "base/options.h"
#include "files/audio_file.h"

typedef struct RecordRequest {
  bool records;
  OutputFile output; /**< planned, if it records */
  AudioFormat audio; /**< without its rate */
} RecordRequest;

/** Initialises: nothing is recorded. */
void record_request_begin(RecordRequest *request);
Outcome record_request_read(const Arguments *arguments, uint32_t channels, RecordRequest *request);
void record_request_free(RecordRequest *request);

#endif
