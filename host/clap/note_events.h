/* SPDX-License-Identifier: MIT */
/**
 * @file note_events.h
 * CLAP's notes as MIDI messages, so that both dialects have the same meaning. A choke is none: it
 * silences what its key plays.
 *
 * | event | message |
 * |---|---|
 * | note on | note on; what 7 bits do not hold of the velocity comes before it, as controller 88 |
 * | note off | note off |
 * | pressure of a note | pressure of its key, or of the channel if the event names no key |
 * | brightness of a note | controller 16: 0 is the centre of the head, 1 the rim |
 *
 * AUDIO: all functions.
 */
#ifndef TABOR_CLAP_NOTE_EVENTS_H
#define TABOR_CLAP_NOTE_EVENTS_H

#include <clap/clap.h>

#include "midi/midi_stream.h"

#define NOTE_EVENT_MESSAGES 2 /**< most messages of an event */

/** Writes the messages of @p event and returns their number, 0 for other events and bad ones. */
uint32_t note_event_messages(const clap_event_header_t *event,
                             MidiMessage messages[NOTE_EVENT_MESSAGES]) REALTIME;

/** True for a note choke, which may name a key. */
bool note_event_is_choke(const clap_event_header_t *event) REALTIME;
/** Raises choked[key] to @p number for every key that @p event chokes; a choke without a key is for
 * all. */
void note_event_choke(const clap_event_header_t *event, uint32_t number,
                      uint32_t choked[MIDI_VALUES]) REALTIME;

#endif
