/* SPDX-License-Identifier: MIT */
/**
 * @file render_kit.h
 * `tabor render --kit`: a MIDI file played on a kit, as its stereo mix, or with --split as a stereo file for each drum.
 */
#ifndef TABOR_HOST_RENDER_KIT_H
#define TABOR_HOST_RENDER_KIT_H

#include "base/options.h"

Outcome render_kit(const Arguments *arguments);

#endif
