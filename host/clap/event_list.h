/* SPDX-License-Identifier: MIT */
/**
 * @file event_list.h
 * The events of a host's block, in order of time, and what is answered. AUDIO: all functions.
 */
#ifndef TABOR_CLAP_EVENT_LIST_H
#define TABOR_CLAP_EVENT_LIST_H

#include <clap/clap.h>

#include "base/realtime.h"

typedef struct EventList {
  const clap_input_events_t *events;
  const clap_output_events_t *answers;
  uint32_t count;
  uint32_t frames; /**< of the block */
} EventList;

EventList event_list_of(const clap_process_t *block) REALTIME;
/** Event @p number; NULL past the last, or if the host has none there. */
const clap_event_header_t *event_list_at(const EventList *list, uint32_t number) REALTIME;
/** The frame at which an event acts, @p at or later; one past the end is at the last frame. */
uint32_t event_list_frame(const EventList *list, const clap_event_header_t *event,
                          uint32_t at) REALTIME;
/** Tells the host of @p event. False: it takes no more. */
bool event_list_tell(const clap_output_events_t *answers,
                     const clap_event_header_t *event) REALTIME;
/** Tells the host that it need not keep a voice for a note that @p event lets go. */
void event_list_end_note(const EventList *list, const clap_event_header_t *event) REALTIME;

#endif
