/* SPDX-License-Identifier: MIT */
#include "clap/gui_link.h"

#include <math.h>

#include "clap/event_list.h"

enum { MESSAGES = 256 };

bool gui_link_begin(GuiLink *link) {
  return spsc_queue_create(&link->strokes, sizeof(GuiStroke), MESSAGES) &&
         spsc_queue_create(&link->turns, sizeof(GuiTurn), MESSAGES);
}

void gui_link_end(GuiLink *link) {
  spsc_queue_destroy(&link->strokes);
  spsc_queue_destroy(&link->turns);
}

void gui_link_play(GuiLink *link, PluginPlayer *player) {
  const GuiStroke *stroke;
  while ((stroke = spsc_queue_peek(&link->strokes)) != NULL) {
    plugin_player_strike(player, stroke->velocity, stroke->radius, stroke->angle);
    spsc_queue_pop(&link->strokes);
  }
}

static float peak_of(const float *samples, uint32_t frames, float peak) REALTIME;
static float peak_of(const float *samples, uint32_t frames, float peak) {
  for (uint32_t i = 0; i < frames; i++) peak = fmaxf(peak, fabsf(samples[i]));
  return peak;
}

void gui_link_show(GuiLink *link, const PluginPlayer *player, const PluginOutputs *outputs,
                   uint32_t frames) {
  if (!atomic_load(&link->is_shown)) return;
  for (uint32_t side = 0; side < 2; side++) {
    const float *const channel = outputs->channels[side];
    if (!channel) continue;
    const float before = atomic_load(&link->peaks[side]);
    atomic_store(&link->peaks[side], peak_of(channel, frames, before));
  }
  TaborView *const view = atomic_exchange(&link->asked, NULL);
  if (!view) return;
  const TaborDrum *const drum = player->core.drum;
  if (!drum || !tabor_drum_view(drum, view)) atomic_store(&link->is_stale, true);
  atomic_store(&link->seen, view);
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
