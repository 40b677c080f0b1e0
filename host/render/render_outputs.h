/* SPDX-License-Identifier: MIT */
/**
 * @file render_outputs.h
 * Plans the files that a rendering writes; checks them against each other and against its input
 * files.
 */
#ifndef TABOR_HOST_RENDER_OUTPUTS_H
#define TABOR_HOST_RENDER_OUTPUTS_H

#include "render/render_request.h"

#define DEFAULT_OUTPUT "strike.wav"
#define DEFAULT_KIT_OUTPUT "kit.wav"

/** Reads -o, -n and --trace for @p request, whose drum, microphones and events are read. */
Outcome render_outputs_plan(const Arguments *arguments, RenderRequest *request);
/** Refuses @p request if one of its outputs would replace the preset or events file in @p
 * arguments. */
Outcome render_outputs_protect(const Arguments *arguments, const RenderRequest *request);

#endif
