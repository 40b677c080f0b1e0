/* SPDX-License-Identifier: MIT */
/**
 * @file play_kit.h
 * `tabor play --kit`: a kit played by live MIDI or by a MIDI file, until Ctrl-C or for --duration.
 */
#ifndef TABOR_HOST_PLAY_KIT_H
#define TABOR_HOST_PLAY_KIT_H

#include "base/options.h"

Outcome play_kit(const Arguments *arguments);

#endif
