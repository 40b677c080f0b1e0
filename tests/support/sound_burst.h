/* SPDX-License-Identifier: MIT */
/**
 * @file sound_burst.h
 * A sound that goes into Tabor Rattle, and what the program makes of it. Any failure fails the
 * test.
 */
#ifndef TABOR_TESTS_SOUND_BURST_H
#define TABOR_TESTS_SOUND_BURST_H

#include "plugin_songs.h"

#define BURST_FRAMES 20000u

/** A tom-like burst: 180 Hz, dying away. */
extern float burst[BURST_FRAMES];

/** Computes the burst. */
void burst_make(void);
/** The burst at a frame of any number: behind its end, silence. */
static inline float burst_at(uint32_t frame) { return frame < BURST_FRAMES ? burst[frame] : 0.0f; }
/** Lets `tabor render --input` play it, heard by the pair in free air at draft; needs
 * songs_begin(). */
void burst_render(const char *program, Take *take);

#endif
