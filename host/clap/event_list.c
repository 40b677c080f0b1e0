/* SPDX-License-Identifier: MIT */
#include "clap/event_list.h"

/* Functions of the host that CLAP wants fit for the audio thread. */
typedef uint32_t CountEventsFn(const clap_input_events_t *) REALTIME;
typedef const clap_event_header_t *GetEventFn(const clap_input_events_t *, uint32_t) REALTIME;
typedef bool PushEventFn(const clap_output_events_t *, const clap_event_header_t *) REALTIME;

EventList event_list_of(const clap_process_t *block) {
  EventList list = {
    .events = block->in_events, .answers = block->out_events, .frames = block->frames_count};
  if (list.events) list.count = ((CountEventsFn *)list.events->size)(list.events);
  return list;
}

const clap_event_header_t *event_list_at(const EventList *list, uint32_t number) {
  if (number >= list->count) return NULL;
  return ((GetEventFn *)list->events->get)(list->events, number);
}

uint32_t event_list_frame(const EventList *list, const clap_event_header_t *event, uint32_t at) {
  if (event->time <= at) return at;
  return event->time < list->frames ? event->time : list->frames - (list->frames > 0);
}

bool event_list_tell(const clap_output_events_t *answers, const clap_event_header_t *event) {
  return ((PushEventFn *)answers->try_push)(answers, event);
}

void event_list_end_note(const EventList *list, const clap_event_header_t *event) {
  const bool ends = event->space_id == CLAP_CORE_EVENT_SPACE_ID &&
                    (event->type == CLAP_EVENT_NOTE_OFF || event->type == CLAP_EVENT_NOTE_CHOKE);
  if (!ends || !list->answers) return;
  clap_event_note_t end = *(const clap_event_note_t *)event;
  end.header.size = sizeof end;
  end.header.type = CLAP_EVENT_NOTE_END;
  end.header.flags = 0;
  (void)event_list_tell(list->answers, &end.header);
}
