/* SPDX-License-Identifier: MIT */
#include "clap/gui_link.h"

#include "clap/event_list.h"

enum { TURNS = 256 };

bool gui_link_begin(GuiLink *link) {
  return spsc_queue_create(&link->turns, sizeof(GuiTurn), TURNS);
}

void gui_link_end(GuiLink *link) { spsc_queue_destroy(&link->turns); }

void gui_link_turn(GuiLink *link, uint16_t type, clap_id id, double value) {
  const GuiTurn turn = {.type = type, .id = id, .value = value};
  (void)spsc_queue_push(&link->turns, &turn);
}

static bool report_turn(const GuiTurn *turn, const clap_output_events_t *events) REALTIME;
static bool report_turn(const GuiTurn *turn, const clap_output_events_t *events) {
  const clap_event_header_t header = {.space_id = CLAP_CORE_EVENT_SPACE_ID, .type = turn->type};
  if (turn->type == CLAP_EVENT_PARAM_VALUE) {
    clap_event_param_value_t value = {.header = header,
                                      .param_id = turn->id,
                                      .note_id = -1,
                                      .port_index = -1,
                                      .channel = -1,
                                      .key = -1,
                                      .value = turn->value};
    value.header.size = sizeof value;
    return event_list_tell(events, &value.header);
  }
  clap_event_param_gesture_t gesture = {.header = header, .param_id = turn->id};
  gesture.header.size = sizeof gesture;
  return event_list_tell(events, &gesture.header);
}

void gui_link_report(GuiLink *link, const clap_output_events_t *events) {
  const GuiTurn *turn;
  while (events && (turn = spsc_queue_peek(&link->turns)) != NULL) {
    if (!report_turn(turn, events)) return;
    spsc_queue_pop(&link->turns);
  }
}
