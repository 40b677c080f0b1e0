/* SPDX-License-Identifier: MIT */
#include "kit/kit_options.h"

#include <stdio.h>
#include <string.h>

#include "base/suggest.h"
#include "midi/midi_map_file.h"
#include "midi/midi_options.h"

#define LAST_CONTROLLER 119 /* those above are channel mode messages */

static const char *map_name(const void *list, size_t index) {
  (void)list;
  return index < kit_map_count ? kit_maps[index].name : NULL;
}

/* The whole list, also when one name is near: it is short. */
static Outcome read_map(const char *name, const KitMap **map) {
  char names[128] = "", hint[128];
  size_t length = 0;
  *map = kit_map_find(name);
  if (*map) return OUTCOME_OK;
  for (size_t i = 0; i < kit_map_count; i++) {
    length += (size_t)snprintf(names + length, sizeof names - length, "%s%s", i > 0 ? ", " : "",
                               kit_maps[i].name);
  }
  suggest_hint(hint, sizeof hint, name, "", map_name, NULL);
  return refuse("--map '%.80s': unknown%s; there are: %s", name, hint, names);
}

static Outcome read_controller(const char *text, size_t length, uint8_t *controller) {
  static const NumberField field = {"--place-cc", 0, LAST_CONTROLLER, true};
  char part[32] = "";
  double number = 0;
  if (length >= sizeof part) return refuse("--place-cc '%.80s': not a controller", text);
  memcpy(part, text, length);
  const Outcome outcome = number_read(&field, part, &number);
  if (outcome == OUTCOME_OK) *controller = (uint8_t)number;
  return outcome;
}

/* "16,18", or "16" for the snare drum alone. */
static Outcome read_places(const char *text, KitMidiSetup *setup) {
  const size_t length = strcspn(text, ",");
  const Outcome outcome = read_controller(text, length, &setup->snare_place);
  if (outcome != OUTCOME_OK || text[length] == '\0') return outcome;
  return read_controller(text + length + 1, strlen(text + length + 1), &setup->toms_place);
}

Outcome kit_midi_setup_read(const Arguments *arguments, KitMidiSetup *setup) {
  const char *const map = arguments_value(arguments, "map");
  const char *const places = arguments_value(arguments, "place-cc");
  const char *const channel = arguments_value(arguments, "midi-channel");
  *setup = kit_midi_setup_default;
  if (places && !map) return refuse("--place-cc needs --map");
  Outcome outcome = midi_response_read(arguments, &setup->response);
  if (outcome == OUTCOME_OK && channel) {
    outcome = midi_channel_read("--midi-channel", channel, &setup->channel);
  }
  if (outcome == OUTCOME_OK && map) outcome = read_map(map, &setup->map);
  if (outcome == OUTCOME_OK && places) outcome = read_places(places, setup);
  return outcome;
}

Outcome kit_options_refuse(const Arguments *arguments) {
  static const char *const names[] = {"map", "place-cc"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    if (!arguments_has(arguments, names[i])) continue;
    return refuse("--%s needs --kit; a single drum has --midi-map FILE", names[i]);
  }
  return OUTCOME_OK;
}
