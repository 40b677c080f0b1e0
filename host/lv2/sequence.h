/* SPDX-License-Identifier: MIT */
/**
 * @file sequence.h
 * Reads the events of an LV2 atom sequence, which may be malformed. Nothing beyond its end is read.
 * An atom that is not a sequence has no events. AUDIO: all functions.
 */
#ifndef TABOR_LV2_SEQUENCE_H
#define TABOR_LV2_SEQUENCE_H

#include <lv2/atom/atom.h>
#include <lv2/urid/urid.h>
#include <stdbool.h>
#include <stdint.h>

#include "base/realtime.h"

/** A position in a sequence. */
typedef struct Sequence {
  const uint8_t *next, *end;
} Sequence;

/** Starts at the first event. @p atom may be NULL; @p type is the URID of atom:Sequence. */
Sequence sequence_begin(const LV2_Atom_Sequence *atom, LV2_URID type) REALTIME;
/** Returns the event at this position, which is complete; NULL past the last. */
const LV2_Atom_Event *sequence_event(const Sequence *sequence) REALTIME;
/** Moves to the next event; there must be an event at this position. */
void sequence_step(Sequence *sequence) REALTIME;

#endif
