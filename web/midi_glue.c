/* SPDX-License-Identifier: MIT */
/**
 * @file midi_glue.c
 * What drum_take_midi() and kit_take_midi() have in common. Messages are converted by the program's own map (host/midi), so
 * that the page plays a note as `tabor render --midi-file` does.
 */
#include "glue.h"

MidiMessage web_midi_message(uint32_t status, uint32_t first, uint32_t second) {
  return (MidiMessage){.status = (uint8_t)status, .data = {first & 0x7F, second & 0x7F}};
}

WebMidiAction web_midi_action(uint32_t drum, const TaborEvent *event) {
  WebMidiAction action = {.kind = WEB_MIDI_NOTHING, .drum = drum};
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
