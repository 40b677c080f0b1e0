/* SPDX-License-Identifier: MIT */
#include "midi/midi_map.h"

#include <math.h>
#include <string.h>

const char *const midi_stroke_names[] = {"none",   "head",  "rimshot", "cross-stick", "rim",
                                         "buzz",   "sweep", "bell",    "bow",         "edge",
                                         "closed", "open",  "pedal",   NULL};

static void map_note(MidiMap *map, uint8_t note, MidiStroke stroke) {
  map->notes[note].stroke = stroke;
}

static void map_notes(MidiMap *map) {
  static const uint8_t heads[] = {36, 38, 41, 43, 45, 47, 48, 50};
  for (int note = 0; note < MIDI_VALUES; note++) {
    map->notes[note] = (MidiNote){.radius = NAN, .angle = NAN, .speed = 1};
  }
  for (size_t i = 0; i < sizeof heads; i++) map_note(map, heads[i], MIDI_STROKE_HEAD);
  map->notes[36].radius = 0;
  map_note(map, 37, MIDI_STROKE_CROSS_STICK);
  map_note(map, 39, MIDI_STROKE_RIM);
  map_note(map, 40, MIDI_STROKE_RIMSHOT);
  map_note(map, 42, MIDI_STROKE_CLOSED);
  map_note(map, 44, MIDI_STROKE_PEDAL);
  map_note(map, 46, MIDI_STROKE_OPEN);
}

static void map_controls(MidiMap *map) {
  static const struct {
    uint8_t controller;
    MidiTarget target;
  } rows[] = {
    {1, MIDI_TARGET_GRIP},    {7, MIDI_TARGET_GAIN},      {11, MIDI_TARGET_GAIN},
    {16, MIDI_TARGET_RADIUS}, {17, MIDI_TARGET_ANGLE},    {20, MIDI_TARGET_STRAINER},
    {4, MIDI_TARGET_OPENING}, {120, MIDI_TARGET_SILENCE}, {123, MIDI_TARGET_SILENCE},
  };
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    map->controls[rows[i].controller].target = rows[i].target;
  }
}

void midi_map_default(MidiMap *map) {
  memset(map, 0, sizeof *map);
  map->response = midi_response_default;
  map->channel = MIDI_OMNI;
  map->pressure = map->programs = true;
  map_notes(map);
  map_controls(map);
}
