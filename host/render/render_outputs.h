/* SPDX-License-Identifier: MIT */
/**
 * @file render_outputs.h
 * Which files a rendering writes: planned and checked against each other and against those it reads.
 */
#ifndef TABOR_HOST_RENDER_OUTPUTS_H
#define TABOR_HOST_RENDER_OUTPUTS_H

#include "render/render_request.h"

#define DEFAULT_OUTPUT "strike.wav"

/** Reads -o, -n and --trace for @p request, whose drum, microphones and events are read. */
Outcome render_outputs_plan(const Arguments *arguments, RenderRequest *request);
/** Refuses @p request if an output of it would replace the preset or events that @p arguments name. */
Outcome render_outputs_protect(const Arguments *arguments, const RenderRequest *request);

#endif
