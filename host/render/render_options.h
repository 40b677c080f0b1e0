/* SPDX-License-Identifier: MIT */
/**
 * @file render_options.h
 * The command line of `tabor render`, checked in full before anything is computed or written.
 */
#ifndef TABOR_HOST_RENDER_OPTIONS_H
#define TABOR_HOST_RENDER_OPTIONS_H

#include "base/interrupt.h"
#include "base/options.h"
#include "render/render_request.h"

/** Rows of the option tables for the options that render_request_read() reads. */
#define OPTION_FORMAT                                                                              \
  { "format", 0, "FORMAT", "pcm16, pcm24 or float (default " DEFAULT_ENCODING ")" }
#define OPTION_DURATION                                                                            \
  { "duration", 0, "SECONDS", "length, 0.01 to 3600 (default: until the drum has died away)" }
#define OPTION_MIC                                                                                 \
  { "mic", 0, "NAME", "microphone, a channel each (repeatable; default: the preset's first)" }
#define OPTION_GAIN                                                                                \
  { "gain", 0, "DB", "amplification, -120 to 120 (default 0)" }
#define OPTION_JOBS                                                                                \
  { "jobs", 'j', "N", "sounds to render at once, 1 to 256 (default: the number of processors)" }

#define MOST_JOBS INTERRUPT_MOST_THREADS

extern const Option render_options[];

/** Reads --jobs; the default is the number of processors. */
Outcome render_threads_read(const Arguments *arguments, uint32_t *count);
/** Reads what says how a sound of @p kit, which must outlive the request, is rendered: quality,
 * rate, format, level, length. */
Outcome render_kit_format_read(const Arguments *arguments, const TaborKitDef *kit,
                               RenderRequest *request);

/** Reads the command line. Free with render_request_free(), whatever the outcome. */
Outcome render_request_read(const Arguments *arguments, RenderRequest *request);

#endif
