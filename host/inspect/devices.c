/* SPDX-License-Identifier: MIT */
/**
 * @file devices.c
 * `tabor devices`: lists the audio outputs and MIDI inputs for `tabor play`.
 */
#include <stdio.h>

#include "base/command.h"
#include "base/json_output.h"
#include "midi/midi_port.h"
#include "play/portaudio_devices.h"

static json_t *device_json(const OutputDevice *device) {
  return json_pack("{s:o, s:I, s:o, s:o, s:b}", "name", json_text(device->label), "channels",
                   (json_int_t)device->channels, "rate", json_number(device->rate), "latency",
                   json_number(device->latency), "default", device->is_default);
}

#define MOST_INPUTS 256

/* MIDI inputs, named as tabor play does. */
typedef struct Inputs {
  MidiPortName names[MOST_INPUTS];
  size_t count;
} Inputs;

static void find_inputs(Inputs *inputs) {
  MidiPorts ports;
  midi_ports_begin(&ports);
  inputs->count = midi_ports_list(&ports, inputs->names, MOST_INPUTS);
  midi_ports_end(&ports);
}

static void label_input(const MidiPortName *name, char *label, size_t size) {
  (void)snprintf(label, size, "%s: %s", midi_port_api(name->api), name->text);
}

static json_t *input_json(const MidiPortName *name) {
  char label[2 * MIDI_PORT_NAME];
  label_input(name, label, sizeof label);
  return json_pack("{s:o, s:b}", "name", json_text(label), "default", midi_port_is_hardware(name));
}

static Outcome print_json(const Inputs *inputs) {
  json_t *list = json_array(), *midi = json_array();
  OutputDevice device;
  for (uint32_t i = 0; portaudio_output(i, &device); i++) {
    list = json_with_item(list, device_json(&device));
  }
  for (size_t i = 0; i < inputs->count; i++) {
    midi = json_with_item(midi, input_json(&inputs->names[i]));
  }
  return json_print(json_pack("{s:o, s:o}", "devices", list, "midi_inputs", midi));
}

static void print_inputs(const Inputs *inputs) {
  for (size_t i = 0; i < inputs->count; i++) {
    char label[2 * MIDI_PORT_NAME];
    label_input(&inputs->names[i], label, sizeof label);
    printf("%s%s: MIDI input\n", label,
           midi_port_is_hardware(&inputs->names[i]) ? " (default)" : "");
  }
}

static Outcome print_lines(const Inputs *inputs, bool quiet) {
  OutputDevice device;
  if (!portaudio_output(0, &device) && !quiet) {
    note("there is no sound output; 'tabor play --backend null' plays without one");
  }
  for (uint32_t i = 0; portaudio_output(i, &device); i++) {
    printf("%s%s: %u channels, %.10g Hz, %.1f ms\n", device.label,
           device.is_default ? " (default)" : "", (unsigned)device.channels, device.rate,
           1000 * device.latency);
  }
  print_inputs(inputs);
  return OUTCOME_OK;
}

static Outcome run(const Arguments *arguments) {
  Inputs inputs;
  Outcome outcome = portaudio_start();
  if (outcome != OUTCOME_OK) return outcome;
  find_inputs(&inputs);
  outcome = arguments_has(arguments, "json")
              ? print_json(&inputs)
              : print_lines(&inputs, arguments_has(arguments, "quiet"));
  portaudio_end();
  return outcome;
}

static const Option options[] = {{0}};

const Command devices_command = {
  .name = "devices",
  .summary = "List the sound outputs and MIDI inputs",
  .notes =
    "'tabor play --device NAME' takes a name as listed, its part behind the colon, or the "
    "part before\n"
    "for the first of these. Behind it stand channels, the device's own rate, and the "
    "latency that\n"
    "it promises at least. MIDI inputs are for 'tabor play --midi-in NAME', which takes any part\n"
    "of what stands behind the colon; without it all that are marked as default are heard.\n",
  .options = options,
  .run = run,
};
