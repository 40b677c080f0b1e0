/* SPDX-License-Identifier: MIT */
/**
 * @file midi_glue.c
 * What drums and kits have in common when they play MIDI, live and from files. Messages are converted by the program's own map (host/midi), so
 * that the page plays a note as `tabor render --midi-file` does.
 */
#include "glue.h"
#include "kit/song_events.h"

MidiMessage web_midi_message(uint32_t status, uint32_t first, uint32_t second) {
  return (MidiMessage){.status = (uint8_t)status, .data = {first & 0x7F, second & 0x7F}};
}

WebMidiAction web_midi_action(uint32_t drum, const TaborEvent *event) {
  WebMidiAction action = {.kind = WEB_MIDI_NOTHING, .drum = drum, .frame = event->frame};
  if (event->type == TABOR_EVENT_STRIKE) {
    action.kind = WEB_MIDI_STROKE;
    action.value = event->velocity;
    action.radius = event->radius;
    action.angle = event->angle;
    action.technique = event->technique;
  } else if (event->type == TABOR_EVENT_PARAMETER &&
             event->parameter == tabor_parameter_find("wires.strainer")->id) {
    action.kind = WEB_MIDI_STRAINER;
    action.value = event->value;
  }
  return action;
}

/* ---- files: drum_compose() and kit_compose() make the events ----------------------------- */

EXPORT("song_most_bytes") size_t web_song_most_bytes(void) { return song_events_most_bytes(); }

/* NULL without memory. */
EXPORT("song_read") SongEvents *web_song_read(const void *bytes, size_t size) {
  return song_events_read(bytes, size);
}

EXPORT("song_error") const char *web_song_error(const SongEvents *song) {
  return song_events_error(song);
}

EXPORT("song_warning_count") uint32_t web_song_warning_count(const SongEvents *song) {
  return song_events_warning_count(song);
}

EXPORT("song_warning") const char *web_song_warning(const SongEvents *song, uint32_t index) {
  return song_events_warning(song, index);
}

EXPORT("song_count") size_t web_song_count(const SongEvents *song) {
  return song_events_count(song);
}

/* What an event of the song does, until the next call. */
EXPORT("song_action") const WebMidiAction *web_song_action(const SongEvents *song, size_t index) {
  static WebMidiAction action;
  const TaborKitEvent *const event = &song_events_list(song)[index];
  action = web_midi_action(event->drum, &event->event);
  return &action;
}

EXPORT("song_free") void web_song_free(SongEvents *song) { song_events_free(song); }
