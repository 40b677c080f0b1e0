/* SPDX-License-Identifier: MIT */
#include "midi/midi_options.h"

#include "base/suggest.h"
#include "drums/drum_args.h"
#include "midi/midi_map_file.h"

static Outcome check_strikers(const char *path, const TaborDrumDef *def, const MidiMap *map) {
  for (int i = 0; i < MIDI_VALUES; i++) {
    const char *const name = map->notes[i].striker;
    if (!*name || tabor_drum_def_find_striker(def, name) >= 0) continue;
    char hint[512];
    suggest_choice(hint, sizeof hint, name, "", drum_striker_name, def);
    return refuse("%s: [note.%d] striker '%s': the drum has no such striker%s", path, i, name,
                  hint);
  }
  return OUTCOME_OK;
}

static Outcome read_file(const char *path, const TaborDrumDef *def, MidiMap *map) {
  if (!*path) return refuse("--midi-map needs the name of a file");
  const Outcome outcome = midi_map_file_read(path, map);
  return outcome == OUTCOME_OK ? check_strikers(path, def, map) : outcome;
}

Outcome midi_response_read(const Arguments *arguments, MidiResponse *response) {
  const char *const curve = arguments_value(arguments, "velocity-curve");
  const char *const range = arguments_value(arguments, "velocity-range");
  Outcome outcome = OUTCOME_OK;
  if (curve) outcome = midi_curve_read("--velocity-curve", curve, &response->curve);
  if (outcome == OUTCOME_OK && range) {
    outcome = midi_range_read("--velocity-range", range, &response->range);
  }
  return outcome;
}

Outcome midi_map_read(const Arguments *arguments, const TaborDrumDef *def, MidiMap *map) {
  const char *const path = arguments_value(arguments, "midi-map");
  const char *const channel = arguments_value(arguments, "midi-channel");
  Outcome outcome = OUTCOME_OK;
  midi_map_default(map);
  if (path) outcome = read_file(path, def, map);
  if (outcome == OUTCOME_OK && channel) {
    outcome = midi_channel_read("--midi-channel", channel, &map->channel);
  }
  return outcome == OUTCOME_OK ? midi_response_read(arguments, &map->response) : outcome;
}
