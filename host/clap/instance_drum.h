/* SPDX-License-Identifier: MIT */
/**
 * @file instance_drum.h
 * The drum of an instance, given and taken as a whole, and the host's log.
 */
#ifndef TABOR_CLAP_INSTANCE_DRUM_H
#define TABOR_CLAP_INSTANCE_DRUM_H

#include "clap/instance.h"

/** MAIN. Makes @p saved the drum; the values of the knobs are the caller's business. */
void instance_restore(Instance *instance, const SavedState *saved);
/** MAIN. The drum as it is to be saved. */
void instance_save(Instance *instance, SavedState *saved);
/** Writes an error line to the host's log. Any thread but the audio thread. */
void instance_say(Instance *instance, const char *line);

#endif
