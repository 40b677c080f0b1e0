/* SPDX-License-Identifier: MIT */
/**
 * @file midi_glue.c
 * MIDI, live and from files. Messages are converted by the program's own map (host/midi), so that
 * JavaScript plays a note as `tabor render --midi-file` does.
 */
#include <math.h>
#include <stdlib.h>

#include "glue.h"

/* ---- messages ------------------------------------------------------------------------------- */

static MidiMessage message_of(uint32_t status, uint32_t first, uint32_t second) {
  return (MidiMessage){.status = (uint8_t)status, .data = {first & 0x7F, second & 0x7F}};
}

/* Begins to play MIDI on the instrument as it is defined now, by the default map of docs/midi.md or
 * the kit's notes. False if there is no memory. */
EXPORT("instrument_begin_midi") bool web_instrument_begin_midi(WebInstrument *web) {
  MidiBinding binding;
  if (web->is_kit) {
    if (!web->kit_midi) web->kit_midi = malloc(sizeof *web->kit_midi);
    if (web->kit_midi) kit_midi_begin(web->kit_midi, &web->def, &kit_midi_setup_default);
    return web->kit_midi != NULL;
  }
  midi_map_default(&web->map);
  midi_binding_make(&web->map, web_definition(web, 0), &binding);
  midi_to_events_begin(&web->midi, &web->map, &binding);
  return true;
}

/* ---- what they do --------------------------------------------------------------------------- */

/* Program changes, which take other drums, are passed over. */
static bool send_to_drum(WebInstrument *web, uint32_t frame, const MidiMessage *message) {
  MidiAction actions[MIDI_MOST_ACTIONS];
  PlayerMessage sent;
  const uint32_t count = midi_to_events_take(&web->midi, message, actions);
  bool is_sent = true;
  for (uint32_t i = 0; i < count; i++) {
    if (player_message_from_midi(&actions[i], 0, &sent))
      is_sent = web_add(web, frame, &sent) && is_sent;
  }
  return is_sent;
}

static bool send_to_kit(WebInstrument *web, uint32_t frame, const MidiMessage *message) {
  TaborKitEvent events[KIT_MIDI_MOST_EVENTS];
  const uint32_t count = kit_midi_take(web->kit_midi, message, events);
  bool is_sent = true;
  for (uint32_t i = 0; i < count; i++) {
    const PlayerMessage sent = player_message_from_kit(&events[i]);
    is_sent = web_add(web, frame, &sent) && is_sent;
  }
  return is_sent;
}

/* Plays a message at a frame of the next block. False if there is no memory. */
EXPORT("instrument_send_midi")
bool web_instrument_send_midi(WebInstrument *web, uint32_t frame, uint32_t status, uint32_t first,
                              uint32_t second) {
  const MidiMessage message = message_of(status, first, second);
  return web->is_kit ? send_to_kit(web, frame, &message) : send_to_drum(web, frame, &message);
}

/* ---- what messages would do ----------------------------------------------------------------- */

static WebMidiAction action_of(uint32_t drum, const TaborEvent *what) {
  WebMidiAction action = {.kind = WEB_MIDI_NOTHING, .drum = drum, .frame = what->frame};
  if (what->type == TABOR_EVENT_STRIKE) {
    action.kind = WEB_MIDI_STROKE;
    action.value = what->velocity;
    action.radius = what->radius;
    action.angle = what->angle;
    action.technique = what->technique;
    action.striker = what->striker;
  } else if (what->type == TABOR_EVENT_PARAMETER &&
             what->parameter == tabor_parameter_find("wires.strainer")->id) {
    action.kind = WEB_MIDI_STRAINER;
    action.value = what->value;
  }
  return action;
}

/* What a message does, until the next call: a stroke or a move of the strainer, else
 * WEB_MIDI_NOTHING. It does not act on the instrument. A controller that moves several drums'
 * snares moves them alike: the first one tells. */
