/* SPDX-License-Identifier: MIT */
/**
 * @file sequence.h
 * The events of an LV2 atom sequence, whatever stands in it: nothing beyond its end is read, and what is no
 * sequence has no events. AUDIO: all functions.
 */
#ifndef TABOR_LV2_SEQUENCE_H
#define TABOR_LV2_SEQUENCE_H

#include <lv2/atom/atom.h>
#include <lv2/urid/urid.h>
#include <stdbool.h>
#include <stdint.h>

#include "base/realtime.h"

/** A place in a sequence. */
typedef struct Sequence {
  const uint8_t *next, *end;
} Sequence;

/** @p atom may be NULL; @p type is the URID of atom:Sequence. */
Sequence sequence_begin(const LV2_Atom_Sequence *atom, LV2_URID type) REALTIME;
/** The event at this place, complete, or NULL past the last. */
const LV2_Atom_Event *sequence_event(const Sequence *sequence) REALTIME;
/** On to the next; there must be an event at this place. */
void sequence_step(Sequence *sequence) REALTIME;

#endif
