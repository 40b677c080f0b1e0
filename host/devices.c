/* SPDX-License-Identifier: MIT */
/**
 * @file devices.c
 * `tabor devices`: where `tabor play` can be heard.
 */
#include <stdio.h>

#include "command.h"
#include "json_output.h"
#include "portaudio_devices.h"

static json_t *device_json(const OutputDevice *device) {
  return json_pack("{s:o, s:I, s:o, s:o, s:b}", "name", json_text(device->label), "channels",
                   (json_int_t)device->channels, "rate", json_number(device->rate), "latency",
                   json_number(device->latency), "default", device->is_default);
}

static Outcome print_json(void) {
  json_t *const list = json_array();
  OutputDevice device;
  for (uint32_t i = 0; portaudio_output(i, &device); i++) {
    json_array_append_new(list, device_json(&device));
  }
  return json_print(json_pack("{s:o}", "devices", list));
}

static Outcome print_lines(bool quiet) {
  OutputDevice device;
  if (!portaudio_output(0, &device) && !quiet) {
    note("there is no sound output; 'tabor play --backend null' plays without one");
  }
  for (uint32_t i = 0; portaudio_output(i, &device); i++) {
    printf("%s%s: %u channels, %.10g Hz, %.1f ms\n", device.label,
           device.is_default ? " (default)" : "", (unsigned)device.channels, device.rate,
           1000 * device.latency);
  }
  return OUTCOME_OK;
}

static Outcome run(const Arguments *arguments) {
  Outcome outcome = portaudio_start();
  if (outcome != OUTCOME_OK) return outcome;
  outcome = arguments_has(arguments, "json") ? print_json()
                                             : print_lines(arguments_has(arguments, "quiet"));
  portaudio_end();
  return outcome;
}

static const Option options[] = {{0}};

const Command devices_command = {
  .name = "devices",
  .summary = "List the sound outputs",
  .notes = "'tabor play --device NAME' takes a name as listed, its part behind the colon, or the "
           "part before\n"
           "for the first of these. Behind it stand channels, the device's own rate, and the "
           "latency that\n"
           "it promises at least.\n",
  .options = options,
  .run = run,
};