EXPORT("instrument_take_midi")
const WebMidiAction *web_instrument_take_midi(WebInstrument *web, uint32_t status, uint32_t first,
                                              uint32_t second) {
  const MidiMessage message = message_of(status, first, second);
  TaborKitEvent events[KIT_MIDI_MOST_EVENTS];
  MidiAction actions[MIDI_MOST_ACTIONS];
  const uint32_t count = web->is_kit ? kit_midi_take(web->kit_midi, &message, events)
                                     : midi_to_events_take(&web->midi, &message, actions);
  web->midi_action = (WebMidiAction){.kind = WEB_MIDI_NOTHING};
  if (count == 0 || (!web->is_kit && actions[0].type != MIDI_ACTION_EVENT))
    return &web->midi_action;
  web->midi_action =
    web->is_kit ? action_of(events[0].drum, &events[0].event) : action_of(0, &actions[0].event);
  return &web->midi_action;
}

/* The velocity at which a note plays nearest to a speed [m/s], as a ratio. */
EXPORT("instrument_velocity")
uint32_t web_instrument_velocity(WebInstrument *web, uint32_t note, double speed) {
  uint32_t nearest = 1;
  double least = INFINITY;
  for (uint32_t velocity = 1; velocity < MIDI_VALUES; velocity++) {
    const double played = web_instrument_take_midi(web, MIDI_NOTE_ON, note, velocity)->value;
    const double off = fmax(played / speed, speed / played);
    if (off < least) {
      least = off;
      nearest = velocity;
    }
  }
  return nearest;
}

/* ---- files ---------------------------------------------------------------------------------- */

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

/* Makes a file's events of the instrument as it is defined now. False without memory, or with
 * song_error(). */
EXPORT("song_compose")
bool web_song_compose(SongEvents *song, const WebInstrument *web, double rate) {
  return web->is_kit ? song_events_of_kit(song, &web->def, -1, 0, 0, rate)
                     : song_events_of_drum(song, web_definition(web, 0), false, -1, rate);
}

EXPORT("song_count") size_t web_song_count(const SongEvents *song) {
  return song_events_count(song);
}

/* The frame of an event of the song, from its beginning. */
EXPORT("song_frame") uint32_t web_song_frame(const SongEvents *song, size_t index) {
  return song_events_list(song)[index].event.frame;
}

EXPORT("message_size") uint32_t web_message_size(void) { return sizeof(PlayerMessage); }

/* Writes an event of the song as a message, of message_size() bytes, which JavaScript keeps for
 * instrument_send_message(); it is there until the next call. */
EXPORT("song_message")
const PlayerMessage *web_song_message(const SongEvents *song, size_t index, WebInstrument *web) {
  const TaborKitEvent *const event = &song_events_list(song)[index];
  const bool is_gain = !web->is_kit && event->event.type == TABOR_EVENT_GAIN;
  web->message = player_message_from_kit(event);
  if (is_gain)
    web->message = (PlayerMessage){.type = PLAYER_EXPRESSION, .value = event->event.value};
  return &web->message;
}

/* Where JavaScript puts such a message. */
EXPORT("instrument_message") PlayerMessage *web_instrument_message(WebInstrument *web) {
  return &web->message;
}

/* Plays the message that was put there, at a frame of the next block. False if there is no memory.
 */
EXPORT("instrument_send_message")
bool web_instrument_send_message(WebInstrument *web, uint32_t frame) {
  return web_add(web, frame, &web->message);
}

/* What an event of the song does, until the next call. */
EXPORT("song_action") const WebMidiAction *web_song_action(const SongEvents *song, size_t index) {
  static WebMidiAction action;
  const TaborKitEvent *const event = &song_events_list(song)[index];
  action = action_of(event->drum, &event->event);
  return &action;
}

EXPORT("song_free") void web_song_free(SongEvents *song) { song_events_free(song); }
