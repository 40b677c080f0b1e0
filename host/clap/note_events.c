/* SPDX-License-Identifier: MIT */
#include "clap/note_events.h"

#include <math.h>

#include "midi/midi_map.h"

#define LOWER_BITS 128 /* steps of controller 88 within one of the velocity */

enum { RADIUS_CONTROLLER = 16 };

static uint8_t channel_of(int16_t channel) { return channel < 0 ? 0 : (uint8_t)channel & 0x0Fu; }

static bool is_key(int16_t key) { return key >= 0 && key < MIDI_VALUES; }

/* 0 to 1 as 0 to 127. */
static uint8_t of_seven_bits(double value) {
  return (uint8_t)lrint(fmin(fmax(value, 0), 1) * (MIDI_VALUES - 1));
}

/* A velocity of 0 is a stroke here, the softest; in MIDI it would be a note off. */
static uint32_t note_on(const clap_event_note_t *note, MidiMessage *messages) {
  const double steps = (MIDI_VALUES - 1) * LOWER_BITS;
  const uint8_t channel = channel_of(note->channel);
  if (!is_key(note->key) || isnan(note->velocity)) return 0;
  const long fine = lrint(fmin(fmax(note->velocity * steps, LOWER_BITS), steps));
  const uint8_t lower = (uint8_t)(fine % LOWER_BITS);
  MidiMessage *next = messages;
  if (lower > 0) {
    *next++ = (MidiMessage){MIDI_CONTROL | channel, {MIDI_HIGH_RESOLUTION_PREFIX, lower}};
  }
  *next++ =
    (MidiMessage){MIDI_NOTE_ON | channel, {(uint8_t)note->key, (uint8_t)(fine / LOWER_BITS)}};
  return (uint32_t)(next - messages);
}

static uint32_t note_off(const clap_event_note_t *note, MidiMessage *message) {
  if (!is_key(note->key)) return 0;
  *message = (MidiMessage){MIDI_NOTE_OFF | channel_of(note->channel), {(uint8_t)note->key, 64}};
  return 1;
}

static uint32_t expression(const clap_event_note_expression_t *moved, MidiMessage *message) {
  const uint8_t channel = channel_of(moved->channel);
  if (isnan(moved->value)) return 0;
  const uint8_t value = of_seven_bits(moved->value);
  if (moved->expression_id == CLAP_NOTE_EXPRESSION_BRIGHTNESS) {
    *message = (MidiMessage){MIDI_CONTROL | channel, {RADIUS_CONTROLLER, value}};
  } else if (moved->expression_id != CLAP_NOTE_EXPRESSION_PRESSURE) {
    return 0;
  } else if (is_key(moved->key)) {
    *message = (MidiMessage){MIDI_POLY_PRESSURE | channel, {(uint8_t)moved->key, value}};
  } else {
    *message = (MidiMessage){MIDI_CHANNEL_PRESSURE | channel, {value, 0}};
  }
  return 1;
}

static uint32_t midi(const clap_event_midi_t *event, MidiMessage *message) {
  MidiStream stream = {0};
  for (uint32_t i = 0; i < sizeof event->data; i++) {
    if (midi_stream_take(&stream, event->data[i], message)) return 1;
  }
  return 0;
}

bool note_event_is_choke(const clap_event_header_t *event) {
  return event->space_id == CLAP_CORE_EVENT_SPACE_ID && event->type == CLAP_EVENT_NOTE_CHOKE;
}

void note_event_choke(const clap_event_header_t *event, uint32_t number,
                      uint32_t choked[MIDI_VALUES]) {
  if (!note_event_is_choke(event)) return;
  const int16_t key = ((const clap_event_note_t *)event)->key;
  for (int i = 0; i < MIDI_VALUES; i++) {
    if (!is_key(key) || i == key) choked[i] = number;
  }
}

uint32_t note_event_messages(const clap_event_header_t *event,
                             MidiMessage messages[NOTE_EVENT_MESSAGES]) {
  if (event->space_id != CLAP_CORE_EVENT_SPACE_ID) return 0;
  switch (event->type) {
  case CLAP_EVENT_NOTE_ON: return note_on((const clap_event_note_t *)event, messages);
  case CLAP_EVENT_NOTE_OFF: return note_off((const clap_event_note_t *)event, messages);
  case CLAP_EVENT_NOTE_EXPRESSION:
    return expression((const clap_event_note_expression_t *)event, messages);
  case CLAP_EVENT_MIDI: return midi((const clap_event_midi_t *)event, messages);
  default: return 0;
  }
}
